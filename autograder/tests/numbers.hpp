#pragma once
// Numbers in documents, and the commands that print them. A document says which command prints a
// number in one of these ways:
//
//   a block that shows it             $ ./lab run halton radical_inverse 2 6
//     and what it prints, exactly     # index  x
//                                     6        0.375
//   a comment before the passage      <!-- ./lab run halton radical_inverse 2 6 = 3/8
//     with the numbers                     ./lab run halton radical_inverse 2 3 = 0.75 -->
//   the same for cells of tables      <!-- ./lab bench halton --tables:
//                                          TITLE | ROW | COLUMN = 47
//                                          TITLE | ROW | COLUMN = 62 -->
//
//   the same for the data of plots    <!-- ./lab plot halton solutions:
//     (times excepted, which vary)         FILE | ROW | COLUMN = 0.0134 -->
//   tables that a command writes: output_blocks() in numbers_test.cpp
//
// A passage ends at an empty line. Several numbers, separated by ", ", are printed in this order.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "grader/base/replace.hpp"
#include "tests/documents.hpp"

namespace mc::tests {

/// A number in a document, and half a unit of its last digit.
struct WrittenNumber {
  double value = 0, half_unit = 0;
};

/// "3/8", "−170.7", "36.5 %", "0.5", "1,024", "4.2 · 2⁻⁵³", "4.2 \cdot 2^{-53}", "5.9e-5", "10³⁰⁸";
/// nothing if it is not a number.
inline std::optional<WrittenNumber> number_of(std::string text) {
  text = with_replacements(
      text, {{"\\cdot", "*"}, {"·", "*"},   {"{", ""},    {"}", ""},    {"−", "-"},  {",", ""},
             {" ", ""},       {"½", "1/2"}, {"¼", "1/4"}, {"¾", "3/4"}, {"⁰", "^0"}, {"¹", "^1"},
             {"²", "^2"},     {"³", "^3"},  {"⁴", "^4"},  {"⁵", "^5"},  {"⁶", "^6"}, {"⁷", "^7"},
             {"⁸", "^8"},     {"⁹", "^9"},  {"⁻", "^-"}});
  for (std::string before; before != text;) {  // "10^3^0^8" is 10^308
    before = text;
    text = std::regex_replace(text, std::regex(R"((\^[-0-9]+)\^)"), "$1");
  }
  static const std::regex number(
      R"(([-+]?\d+(?:\.(\d*))?(?:e([-+]?\d+))?)(?:/(\d+))?(?:(?:\*(\d+))?\^(-?\d+))?(%?))");
  std::smatch part;
  if (!std::regex_match(text, part, number)) return {};
  const auto value_of = [&](int i, double otherwise) {
    return part[i].length() > 0 ? std::stod(part[i]) : otherwise;
  };
  double value = value_of(1, 0) / value_of(4, 1);
  double half = 0.5 * std::pow(10, value_of(3, 0) - static_cast<double>(part[2].length()));
  if (part[6].matched && !part[5].matched) {  // 10³⁰⁸
    value = std::pow(value, value_of(6, 0));
  } else if (part[6].matched) {
    value *= std::pow(value_of(5, 0), value_of(6, 0));
    half *= std::pow(value_of(5, 0), value_of(6, 0));
  }
  const bool is_exact = part[4].matched || (part[6].matched && !part[5].matched);
  const double unit = part[7].length() > 0 ? 0.01 : 1;
  return WrittenNumber{value * unit, is_exact ? 0 : half * unit};
}

/// Is this number the printed one, rounded to its digits? It must not have more digits.
inline bool agree(const WrittenNumber& number, const WrittenNumber& printed) {
  const double rounding = 1e-15 * std::abs(printed.value);
  return std::abs(number.value - printed.value) <= number.half_unit * (1 + 1e-9) + rounding;
}

/// Is this number in the text, not as a part of a longer number?
inline bool contains_number(const std::string& text, const std::string& number) {
  const auto digit = [&](std::size_t at) {
    return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at]));
  };
  const auto part = [&](std::size_t at) { return at < text.size() && text[at] == '.'; };
  for (std::size_t at = text.find(number); at != std::string::npos;
       at = text.find(number, at + 1)) {
    const std::size_t end = at + number.size();
    const bool begins = at == 0 || !(digit(at - 1) || (part(at - 1) && digit(at)));
    if (begins && !digit(end) && !(part(end) && digit(end + 1))) return true;
  }
  return false;
}

