#include "grader/layout.hpp"

#include <fstream>

#include "grader/errors.hpp"
#include "grader/process.hpp"
#include "runner/text.hpp"

namespace mc::grader {

Layout read_layout() {
  const std::filesystem::path build = MC_BUILD_DIR;
  std::ifstream file(build / "layout.txt");
  if (!file) throw MachineError("the build directory is incomplete: run ./lab setup");
  Layout layout;
  layout.build = build;
  std::string line;
  while (std::getline(file, line)) {
    const auto at = line.find('=');
    if (at == std::string::npos) continue;
    const std::string key = line.substr(0, at), value = line.substr(at + 1);
    if (key == "root") layout.root = value;
    if (key == "compiler") layout.compiler = value;
    if (key == "compiler_id") layout.is_clang = value.find("Clang") != std::string::npos;
    if (key.starts_with("peers.")) layout.peers[key.substr(6)];
    if (key == "link_flags" || key.starts_with("objects.") || key.starts_with("peers.")) {
      for (const std::string_view part : text::split(value, ';')) {
        if (part.empty()) continue;
        if (key == "link_flags") {
          layout.link_flags.emplace_back(part);
        } else if (key.starts_with("peers.")) {
          layout.peers[key.substr(6)].emplace_back(part);
        } else {
          layout.objects[key.substr(8)].emplace_back(part);
        }
      }
    }
  }
  const std::string root = layout.root.string();
  const auto described = run_process({"git", "-C", root, "describe", "--always", "--dirty"});
  layout.version = described.succeeded() ? described.output : "unknown";
  while (layout.version.ends_with('\n')) layout.version.pop_back();
  return layout;
}

}  // namespace mc::grader
