#include "classes/slurm.hpp"

#include <cstdlib>

#include <fmt/format.h>

#include "judge/base/errors.hpp"
#include "judge/base/text_file.hpp"
#include "sandbox/printable.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

/// Quotes a word for the shell byte by byte: a task must find the files that this process found.
std::string as_word(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + '\'';
}

std::string without_line_end(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text;
}

/// The environment that Slurm's programs need.
sandbox::ProcessOptions for_slurm() {
  sandbox::ProcessOptions options;
  for (const char* name : {"SLURM_CONF", "SBATCH_ACCOUNT", "SBATCH_PARTITION", "SBATCH_QOS",
                           "SBATCH_TIMELIMIT", "SBATCH_MEM_PER_NODE", "USER", "LOGNAME"}) {
    if (const char* value = std::getenv(name)) options.environment.push_back({name, value});
  }
  return options;
}

}  // namespace

std::optional<std::size_t> slurm_task() {
  const char* task = std::getenv("SLURM_ARRAY_TASK_ID");
  if (task == nullptr) return {};
  const auto number = std::strtoull(task, nullptr, 10);
  return number == 0 ? std::nullopt : std::optional<std::size_t>(number - 1);
}

std::string submit_tasks(const Context& context, const VerdictStore& store,
                         const std::vector<std::string>& words, std::size_t count) {
  const fs::path script = store.directory() / "task.sh";
  // A compiler may take 1.5 GB and a program 0.5 GB; clusters that enforce memory limits need to
  // know. SBATCH_MEM_PER_NODE overrides this.
  std::string text = "#!/bin/sh\n#SBATCH --mem=2G\nexport MC_NO_BUILD=1\nexec " +
                     as_word((context.layout.bin / "lab").string());
  for (const std::string& word : words) text += ' ' + as_word(word);
  write_text(script, text + '\n');
  const auto run =
      sandbox::run_process({"sbatch", "--parsable", fmt::format("--array=1-{}", count), "--requeue",
                            "--job-name=grade", "--open-mode=append",
                            "--output=" + (store.directory() / "%a.log").string(), script.string()},
                           for_slurm());
  if (run.exit_code == 127) throw MachineError("sbatch not found: is Slurm installed?");
  if (!run.succeeded()) {
    throw MachineError("sbatch: " + sandbox::printable_line(without_line_end(run.errors)));
  }
  std::string job = without_line_end(run.output.substr(0, run.output.find(';')));  // 12;cluster
  write_text(store.directory() / "job", job + '\n');
  return job;
}

void require_finished_tasks(const VerdictStore& store) {
  if (!fs::exists(store.directory() / "job")) return;
  const std::string job = without_line_end(read_text(store.directory() / "job"));
  // Slurm forgets ended jobs after a while; then this fails, which means nothing.
  const auto queue = sandbox::run_process({"squeue", "--noheader", "--jobs=" + job}, for_slurm());
  if (queue.succeeded() && !without_line_end(queue.output).empty()) {
    throw UsageError(
        fmt::format("job {0} is still running: wait for it (squeue), or cancel it "
                    "(scancel {0}) and judge the rest here",
                    job));
  }
}

}  // namespace mc::grader
