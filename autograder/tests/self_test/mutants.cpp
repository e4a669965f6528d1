// Mutation testing: compiles and judges small changes to right answers in plain style (the
// alternatives of a lab), one by one; a check should fail each of them. A mutant with the same
// program, byte for byte, is equivalent; whether a survivor is, a reader decides. Prints the
// survivors and the score: for use before a release.

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <map>
#include <regex>
#include <tuple>

#include <fmt/format.h>

#include "common/rng.hpp"
#include "judge/base/errors.hpp"
#include "judge/base/text_file.hpp"
#include "judge/judging/judge.hpp"
#include "judge/submission/compile.hpp"
#include "tests/self_test/proof.hpp"

namespace mc::self_test {

namespace {

/// One small change to C++ source text, similar to a student's slip: replaces `length` characters
/// at `offset` by `replacement`.
struct Mutation {
  std::size_t offset, length;
  std::string replacement;
};

enum class Kind { word, number, symbol };

struct Token {
  Kind kind;
  std::size_t offset;
  std::string_view text;
  int depth;  ///< number of enclosing braces
};

std::vector<Token> tokens_of(std::string_view source) {
  static const std::regex pattern(
      R"re((//[^\n]*|#[^\n]*|/\*[^]*?\*/|"(?:[^"\\]|\\[^])*"|'(?:[^'\\]|\\[^])*'))re"
      R"re(|(\d(?:[ep][+-]|[\w.'])*)|(\w+))re"
      R"re(|(<<=|>>=|<=>|\.\.\.|::|->|\+\+|--|<<|>>|&&|\|\||[-<>=!+*/%&|^]=|\S))re");
  std::vector<Token> tokens;
  int depth = 0;
  for (std::cregex_iterator found(source.begin(), source.end(), pattern), end; found != end;
       ++found) {
    const std::cmatch& match = *found;
    if (match[1].matched) continue;  // a comment, a preprocessor line, a string, a character
    const Kind kind = match[2].matched   ? Kind::number
                      : match[3].matched ? Kind::word
                                         : Kind::symbol;
    const std::string_view text(match[0].first, static_cast<std::size_t>(match.length()));
    if (text == "}") --depth;
    tokens.push_back({kind, static_cast<std::size_t>(match.position()), text, depth});
    if (text == "{") ++depth;
  }
  return tokens;
}

/// `a + b`, `a += b`: not a sign, a pointer or a template.
bool is_between_spaces(std::string_view source, const Token& token) {
  const std::size_t end = token.offset + token.text.size();
  return token.offset > 0 && end < source.size() && source[token.offset - 1] == ' ' &&
         (source[end] == ' ' || source[end] == '\n');
}

constexpr std::pair<std::string_view, std::string_view> exchanges[] = {
    {"+", "-"},   {"-", "+"},   {"*", "/"},     {"/", "*"},    {"%", "/"},   {"<", "<="},
    {"<=", "<"},  {">", ">="},  {">=", ">"},    {"==", "!="},  {"!=", "=="}, {"&&", "||"},
    {"||", "&&"}, {"<<", ">>"}, {">>", "<<"},   {"&", "|"},    {"|", "&"},   {"^", "|"},
    {"+=", "-="}, {"-=", "+="}, {"*=", "/="},   {"/=", "*="},  {"<", ">"},   {">", "<"},
    {"+=", "="},  {"^=", "|="}, {"<<=", ">>="}, {">>=", "<<="}};

void add_constants(const Token& token, std::vector<Mutation>& all) {
  std::uint64_t whole = 0;
  const char* const end = token.text.data() + token.text.size();
  const auto [rest, error] = std::from_chars(token.text.data(), end, whole);
  if (error == std::errc() && (rest == end || *rest == 'u')) {
    const std::string suffix(rest, end);
    all.push_back({token.offset, token.text.size(), std::to_string(whole + 1) + suffix});
    if (whole > 0) {
      all.push_back({token.offset, token.text.size(), std::to_string(whole - 1) + suffix});
    }
  } else if (token.text.find_first_of(token.text.starts_with("0x") ? "p" : ".e") !=
             std::string_view::npos) {
    all.push_back({token.offset, token.text.size(), fmt::format("(1.5 * {})", token.text)});
  }
}

/// The token that closes the bracket at `open`.
std::size_t closing(const std::vector<Token>& tokens, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < tokens.size(); ++i) {
    const std::string_view text = tokens[i].text;
    if (text == "(" || text == "[" || text == "{") ++depth;
    if (text == ")" || text == "]" || text == "}") --depth;
    if (depth == 0) return i;
  }
  return tokens.size() - 1;
}

/// if (c) to if (!(c)); f(a, b) to f(b, a); static_cast<T>(x) to (x).
void add_brackets(const std::vector<Token>& tokens, std::size_t i, std::vector<Mutation>& all) {
  if (tokens[i].text != "(" || i == 0) return;
  const std::size_t close = closing(tokens, i);
  const std::string_view before = tokens[i - 1].text;
  if (before == "if" || before == "while") {
    const std::size_t length = tokens[close].offset + 1 - tokens[i].offset;
    all.push_back({tokens[i].offset, length,
                   fmt::format("(!{})", std::string_view(tokens[i].text.data(), length))});
  }
  const bool is_pair = close == i + 4 && tokens[i + 2].text == "," &&
                       tokens[i + 1].kind != Kind::symbol && tokens[i + 3].kind != Kind::symbol;
  const bool is_symmetric =
      before == "min" || before == "max" || before == "toroidal_distance_squared";
  if (is_pair && tokens[i - 1].kind == Kind::word && !is_symmetric) {
    const std::size_t start = tokens[i].offset;
    all.push_back({start, tokens[close].offset + 1 - start,
                   fmt::format("({}, {})", tokens[i + 3].text, tokens[i + 1].text)});
  }
  if (before == ">" && i >= 4 && tokens[i - 4].text == "static_cast") {
    all.push_back({tokens[i - 4].offset, tokens[i].offset - tokens[i - 4].offset, ""});
  }
}

/// Statements without a declaration are removed: from after `;`, `{`, `}` or `)` to `;`.
void add_removals(const std::vector<Token>& tokens, std::size_t i, std::vector<Mutation>& all) {
  const std::string_view before = tokens[i - 1].text;
  if (before != ";" && before != "{" && before != "}") return;
  std::size_t end = i;
  int depth = 0;
  for (; end < tokens.size(); ++end) {
    const std::string_view text = tokens[end].text;
    if (text == "{" || text == "}") return;
    depth += text == "(" ? 1 : text == ")" ? -1 : 0;
    if (depth < 0) return;  // the header of a for loop
    if (text == ";" && depth == 0) break;
  }
  const std::string_view first = tokens[i].text;
  const bool declares = end > i + 1 && tokens[i + 1].kind == Kind::word;  // double sum
  if (end == tokens.size() || end == i || declares || tokens[i].kind != Kind::word) return;
  for (const std::string_view word : {"return", "using", "for", "else", "struct", "const", "auto",
                                      "std", "static", "constexpr", "namespace", "public"}) {
    if (first == word) return;
  }
  if (end > i + 2 && tokens[i + 2].text == "reserve") return;
  const std::size_t start = tokens[i].offset;
  all.push_back({start, tokens[end].offset + 1 - start, ";"});
}

/// Whether the line around `offset` computes a hash. Any other hash would be as right.
bool computes_a_hash(std::string_view source, std::size_t offset) {
  const std::size_t start = source.rfind('\n', offset) + 1;
  const std::string_view line = source.substr(start, source.find('\n', offset) - start);
  return line.find("hash(") != line.npos || line.find("mix_bits(") != line.npos;
}

/// Whether the type at `i` is that of a cast or of a loop's counter. Measurements are too short to
/// count beyond what a float or 32 bits hold exactly.
bool only_counts(const std::vector<Token>& tokens, std::size_t i) {
  if (tokens[i - 1].text == "::") i = i >= 2 ? i - 2 : 0;
  const std::string_view before = i >= 1 ? tokens[i - 1].text : "";
  const bool in_cast = before == "<" && i >= 2 && tokens[i - 2].text == "static_cast";
  const bool is_counter = before == "(" && i >= 2 && tokens[i - 2].text == "for";
  return in_cast || is_counter || tokens[i + 1].text == "(";
}

/// Whether the number at `i` is the initial value of a member (`std::size_t next_ = 0;`). Some call
/// sets it before it is used.
bool is_initial_value(const std::vector<Token>& tokens, std::size_t i) {
  return i >= 3 && tokens[i - 1].text == "=" && tokens[i - 2].text.ends_with('_') &&
         (tokens[i - 3].kind == Kind::word || tokens[i - 3].text == ",");
}

/// All mutations of the code between braces: operators and comparisons exchanged, constants plus
/// and minus one, conditions negated, casts dropped, double to float, 64 to 32 bits, statements
/// removed, arguments exchanged, `static` added. Comments, strings and preprocessor lines stay.
/// The spaces that clang-format sets distinguish tokens: `a < b` compares, `span<double>` does not.
std::vector<Mutation> mutations_of(std::string_view source) {
  const std::vector<Token> tokens = tokens_of(source);
  std::vector<Mutation> all;
  for (std::size_t i = 1; i + 1 < tokens.size(); ++i) {
    const Token& token = tokens[i];
    if (token.depth < 2) continue;  // in a function in a namespace
    if (computes_a_hash(source, token.offset)) continue;
    const auto replace = [&](std::string_view text) {
      all.push_back({token.offset, token.text.size(), std::string(text)});
    };
    if (token.kind == Kind::symbol && is_between_spaces(source, token)) {
      for (const auto& [from, to] : exchanges) {
        if (token.text == from) replace(to);
      }
    }
    if (token.text == "++") replace("--");
    if (token.kind == Kind::number && !is_initial_value(tokens, i)) add_constants(token, all);
    const bool follows_colons = tokens[i - 1].text == "::";
    if (!only_counts(tokens, i)) {
      if (token.text == "double" && !follows_colons) replace("float");
      if (follows_colons && token.text == "uint64_t") replace("uint32_t");
    }
    const bool starts = tokens[i - 1].text == ";" || tokens[i - 1].text == "{";
    if (starts && (token.text == "double" || token.text == "bool")) {
      all.push_back({token.offset, 0, "static "});
    }
    if (token.text == "true") replace("false");
    if (token.text == "false") replace("true");
    add_brackets(tokens, i, all);
    add_removals(tokens, i, all);
  }
  return all;
}

/// The source with one mutation.
std::string mutated(std::string_view source, const Mutation& mutation) {
  return std::string(source.substr(0, mutation.offset)) + mutation.replacement +
         std::string(source.substr(mutation.offset + mutation.length));
}

/// The line that a mutation changes, before and after, without indentation: "a + b; => a - b;".
std::string description(std::string_view source, const Mutation& mutation) {
  const std::size_t start = source.rfind('\n', mutation.offset) + 1;
  const std::size_t end =
      std::min(source.size(), source.find('\n', mutation.offset + mutation.length));
  const auto words = [](std::string_view line) {  // without indentation, with single spaces
    static const std::regex indentation("^\\s+"), spaces("\\s+");
    const std::string text = std::regex_replace(std::string(line), indentation, "");
    return std::regex_replace(text, spaces, " ");
  };
  const std::string after = mutated(source, mutation);
  const std::size_t new_end = end + mutation.replacement.size() - mutation.length;
  return fmt::format("{} => {}", words(source.substr(start, end - start)),
                     words(std::string_view(after).substr(start, new_end - start)));
}

struct Mutant {
  std::string file;  ///< below autograder/submissions
  Mutation mutation;
  std::string words;  ///< "alternatives/variance/x.cpp: a; => b;"
};

/// What `f` returns; a busy machine, where a compiler or a check runs out of time, is asked again.
template <class Function>
auto patiently(Function f) {
  for (int attempt = 1; attempt < 5; ++attempt) {
    try {
      return f();
    } catch (const MachineError&) {
      continue;
    }
  }
  return f();
}

/// Builds a program of this source text, if it compiles.
void build(Proof& proof, const std::string& source) {
  const fs::path file = proof.layout.build / "mutants" / proof.lab.name / proof.lab.file();
  fs::create_directories(file.parent_path());
  write_text(file, source);
  proof.submission = single_file_submission(proof.layout, proof.labs, proof.lab, file, true);
  proof.built = patiently([&] { return build_program(proof.layout, proof.lab, proof.submission); });
}

/// The first check that fails; empty if all pass.
std::string killer_of(const Proof& proof, std::uint64_t seed) {
  JudgeOptions options;
  options.seed = seed;
  options.first = true;
  return patiently([&]() -> std::string {
    for (const CheckResult& result :
         judge_lab(proof.layout, proof.lab, proof.built, options).checks) {
      if (result.status == Status::failed) return result.check.name;
      if (result.status == Status::not_judged || result.status == Status::internal_error) {
        throw MachineError(result.check.name + ": " + result.report);
      }
    }
    return {};
  });
}

}  // namespace

