#pragma once
// Pages, opened as a person opens them: in Chromium, without a window.

#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "sandbox/process.hpp"
#include "tests/submissions.hpp"

namespace mc::tests {

/// Its name; empty where there is none.
inline std::string chromium() {
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
    const auto found = sandbox::run_process({"sh", "-c", fmt::format("command -v {}", name)});
    if (found.succeeded()) return name;
  }
  return {};
}

/// What a page's scripts make of its title in the end, and what the console has to say.
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
