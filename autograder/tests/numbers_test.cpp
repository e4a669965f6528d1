// The numbers in handouts are those that commands print (tests/numbers.hpp).
#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "tests/documents.hpp"
#include "tests/numbers.hpp"
#include "tests/submissions.hpp"

namespace mc::tests::numbers_in_documents {

namespace {

/// The output of `./lab run` with the solutions.
std::string printed_by_hand(const Layout& layout, const Words& command) {
  Words words(command.begin() + 1, command.end());
  words.insert(words.begin() + 1, {"--dir", layout.solutions().string()});
  return lab(words).output;
}

std::string objection_by_hand(const Layout& layout, const Claim& claim) {
  return objection(claim, numbers_in(printed_by_hand(layout, claim.words)));
}

using Cells = std::map<std::string, std::string>;

/// A claim is about a cell, or about the ratio of two: "CELL divided by CELL".
std::string objection_in_tables(const Cells& cells, const Claim& claim) {
  constexpr std::string_view by = " divided by ";
  const auto middle = claim.cell.find(by);
  std::vector<std::string> printed;
  for (const std::string& name :
       {claim.cell.substr(0, middle),
        middle == claim.cell.npos ? "" : claim.cell.substr(middle + by.size())}) {
    if (name.empty()) continue;
    const auto found = cells.find(name);
    if (found == cells.end()) return "no such cell: " + name;
    printed.push_back(found->second);
  }
  if (printed.size() == 2) {
    const auto above = number_of(printed[0]), below = number_of(printed[1]);
    if (!above || !below) return "no numbers: " + claim.cell;
    printed = {fmt::format("{}", above->value / below->value)};
  }
  return objection(claim, printed);
}

/// The data of a lab's plots by "FILE | ROW | COLUMN", where a row is called by its first number,
/// and the only row of a file by nothing.
Cells cells_of_plots(const Layout& layout, const Lab& one) {
  REQUIRE_RUN(run, lab({"plot", one.name, "solutions"}));
  Cells cells;
  const fs::path data = layout.build / "plots/side-by-side/data" / (one.name + "-0");
  for (const auto& entry : fs::directory_iterator(data)) {
    if (entry.path().extension() != ".tsv") continue;
    const std::string file = entry.path().stem().string();
    std::istringstream text(with_replacements(read_text(entry.path()), {{"\t", " "}}));
    std::string line;
    std::getline(text, line);
    const auto columns = words_of(line);
    std::vector<Words> rows;
    while (std::getline(text, line)) rows.push_back(words_of(line));
    for (const Words& row : rows) {
      for (std::size_t i = 0; i < std::min(row.size(), columns.size()); ++i) {
        cells[fmt::format("{} | {} | {}", file, row[0], columns[i])] = row[i];
        if (rows.size() == 1) cells[fmt::format("{} | | {}", file, columns[i])] = row[i];
      }
    }
  }
  return cells;
}

/// Tables that a command wrote into a document (docs/refresh.sh), line by line:
///
///   <!-- output of ./lab bench sampler --tables: BEGINNING OF TITLES -->
///   …
///   <!-- end -->
struct OutputBlock {
  Words words;
  std::vector<std::string> lines;
};
std::vector<OutputBlock> output_blocks(const std::string& document) {
  constexpr std::string_view opening = "<!-- output of ";
  std::vector<OutputBlock> all;
  for (auto at = document.find(opening); at != std::string::npos;
       at = document.find(opening, at + 1)) {
    const auto colon = document.find(':', at), head = document.find("-->", at);
    const auto end = document.find("<!-- end -->", at);
    OutputBlock block{words_of(document.substr(at + opening.size(), colon - at - opening.size())),
                      {}};
    std::istringstream text(document.substr(head, end - head));
    std::string line;
    std::getline(text, line);  // the rest of the marker
    while (std::getline(text, line)) {
      if (!line.empty()) block.lines.push_back(line);
    }
    all.push_back(block);
  }
  return all;
}

/// A document may show a part of the bench's output; a title may end with a colon there.
bool is_printed(const std::string& tables, std::string line) {
  if (line.ends_with(':')) line.pop_back();
  return contains('\n' + tables, '\n' + line + '\n');
}

}  // namespace

TEST_CASE("a number's value and precision are those of its digits") {
  const struct {
    const char* text;
    double value, half_unit;
  } cases[] = {{"3/8", 0.375, 0},
               {"¾", 0.75, 0},
               {"−170.7", -170.7, 0.05},
               {"36.5 %", 0.365, 0.0005},
               {"1,024", 1024, 0.5},
               {"5.9e-5", 5.9e-5, 0.05e-5},
               {"3.6·10⁻²⁶", 3.6e-26, 0.05e-26},
               {"4.2 · 2⁻⁵³", 4.2 * 0x1p-53, 0.05 * 0x1p-53},
               {"10³⁰⁸", 1e308, 0},
               {"1.8 \\cdot 10^{-4}", 1.8e-4, 0.05e-4}};
  for (const auto& one : cases) {
    CAPTURE(one.text);
    const auto number = number_of(one.text);
    REQUIRE(number);
    CHECK(number->value == Approx(one.value).epsilon(1e-14));
    CHECK(number->half_unit == Approx(one.half_unit).epsilon(1e-14));
  }
  for (const char* text : {"", "x", "three", "3 x", "3/", "2 · 3"}) CHECK(!number_of(text));
}

TEST_CASE("a number is found in a text only as a whole") {
  CHECK(contains_number("which is 3/8.", "3/8"));
  CHECK(contains_number("0.375, or so", "0.375"));
  CHECK(!contains_number("which is 13/8", "3/8"));
  CHECK(!contains_number("10.375", "0.375"));
  CHECK(!contains_number("0.3751", "0.375"));
  CHECK(!contains_number("47.5 of 64", "47"));
}

/// One wrong number of each kind, and a right one of each kind.
TEST_CASE("wrong numbers are detected") {
  const Layout layout = read_layout();
  const std::string command = "./lab run halton radical_inverse 2 6";
  const auto claim = [&](const std::string& numbers, const std::string& passage) {
    const auto claims =
        claims_in("text\n\n<!-- ./lab run other = 1\n     " + command + " = " + numbers +
                  " -->\n<!-- ./lab run next = 2 -->\n" + passage + "\n\nbehind it: 3/8\n");
    REQUIRE(claims.size() == 3);
    CHECK(claims[2].words == Words{"./lab", "run", "next"});
    return objection_by_hand(layout, claims[1]);
  };
  CHECK(claim("3/8", "The steps lead\nto 3/8.") == "");
  CHECK(claim("6, 3/8", "point 6 is 3/8") == "");
  CHECK(claim("3/8", "The steps lead to 5/8.") == "not in the passage: 3/8");
  CHECK(contains(claim("0.376", "about 0.376"), "not printed"));
  CHECK(contains(claim("3/8, 6", "point 6 is 3/8"), "not in this order"));

  const auto shown =
      transcripts_of("```console\n$ " + command + "\n# index  x\n6        0.375\n```\n");
  REQUIRE(shown.size() == 1);
  CHECK(printed_by_hand(layout, shown[0].words) == shown[0].output);

  const std::string tables =
      "empty cells\n\n| | plain | 1,024 |\n|---|--:|--:|\n| of 64 | 47 | 3.3e-2 |\n\n"
      "errors (± 3 % at most)\n\n| | a |\n|---|--:|\n| b | 62 |\n| c | |\n";
  const auto cell = [&](const std::string& where, const std::string& number) {
    const auto claims = claims_in("<!-- ./lab bench halton --tables:\n     " + where + " = " +
                                  number + " -->\nIt is " + number + ".\n");
    REQUIRE(claims.size() == 1);
    CHECK(claims[0].words == Words{"./lab", "bench", "halton", "--tables"});
    return objection_in_tables(cells_in(tables), claims[0]);
  };
  const std::string plain = "empty cells | of 64 | plain";
  CHECK(cell(plain, "47") == "");
  CHECK(cell("empty cells | of 64 | 1,024", "0.033") == "");
  CHECK(cell("errors | b | a divided by " + plain, "1.3") == "");
  CHECK(contains(cell(plain, "46"), "not printed"));
  CHECK(contains(cell("errors | c | a", "62"), "not printed"));
  CHECK(contains(cell("errors | b | a divided by " + plain, "1.4"), "not printed"));
  CHECK(contains(cell("errors | b | a divided by errors | b | b", "1.3"), "no such cell"));

  const auto blocks = output_blocks(
      "a\n<!-- output of ./lab bench halton --tables:\n errors -->\nerrors (± 3 % at most):\n\n"
      "| b | 62 |\n| b | 63 |\n\n<!-- end -->\nc\n");
  REQUIRE(blocks.size() == 1);
  CHECK(blocks[0].words == Words{"./lab", "bench", "halton", "--tables"});
  REQUIRE(blocks[0].lines.size() == 3);
  CHECK(is_printed(tables, blocks[0].lines[0]));
  CHECK(is_printed(tables, blocks[0].lines[1]));
  CHECK(!is_printed(tables, blocks[0].lines[2]));
}

TEST_CASE("the bench takes a file of the repository's submissions, and no other") {
  check_refused(lab({"bench", "variance", "solutions/variance.cpp", "--tables"}),
                "solutions/variance.cpp is not in autograder/submissions");
  check_refused(lab({"bench", "variance", "missing.cpp"}), "there is no file missing.cpp");
}

/// Takes a minute: the bench and the plots measure all that these documents quote. The tables of a
/// lab are printed once, with all submissions that its numbers are about.
TEST_CASE("the numbers in handouts, answers and lectures are those that their commands print",
          "[.numbers]") {
  const Layout layout = read_layout();
  std::size_t compared = 0;
  for (const Lab& one : find_labs(layout)) {
    std::string handout = read_text(layout.labs() / one.folder / "README.md");
    for (const char* folder : {"answers", "lectures"}) {
      handout += "\n\n" + read_text(layout.root / "docs" / folder / (one.folder + ".md"));
    }
    const auto all_shown = transcripts_of(handout);
    for (const Transcript& shown : all_shown) {
      CAPTURE(one.name, shown.words);
      CHECK(printed_by_hand(layout, shown.words) == shown.output);
    }
    std::vector<Claim> of_tables, of_plots;
    std::vector<Words> benches;
    const auto claims = claims_in(handout);
    for (const Claim& claim : claims) {
      CAPTURE(one.name, claim.words, claim.numbers);
      REQUIRE(claim.words.size() > 3);
      if (claim.words[1] == "run") {
        CHECK(objection_by_hand(layout, claim) == "");
      } else if (claim.words[1] == "plot") {
        CHECK(claim.words == Words{"./lab", "plot", one.name, "solutions"});
        of_plots.push_back(claim);
      } else {
        of_tables.push_back(claim);
        benches.push_back(claim.words);
      }
    }
    const auto blocks = output_blocks(handout);
    for (const OutputBlock& block : blocks) benches.push_back(block.words);
    compared += all_shown.size() + claims.size() + blocks.size();
    if (!of_plots.empty()) {
      const Cells cells = cells_of_plots(layout, one);
      for (const Claim& claim : of_plots) {
        CAPTURE(claim.cell, claim.numbers);
        CHECK(objection_in_tables(cells, claim) == "");
      }
    }
    if (benches.empty()) continue;
    std::set<std::string> submissions;
    for (const Words& words : benches) {
      CAPTURE(words);
      REQUIRE(words.size() > 3);
      CHECK(words[1] == "bench");
      CHECK(words[2] == one.name);
      CHECK(words.back() == "--tables");
      submissions.insert(words.begin() + 3, words.end() - 1);
    }
    Words words{"bench", one.name};
    words.insert(words.end(), submissions.begin(), submissions.end());
    words.insert(words.end(), {"--tables", "--rounds", "1"});
    REQUIRE_RUN(run, lab(words));
    CHECK_FALSE(contains(run.output, "efficiency"));  // only the tables
    const Cells cells = cells_in(run.output);
    for (const Claim& claim : of_tables) {
      CAPTURE(claim.cell, claim.numbers);
      CHECK(objection_in_tables(cells, claim) == "");
    }
    for (const OutputBlock& block : blocks) {
      for (const std::string& line : block.lines) {
        CAPTURE(line);
        CHECK(is_printed(run.output, line));
      }
    }
  }
  CHECK(compared > 100);
}

}  // namespace mc::tests::numbers_in_documents
