#include "grader/gradebook/slurm.hpp"

#include "grader/gradebook/book.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {
namespace {

/// The tasks' output directory: grades-slurm/ for grades.csv.
fs::path task_directory(const fs::path& csv) {
  return fs::absolute(csv).parent_path() / (csv.stem().string() + "-slurm");
}

/// Quotes a word for the shell byte by byte: a task must find the files that this process found.
std::string as_word(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + '\'';
}

/// A compiler may take 1.5 GB and a program 0.5 GB; clusters that enforce memory limits need to
/// know. SBATCH_MEM_PER_NODE and similar variables override this.
std::string script_of(const Context& context, const SlurmTasks& tasks, const fs::path& place) {
  std::string options, words;
  for (const std::string& word : tasks.options) options += ' ' + as_word(word);
  for (const std::string& word : tasks.words) words += ' ' + as_word(word);
  return fmt::format(
      "#!/bin/sh\n#SBATCH --mem=2G\n"
      "exec {} grade{} --csv {}/\"$SLURM_ARRAY_TASK_ID\".csv --shard \"$SLURM_ARRAY_TASK_ID\"/{} "
      "--seed {} --resume --no-plots -j \"${{SLURM_CPUS_PER_TASK:-1}}\" --{}\n",
      as_word(context.layout.course().string()), options, as_word(place.string()), tasks.count,
      tasks.seed, words);
}

std::string trimmed(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text;
}

}  // namespace

std::string submit_tasks(const Context& context, const SlurmTasks& tasks) {
  const fs::path place = task_directory(tasks.csv), script = place / "task.sh";
  if (!tasks.is_resumed) fs::remove_all(place);
  fs::create_directories(place);
  write_text(script, script_of(context, tasks, place));
  const auto run =
      sandbox::run_process({"sbatch", "--parsable", fmt::format("--array=1-{}", tasks.count),
                            "--requeue", "--job-name=grade", "--open-mode=append",
                            "--output=" + (place / "%a.log").string(), script.string()});
  if (run.exit_code == 127) throw MachineError("sbatch not found: is Slurm installed?");
  if (!run.succeeded()) {
    throw MachineError("sbatch: " + sandbox::printable_line(trimmed(run.errors)));
  }
  std::string job = trimmed(run.output.substr(0, run.output.find(';')));  // 12;cluster
  write_text(place / "job", job + '\n');
  return job;
}

std::size_t gather_tasks(const fs::path& csv) {
  const fs::path place = task_directory(csv);
  if (!fs::exists(place / "job")) return 0;
  const std::string job = trimmed(read_text(place / "job"));
  // Slurm forgets ended jobs after a while; then this fails, which means nothing.
  const auto queue = sandbox::run_process({"squeue", "--noheader", "--jobs=" + job});
  if (queue.succeeded() && !trimmed(queue.output).empty()) {
    throw UsageError(
        fmt::format("job {} is still running: wait for it (squeue), or cancel it "
                    "(scancel {}) and judge the rest here",
                    job, job));
  }
  std::size_t count = 0;
  fs::create_directories(verdict_directory(csv));
  for (const auto& task : fs::directory_iterator(place)) {
    if (!task.is_directory()) continue;  // 7-verdicts
    for (const auto& entry : fs::directory_iterator(task.path())) {
      if (entry.path().extension() != ".json") continue;
      const fs::path to = verdict_directory(csv) / entry.path().filename();
      ++count;
      // Verdicts judged here since then are newer.
      if (fs::exists(to) && fs::last_write_time(to) > entry.last_write_time()) continue;
      write_text(to, read_whole_text(entry.path()));
    }
  }
  return count;
}

}  // namespace mc::grader
