// The interactive page, in a browser.

#include "judge/reports/html.hpp"
#include "tests/browser.hpp"
#include "tests/submissions.hpp"

namespace mc::tests::demo {

namespace {

sandbox::ProcessResult lab_demo(const Words& words) {
  return lab(joined({"demo"}, words));
}

/// Moves every control of every lab through all its values, and presses the keys; the title reports
/// how many pictures changed, and what is wrong. Facts: lab 1's exact variance of 4, 7, 13, 16; the
/// means of the integrands by a midpoint rule; that plain Halton points fill elementary intervals;
/// that the power of N points has the mean 1 over all frequencies but 0 (independent ones, of 4
/// sets of 256: within 5 %).
constexpr const char* driver = R"html(<script>
onload = () => {
  const wrong = [], same = (a, b, bound, what) => Math.abs(a - b) > bound && wrong.push(what);
  const look = () => shown.map(one => one.toDataURL?.() ?? one.outerHTML).join("") +
    document.getElementById("now").textContent;
  let pictures = 0, controls = 0;
  for (const one of present) {
    lab = one;
    build();
    for (const input of inputs.filter(input => !input.parentElement.hidden)) {
      const count = input.tagName === "SELECT" ? input.length : +input.max + 1, seen = new Set();
      const before = input.value;
      for (let i = 0; i < count; i += Math.ceil(count / 6)) {
        input.value = i;
        input.dispatchEvent(new Event("input"));
        seen.add(look());
      }
      if (seen.size < 2) wrong.push(`lab ${lab}: ${input.id} changes nothing`);
      pictures += seen.size;
      controls++;
      input.value = before;
      input.dispatchEvent(new Event("input"));
    }
    const before = look();
    document.body.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft", bubbles: true }));
    if (look() === before) wrong.push(`lab ${lab}: no key moves its slider`);
    for (const node of document.querySelectorAll("canvas, svg, input, select")) {
      const named = node.ariaLabel || node.labels?.length;
      if (!named) wrong.push(`lab ${lab}: ${node.id} has no name`);
    }
  }
  for (const name of Object.keys(integrands)) {
    for (const degrees of [0, 25, 45, 90]) {
      const f = integrands[name](degrees), grid = range(500).map(i => (i + .5) / 500);
      same(mean(grid.map(x => mean(grid.map(y => f.g(x, y))))), f.exact, .002, `mean of ${name}`);
    }
  }
  same(of(1).find(one => one.data === "4, 7, 13, 16").exact[9], 30, 1e-12, "variance");
  const counts = range(216).map(() => 0), [x, y] = ["base 2", "base 3"].map(one => columns[one][0]);
  for (let i = 0; i < 216; i++) counts[part(x[i], 8) + 8 * part(y[i], 27)]++;
  if (counts.some(count => count !== 1)) wrong.push("elementary intervals");
  const independent = ways.find(way => way.name === "independent");
  same(mean(rings(spectrum(independent, 4, 4, 32), 32)), 1, .05, "power");
  const enough = pictures >= 4 * controls;
  document.title = `${controls} controls of ${present}, ${enough}; wrong: ${wrong}`;
};
</script>)html";

}  // namespace

TEST_CASE("the demo is one page per lab in one file, and all controls work", "[.demo]") {
  const Scratch place;
  const fs::path file = place.path() / "demo.html";
  REQUIRE_RUN(run, lab_demo({"--out", file}));
  CHECK(fs::file_size(file) < 3'000'000);
  const std::string page = read_text(file);
  check_lacks(page, {"src=", "href=\"", "@import", "url(", "fetch("});
  if (chromium().empty()) return;  // no browser
  const PageState opened = open_page(place.write("driven.html", page + driver));
  CHECK(opened.console.empty());
  CHECK(opened.title == "22 controls of 1,2,3,4,5,6, true; wrong: ");
  for (const char* lab : {"1", "2", "3", "4", "5", "6"}) {
    CHECK(axe_findings(page + "<script>location.hash = " + lab + "; go();</script>") == "");
  }
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
  const auto nothing = lab_demo({"--out", file, "--dir", layout.starter()});
  CHECK(nothing.exit_code == 1);
  CHECK(contains(nothing.output, "no page: none of the tasks"));
  CHECK(!fs::exists(file));
  for (const char* name : {"variance.cpp", "independent.cpp"}) {
    fs::copy_file(layout.solutions() / name, place.path() / name);
  }
  fs::copy_file(layout.starter() / "stratification.cpp", place.path() / "stratification.cpp");
  REQUIRE_RUN(some, lab_demo({"--out", file, "--dir", place.path()}));
  const std::string page = read_text(file);
  CHECK(!contains(page, "\"name\":\"jittered\""));
  check_contains(
      page, {"\"name\":\"independent\"", "<li>lab 3: 3.3 is not written yet</li>",
             "<li>lab 3: 3.6 is not written yet</li>", "<li>lab 5: There is no halton.cpp.</li>"});
  if (!chromium().empty()) CHECK(open_page(file).console.empty());
}

