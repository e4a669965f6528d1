#pragma once
// Opens pages in headless Chromium.

#include <cstdlib>

#include <nlohmann/json.hpp>

#include "tests/background.hpp"

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

/// A page that stays open: the DevTools protocol over a pipe.
class Browser {
 public:
  using Json = nlohmann::json;
  Browser() {
    const Json target = call("Target.createTarget", {{"url", "about:blank"}});
    session_ = call("Target.attachToTarget", {{"targetId", target["targetId"]}, {"flatten", true}})
                   .at("sessionId");
  }

  struct Look {
    int width;
    bool is_dark;
  };
  void set(const Look& look) {
    call("Emulation.setDeviceMetricsOverride",
         {{"width", look.width}, {"height", 800}, {"deviceScaleFactor", 1}, {"mobile", false}});
    const char* scheme = look.is_dark ? "dark" : "light";
    call("Emulation.setEmulatedMedia",
         {{"features", Json::array({{{"name", "prefers-color-scheme"}, {"value", scheme}}})}});
  }
  void open(const std::string& address) { call("Page.navigate", {{"url", address}}); }
  void press(const std::string& key) {
    for (const char* type : {"keyDown", "keyUp"}) {
      const int code = key == "Tab" ? 9 : key == "ArrowRight" ? 39 : key.at(0);
      call("Input.dispatchKeyEvent", {{"type", type},
                                      {"key", key},
                                      {"code", key},
                                      {"windowsVirtualKeyCode", code},
                                      {"text", key.size() == 1 ? key : ""}});
    }
  }
  /// What a script's expression gives.
  Json value_of(const std::string& script) {
    return call("Runtime.evaluate", {{"expression", script}, {"returnByValue", true}})
        .at("result")
        .value("value", Json());
  }
  /// Waits until an expression is true.
  void wait_for(const std::string& script) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (value_of(script) != true) {
      if (std::chrono::steady_clock::now() > end) FAIL("never true: " << script);
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }

 private:
  Json call(const std::string& method, const Json& parameters) {
    Json request{{"id", ++calls_}, {"method", method}, {"params", parameters}};
    if (!session_.empty()) request["sessionId"] = session_;
    process_.write(request.dump() + '\0');
    for (;;) {  // events come, too
      std::string text = process_.until(std::string(1, '\0'));
      text.pop_back();
      const Json response = Json::parse(text);
      if (response.value("id", 0) != calls_) continue;
      if (!response.contains("result")) FAIL(method << ": " << text);
      return response["result"];
    }
  }

  Scratch profile_;
  BackgroundProcess process_{
      {chromium(), "--headless", "--no-sandbox", "--disable-gpu",
       "--user-data-dir=" + profile_.path().string(), "--log-level=3", "--remote-debugging-pipe"},
      {4},
      3};
  std::string session_;
  int calls_ = 0;
};

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
