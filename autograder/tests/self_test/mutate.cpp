#include "tests/self_test/mutate.hpp"

#include <algorithm>
#include <charconv>
#include <regex>
#include <utility>

#include <fmt/format.h>

namespace mc::self_test {
namespace {

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

}  // namespace

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

std::string mutated(std::string_view source, const Mutation& mutation) {
  return std::string(source.substr(0, mutation.offset)) + mutation.replacement +
         std::string(source.substr(mutation.offset + mutation.length));
}

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

}  // namespace mc::self_test