TEST_CASE("an open page follows the code, and keeps what was chosen", "[.demo]") {
  if (chromium().empty()) return;
  const Layout layout = read_layout();
  const Scratch place, pages;
  for (const char* file : {"variance.cpp", "independent.cpp"}) {
    fs::copy_file(layout.solutions() / file, place.path() / file);
  }
  const std::string all = read_text(layout.solutions() / "stratification.cpp");
  const std::string grid = "  require_grid(x, y, grid);\n  const Strata";
  const std::string without = with_change(all, grid, "throw 3.3;\n" + grid);
  const auto save = [&](const std::string& text) { place.write("stratification.cpp", text); };
  const fs::path page = pages.path() / "demo.html", before = pages.path() / "before.html",
                 after = pages.path() / "after.html";
  for (const auto& [text, file] : {std::pair{all, after}, {without, before}}) {
    save(text);
    REQUIRE_RUN(run, lab_demo({"--out", file, "--dir", place.path()}));
  }

  Browser browser;
  // As a student without a mouse: lab 3, a larger N, the tab key to the points, and there "Latin
  // hypercube", which 3.3 comes before in the list.
  const auto choose = [&](const fs::path& file) {
    browser.open("about:blank");
    browser.open("file://" + file.string());
    browser.wait_for("document.readyState === 'complete' && present.includes('3')");
    browser.press("3");
    browser.wait_for("lab === '3'");
    browser.press("ArrowRight");
    while (browser.value_of("document.activeElement.id") != "way-control") browser.press("Tab");
    browser.press("L");
    browser.value_of("scrollTo(0, 150)");
  };
  const std::string drawn =
      "shown.map(one => one.toDataURL?.() ?? one.outerHTML).join() + at('now').textContent + "
      "at('numbers').textContent";
  const std::string chosen =
      "[lab, ...inputs.map(one => one.selectedOptions?.[0].text ?? one.value), scrollY, "
      "document.activeElement.id].join()";
  BackgroundProcess watching(
      {(layout.bin / "lab").string(), "demo", "--watch", "--out", page, "--dir", place.path()});
  watching.until("\nmeasured ");
  for (const Browser::Look look :
       {Browser::Look{1280, false}, {1280, true}, {390, false}, {390, true}}) {
    CAPTURE(look.width, look.is_dark);
    browser.set(look);
    choose(after);
    const Browser::Json final_picture = browser.value_of(drawn);
    choose(before);
    const Browser::Json first_picture = browser.value_of(drawn);
    CHECK(first_picture != final_picture);

    choose(page);
    CHECK(browser.value_of(drawn) == first_picture);
    const Browser::Json choices = browser.value_of(chosen);
    CHECK(choices == "3,Latin hypercube,edge: 1 below a line,5,4,0,150,way-control");
    browser.value_of("window.last = " + drawn);
    save(all);
    browser.wait_for(drawn + " !== last");
    CHECK(browser.value_of(drawn) == final_picture);
    CHECK(browser.value_of(chosen) == choices);
    CHECK(browser.value_of("document.documentElement.scrollWidth <= innerWidth") == true);

    save("not C++\n");
    browser.wait_for("news.textContent.includes('stratification.cpp does not compile: ')");
    CHECK(browser.value_of(drawn) == final_picture);
    CHECK(browser.value_of(chosen) == choices);

    save(without);
    browser.wait_for(drawn + " === last");
  }
  CHECK(watching.interrupt() == 0);
  browser.wait_for("news.textContent.includes('has ended')");
}

}  // namespace mc::tests::demo
