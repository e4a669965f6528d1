// A class as pages, opened in a browser.
#include <algorithm>
#include <cstdlib>
#include <regex>
#include <set>

#include "grader/gradebook/class_page.hpp"
#include "grader/gradebook/statistics.hpp"
#include "grader/reports/html.hpp"
#include "tests/browser.hpp"
#include "tests/gradebook/course.hpp"
#include "tests/gradebook/page_cells.hpp"

namespace mc::tests::pages {

namespace {

/// A class with one of each: no code, code that does not compile, a failure, full marks, no zip,
/// and a name that must be escaped in HTML and in a URL.
struct GradedClass : Course {
  fs::path pages = path() / "pages";
  sandbox::ProcessResult run;
  GradedClass() {
    hand_in("<i>#1 100%", text_of(layout.starter()));
    hand_in("bob", "int " + std::string(300, 'x') + " is not a name;\n");
    hand_in("eve", text_with_mistake(layout));
    hand_in("sol", text_of(layout.solutions()));
    write_text(path() / "class" / "broken.zip", "no zip");
    run = grade({"--csv", csv(), "--html", pages, "--seed", "1"});
    REQUIRE(run.succeeded());
  }
  std::vector<fs::path> all_pages() const {
    std::vector<fs::path> all;
    for (const auto& entry : fs::recursive_directory_iterator(pages)) {
      if (entry.is_regular_file()) all.push_back(entry.path());
    }
    std::sort(all.begin(), all.end());
    return all;
  }
};

/// What the group of a regular expression matches in a page, wherever it occurs.
Words found_in(const std::string& page, const char* expression) {
  const std::regex regex(expression);
  return {std::sregex_token_iterator(page.begin(), page.end(), regex, 1), {}};
}

/// Graded only once.
const GradedClass& graded_class() {
  static const GradedClass graded;
  return graded;
}

/// The browser's report on these pages in a window 390 pixels wide: its console, and the final
/// width of each page.
struct BrowserReport {
  std::string console, widths;
};
BrowserReport look_at(const std::vector<fs::path>& pages, const Scratch& place) {
  std::string text = "<!doctype html><title>none</title><body>";
  for (const fs::path& page : pages) {
    text += fmt::format("<iframe width=390 height=800 style='border:0' srcdoc=\"{}\"></iframe>",
                        html_escaped(read_text(page)));
  }
  text += R"(<script>onload = () => {
    document.title = [...document.querySelectorAll("iframe")]
      .map(f => Math.max(f.contentWindow.innerWidth, f.contentDocument.documentElement.scrollWidth))
      .join(" ");
    document.body.innerHTML = ""; };</script>)";
  const PageState opened = open_page(place.write("look.html", text));
  return {opened.console, opened.title};
}

}  // namespace

TEST_CASE("there is a page for each submission, and an index with their points and statistics") {
  const GradedClass& graded = graded_class();
  CHECK(contains(graded.run.output, "index.html"));
  CHECK(graded.all_pages().size() == 6);
  const std::string index = read_text(graded.pages / "index.html");
  CHECK(contains(index, "<a href=\"submissions/%3Ci%3E%231%20100%25.html\">&lt;i&gt;#1 100%</a>"));
  CHECK(contains(index, "unreadable: it is not a zip file"));
  CHECK(cells_after(index, "aria-label=\"submissions\"") == Cells{{"&lt;i&gt;#1 100%", "0"},
                                                                  {"bob", "0 (no program)"},
                                                                  {"broken", "unreadable"},
                                                                  {"eve", "99"},
                                                                  {"sol", "100"}});
  const Cells map = cells_after(index, "aria-label=\"submissions and tasks\"");
  REQUIRE(map.size() == 5);
  CHECK(std::count(map[0].begin(), map[0].end(), "0") == 8);
  CHECK(std::count(map[2].begin(), map[2].end(), "") == 8);
  CHECK(std::count(map[3].begin(), map[3].end(), "100") == 7);
  CHECK(map[3][7] == "90");  // 1.7
  CHECK(std::count(map[4].begin(), map[4].end(), "100") == 8);
  CHECK(contains(index, "background:rgba(0,114,178,0.45)\">100</td>"));
  CHECK(contains(index, "background:rgba(0,114,178,0.00)\">0</td>"));
  const Table table = read_table(graded.csv());
  const std::string stats =
      statistics_page(statistics_of(table, read_verdicts(table), graded.labs));
  CHECK(contains(index, stats.substr(stats.find("<h2>"))));
}

