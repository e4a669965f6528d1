// The lecture demo: its integrals, and its page in a browser.
#include <filesystem>

#include "checks/support/catch.hpp"
#include "grader/base/text_file.hpp"
#include "grader/checkout/layout.hpp"
#include "grader/reports/html.hpp"
#include "sandbox/process.hpp"
#include "tests/browser.hpp"
#include "tests/submissions.hpp"
#include "tests/text.hpp"

namespace mc::tests::demo {

namespace fs = std::filesystem;
using namespace grader;

namespace {

sandbox::ProcessResult lab_demo(std::vector<std::string> words) {
  words.insert(words.begin(), {(read_layout().build / "bin" / "course").string(), "demo"});
  return sandbox::run_process(words);
}

/// Moves N through all its sizes and presses every key; the title reports the result.
constexpr const char* driver = R"html(<script>
onload = () => {
  const look = () => document.getElementById("points").toDataURL() +
    document.getElementById("lines").outerHTML + document.getElementById("now").textContent;
  const slider = document.getElementById("n"), pictures = new Set();
  let right = 0;
  for (let step = 0; step <= +slider.max; step++) {
    slider.value = step;
    slider.dispatchEvent(new Event("input"));
    pictures.add(look());
    right += document.getElementById("now").textContent.startsWith(`N = ${2 ** step}:`);
  }
  let keys = "";
  for (const key of ["ArrowLeft", "ArrowRight", "p", "i", "s"]) {
    const before = look();
    document.body.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
    if (look() !== before) keys += key + " ";
  }
  const way = document.getElementById("way");
  document.title = `${pictures.size} pictures, ${right} right; ${keys}; ${way.length} ways; ` +
    [...document.querySelectorAll("canvas, svg, table, input, select, button")].filter(
      one => !(one.ariaLabel || one.closest("[aria-label], label") || one.textContent)).length +
    " without a name";
};
</script>)html";

}  // namespace

TEST_CASE("the demo is one page, and all its controls work", "[.demo]") {
  const Scratch place;
  const fs::path file = place.path() / "demo.html";
  const auto run = lab_demo({"--out", file.string()});
  INFO(run.output << run.errors);
  REQUIRE(run.exit_code == 0);
  CHECK(fs::file_size(file) < 3'000'000);
  const std::string page = read_text(file);
  for (const char* foreign : {"src=", "href=", "@import", "url(", "fetch("}) {
    CHECK(!contains(page, foreign));
  }
  if (chromium().empty()) return;  // no browser
  const PageState opened = open_page(place.write("driven.html", page + driver));
  CHECK(opened.console.empty());
  CHECK(opened.title ==
        "13 pictures, 13 right; ArrowLeft ArrowRight p i s ; 6 ways; 0 without a name");
  // 390 pixels, as on a phone, are enough.
  const PageState phone = open_page(place.write(
      "phone.html",
      fmt::format("<title>none</title><iframe width=390 height=800 style='border:0' srcdoc=\"{}\">"
                  "</iframe><script>onload = () => {{ const page = "
                  "document.querySelector('iframe').contentDocument.documentElement; "
                  "document.title = page.scrollWidth <= page.clientWidth ? 'fits' : 'too wide'; "
                  "document.body.innerHTML = ''; }};</script>",
                  html_escaped(page))));
  CHECK(phone.console.empty());
  CHECK(phone.title == "fits");
}

TEST_CASE("a demo of a partly written lab says why the rest is missing", "[.demo]") {
  const Layout layout = read_layout();
  const Scratch place;
  const fs::path file = place.path() / "demo.html";
  const auto nothing = lab_demo({"--out", file.string(), "--dir", layout.starter().string()});
  CHECK(nothing.exit_code == 1);
  CHECK(contains(nothing.output, "no page: there are no points"));
  CHECK(!fs::exists(file));
  for (const char* name : {"variance.cpp", "independent.cpp"}) {
    fs::copy_file(layout.solutions() / name, place.path() / name);
  }
  fs::copy_file(layout.starter() / "stratification.cpp", place.path() / "stratification.cpp");
  const auto some = lab_demo({"--out", file.string(), "--dir", place.path().string()});
  INFO(some.output << some.errors);
  CHECK(some.exit_code == 0);
  const std::string page = read_text(file);
  CHECK(contains(page, "\"name\":\"independent\""));
  CHECK(!contains(page, "\"name\":\"jittered\""));
  CHECK(contains(page, "<li>lab 3: 3.3 is not written yet</li>"));
  CHECK(contains(page, "<li>lab 5: there is no halton.cpp</li>"));
}

}  // namespace mc::tests::demo
