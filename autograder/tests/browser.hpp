#pragma once
// Opens pages in headless Chromium.

#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "sandbox/process.hpp"
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
inline PageState open_page(const std::filesystem::path& file) {
  const Scratch place;
  const auto run = sandbox::run_process(
      {chromium(), "--headless", "--no-sandbox", "--disable-gpu", "--enable-logging=stderr",
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

}  // namespace mc::tests