TEST_CASE("a student's page shows the report and names nothing on the grading machine") {
  const GradedClass& graded = graded_class();
  for (const fs::path& page : graded.all_pages()) {
    const std::string text = read_text(page);
    CAPTURE(page);
    check_lacks(text, {graded.path(), graded.layout.root, "by hand   "});
  }
  const std::string eve = read_text(graded.pages / "submissions" / "eve.html");
  check_contains(eve,
                 {"<pre>measured", "if (columns == 77) throw", "./lab check variance --only 1."});
  CHECK(contains(read_text(graded.pages / "submissions" / "broken.html"), "Unreadable: it is no"));
}

TEST_CASE("pages need no stored table, and work for a single submission") {
  Course course;
  course.hand_in("ada", "int x\n");
  const fs::path pages = course.path() / "pages";
  REQUIRE_RUN(run, course.grade({"--html", pages, "--no-plots"}));
  CHECK(fs::exists(pages / "index.html"));
  CHECK(contains(read_text(pages / "submissions" / "class.html"), "does not compile"));
  check_refused(course.grade({"--html", "/no/such/place/pages"}));
  check_refused(course.grade({"--html", pages / "index.html"}));
}

TEST_CASE("pages are self-contained, with headings in order and a text for every picture") {
  const GradedClass& graded = graded_class();
  for (const fs::path& file : graded.all_pages()) {
    const std::string page = read_text(file);
    CAPTURE(file);
    check_lacks(page, {"<script ", "src=\"http", "href=\"http", "@import", "url("});
    check_contains(page, {"prefers-color-scheme: dark", "<html lang=\"en\">"});
    CHECK(times(page, "<main>") == 1);  // one main landmark
    const Words regions = found_in(page, "aria-label=\"([^\"]*)");
    CHECK(std::set(regions.begin(), regions.end()).size() == regions.size());
    const Words headings = found_in(page, "<h([1-6])");
    CHECK_FALSE(headings.empty());
    int level = 0;
    for (const std::string& heading : headings) {
      CHECK(std::stoi(heading) <= level + 1);  // none is skipped
      level = std::stoi(heading);
    }
    CHECK(times(page, "<img ") == times(page, "<img alt=\""));
  }
}

TEST_CASE("a browser finds no error in a page, and no content wider than a phone") {
  if (chromium().empty()) return;  // no browser
  const GradedClass& graded = graded_class();
  const Scratch place;
  auto pages = graded.all_pages();
  REQUIRE(pages.size() == 6);
  const BrowserReport seen = look_at(pages, place);
  CHECK(seen.console.empty());
  CHECK(seen.widths == "390 390 390 390 390 390");
  for (const fs::path& page : pages) CHECK(axe_findings(read_text(page)) == "");
  const bool has_rules = std::getenv("MC_AXE") != nullptr;
  CHECK(contains(axe_findings("<main><img src=\"x\"></main>"), "image-alt") == has_rules);
  // The index finds submissions; a search without a match shows no row.
  const std::string driver = R"html(<script>
    addEventListener("load", () => {
      const found = [];
      for (const word of ["", "EVE", "unreadable", "nobody"]) {
        input.value = word;
        input.oninput();
        found.push(tables.map(rows => rows.filter(row => !row.hidden).length).join("/"));
      }
      document.title = found.join(" ");
    });
  </script>)html";
  const std::string index = read_text(graded.pages / "index.html");
  CHECK(open_page(place.write("search.html", index + driver)).title == "5/5 1/1 1/1 0/0");
  // The test detects content that is too wide, and errors.
  pages = {place.write("wide.html", "<div style=\"width:500px\">x</div>"),
           place.write("wrong.html", "<script>nothing.there();</script>")};
  const BrowserReport spoiled = look_at(pages, place);
  CHECK(contains(spoiled.console, "nothing is not defined"));
  CHECK(spoiled.widths == "508 390");
}

}  // namespace mc::tests::pages
