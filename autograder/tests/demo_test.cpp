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
             "<li>lab 3: 3.6 is not written yet</li>", "<li>lab 5: there is no halton.cpp</li>"});
  if (!chromium().empty()) CHECK(open_page(file).console.empty());
}

}  // namespace mc::tests::demo