void prove_by_mutants(const std::string& name, std::size_t count, std::uint64_t seed) {
  Proof proof;
  proof.lab = find_lab(proof.labs, name);
  precompile_headers(proof.layout);
  std::map<std::string, std::string> sources, programs;
  std::vector<Mutant> mutants;
  for (const auto& entry :
       fs::directory_iterator(proof.layout.submissions() / "alternatives" / proof.lab.name)) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string file = fs::relative(entry.path(), proof.layout.submissions()).string();
    sources[file] = read_text(entry.path());
    for (const Mutation& mutation : mutations_of(sources[file])) {
      mutants.push_back(
          {file, mutation, fmt::format("{}: {}", file, description(sources[file], mutation))});
    }
  }
  std::sort(mutants.begin(), mutants.end(), [](const Mutant& a, const Mutant& b) {
    return std::tie(a.file, a.mutation.offset, a.mutation.replacement) <
           std::tie(b.file, b.mutation.offset, b.mutation.replacement);
  });
  mc::Rng rng(seed);
  for (std::size_t i = mutants.size(); i > 1; --i) std::swap(mutants[i - 1], mutants[rng() % i]);
  std::size_t killed = 0, survived = 0, same = 0, broken = 0;
  for (const Mutant& mutant : mutants) {
    if (killed + survived >= count) break;
    const std::string& source = sources[mutant.file];
    if (!programs.contains(mutant.file)) {
      build(proof, source);
      if (!proof.built.program) return complain(mutant.file + ": " + proof.built.failure);
      programs[mutant.file] = read_text(proof.built.program->path);
    }
    build(proof, mutated(source, mutant.mutation));
    if (!proof.built.program) {
      ++broken;
    } else if (read_text(proof.built.program->path) == programs[mutant.file]) {
      ++same;
    } else if (const std::string killer = killer_of(proof, seed); killer.empty()) {
      ++survived;
      fmt::print("survived  {}\n", mutant.words);
    } else {
      ++killed;
      if (std::getenv("MC_VERBOSE") != nullptr) {
        fmt::print("killed    {}\n          by {}\n", mutant.words, killer);
      }
    }
    std::fflush(stdout);
  }
  fmt::print(
      "{}: {} of {} mutants killed, {:.1f} %; not counted: {} with the "
      "same program, {} that do not compile; {} mutations in all\n",
      proof.lab.name, killed, killed + survived,
      100.0 * static_cast<double>(killed) /
          static_cast<double>(std::max<std::size_t>(1, killed + survived)),
      same, broken, mutants.size());
}

}  // namespace mc::self_test