/// A comment that names the source of the numbers in the passage below it.
struct Claim {
  Words words;       ///< ./lab run …
  std::string cell;  ///< of a table, "TITLE | ROW | COLUMN", or nothing
  Words numbers;     ///< as written in the passage
  std::string passage;
};

inline std::vector<Claim> claims_in(const std::string& document) {
  std::vector<Claim> claims;
  constexpr std::string_view opening = "<!-- ", closing = "-->";
  for (std::size_t at = document.find("<!-- ./lab "); at != std::string::npos;
       at = document.find("<!-- ./lab ", at + 1)) {
    const auto end = document.find(closing, at);
    const auto after = std::min(end + closing.size() + 1, document.size());
    const std::string rest = without_comments(document.substr(after));
    const std::string passage = with_replacements(rest.substr(0, rest.find("\n\n")), {{"\n", " "}});
    const auto first = at + opening.size();
    std::istringstream lines(document.substr(first, end - first));
    Words bench;
    for (std::string line; std::getline(lines, line);) {
      line.erase(0, line.find_first_not_of(' '));
      while (line.ends_with(' ')) line.pop_back();
      if (line.ends_with(':')) {  // cells follow
        bench = words_of(line.substr(0, line.size() - 1));
        continue;
      }
      Claim claim{bench, "", {}, passage};
      const auto equals = std::min(line.rfind(" = "), line.size());
      for (auto from = equals + 3; from < line.size();) {
        const auto to = std::min(line.find(", ", from), line.size());
        claim.numbers.push_back(line.substr(from, to - from));
        from = to + 2;
      }
      line.resize(equals);
      if (bench.empty()) claim.words = words_of(line);
      if (!bench.empty()) claim.cell = line;
      claims.push_back(claim);
    }
  }
  return claims;
}

/// What is wrong with a claim about these numbers; empty if it is right.
inline std::string objection(const Claim& claim, const Words& printed) {
  if (claim.numbers.empty()) return "no number";
  std::size_t next = 0;
  for (const std::string& number : claim.numbers) {
    const auto value = number_of(number);
    if (!value) return "no number: " + number;
    if (!contains_number(claim.passage, number)) return "not in the passage: " + number;
    for (;; ++next) {
      if (next == printed.size()) return "not printed, or not in this order: " + number;
      const auto there = number_of(printed[next]);
      if (there && agree(*value, *there)) break;
    }
    ++next;
  }
  return {};
}

/// The numbers that a command prints, without the lines that describe them.
inline Words numbers_in(const std::string& output) {
  Words numbers;
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream words(line);
    for (std::string word; words >> word;) numbers.push_back(word);
  }
  return numbers;
}

/// The cells of printed tables, by "TITLE | ROW | COLUMN".
inline std::map<std::string, std::string> cells_in(const std::string& tables) {
  std::map<std::string, std::string> cells;
  const auto split = [](const std::string& line) {  // "| a | b |"
    static const std::regex cell(R"(\| ?(.*?) ?(?=\|))");
    return Words{std::sregex_token_iterator(line.begin(), line.end(), cell, 1), {}};
  };
  std::string title;
  Words columns;
  std::istringstream lines(tables);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("|---")) continue;
    if (!line.starts_with("|")) {
      if (!line.empty()) title = line.substr(0, line.find(" (±"));
      columns.clear();
    } else if (const auto parts = split(line); columns.empty()) {
      columns = parts;
    } else {
      for (std::size_t i = 1; i < parts.size() && i < columns.size(); ++i) {
        cells[fmt::format("{} | {} | {}", title, parts[0], columns[i])] = parts[i];
      }
    }
  }
  return cells;
}

/// A command and its output, shown in a block.
struct Transcript {
  Words words;
  std::string output;
};

inline std::vector<Transcript> transcripts_of(const std::string& document) {
  std::vector<Transcript> all;
  bool inside = false;  // below a prompt, until the block ends
  std::istringstream lines(document);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) {
      inside = false;
    } else if (line.starts_with(std::string(prompt) + "./lab ")) {
      all.push_back({words_of(line.substr(prompt.size())), ""});
      inside = true;
    } else if (inside) {
      all.back().output += line + '\n';
    }
  }
  return all;
}

}  // namespace mc::tests
