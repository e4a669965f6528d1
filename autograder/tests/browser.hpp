#pragma once
// Opens pages in headless Chromium.

#include <cstdlib>

#include "tests/submissions.hpp"

namespace mc::tests {

/// Its command; empty if it is not installed.
inline std::string chromium() {
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
    const auto found = sandbox::run_process({"sh", "-c", fmt::format("command -v {}", name)});
    if (found.succeeded()) return name;
  }
  return {};
}

/// The final title, which the page's scripts set, and the console messages.
struct PageState {
  std::string title, console;
};
inline PageState open_page(const fs::path& file, const std::string& option = "--disable-sync") {
  const Scratch place;
  const auto run = sandbox::run_process(
      {chromium(), "--headless", "--no-sandbox", "--disable-gpu", "--enable-logging=stderr", option,
       "--user-data-dir=" + (place.path() / "profile").string(), "--dump-dom",
       "file://" + file.string()},
      {.wall_seconds = 60});
  PageState opened;
  const auto begin = run.output.find("<title>") + 7;
  opened.title = run.output.substr(begin, run.output.find("</title>") - begin);
  for (auto at = run.errors.find("CONSOLE"); at != std::string::npos;
       at = run.errors.find("CONSOLE", at + 1)) {
    opened.console += run.errors.substr(at, run.errors.find('\n', at) - at) + '\n';
  }
  return opened;
}

/// Violations that axe-core, a collection of accessibility rules, finds on a page. MC_AXE is the
/// path of its axe.min.js, which is not part of this repository; without it, or a browser, none.
inline std::string axe_findings(const std::string& page) {
  const char* axe = std::getenv("MC_AXE");
  if (axe == nullptr || chromium().empty()) return {};
  const Scratch place;
  const std::string run = R"html(<script>
    const resultTypes = ["violations"];
    addEventListener("load", () => axe.run({ resultTypes }).then(({ violations }) => {
      document.title = "axe: " + violations.map(one => one.id + " " + one.nodes[0].html).join("; ");
    }));
  </script>)html";
  const PageState state = open_page(
      place.write("axe.html", page + "<script>" + read_whole_text(axe) + "</script>" + run),
      "--virtual-time-budget=60000");
  return state.title == "axe: " ? "" : state.title + state.console;
}

}  // namespace mc::tests
