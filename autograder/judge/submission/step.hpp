#pragma once
// One run of a compiler or linker on untrusted text, and whose fault it is if the run fails.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "judge/checkout/layout.hpp"
#include "sandbox/confinement.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {

/// A run of a compiler or linker on untrusted text.
struct Step {
  const Layout& layout;
  std::vector<std::string> command;
  std::filesystem::path directory;              ///< where it runs; it writes only there
  std::vector<std::filesystem::path> readable;  ///< besides the toolchain and `directory`
  bool trusted;                                 ///< may read any file
};

/// How a step ended.
struct StepResult {
  sandbox::ProcessResult result;  ///< of the last attempt, with the CPU time of all
  /// What stopped it early, for the student; empty if it ended by itself.
  std::string stopped = {};
};

/// Runs the step within limits: its places only, no readable input, and a separate user when the
/// judge is root. If it fails, runs `probe`, which repeats the step with a known text and throws
/// MachineError if that fails, too; then, unless `is_text_at_fault`, tries once more. Throws
/// MachineError if the machine fails.
StepResult run_step(const Step& step, const std::function<void()>& probe,
                    const std::function<bool(const std::string& errors)>& is_text_at_fault);

/// Runs a step that must succeed. Throws MachineError if it fails.
void require(const Step& step);

/// Compiles, links and starts a known program in the sandbox. Throws if the machine cannot.
void probe_machine(const Layout& layout);

/// What the step may read and write.
sandbox::Places places_of(const Step& step);

/// A message without this machine's directories: students need not see where the checkout is.
std::string without_places(const Layout& layout, const std::filesystem::path& directory,
                           const std::string& text);

/// Throws MachineError if the disk has no room for what a compiler may write: it may be full, or
/// the quota used up.
void require_disk(const Layout& layout);

}  // namespace mc::grader
