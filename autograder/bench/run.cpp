// bench: speed against error, of the solutions, of any submission, and of libraries.

#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>

#include <fmt/format.h>

#include "bench/bench.hpp"
#include "bench/progress.hpp"
#include "grader/base/errors.hpp"
#include "grader/base/side_by_side.hpp"
#include "grader/base/text_file.hpp"
#include "grader/commands/command.hpp"
#include "grader/judging/judge.hpp"
#include "grader/submission/build.hpp"
#include "grader/submission/compile.hpp"
#include "protocol/environment.hpp"
#include "runner/text.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;

/// Ctrl-C ends the measuring, and what was measured is still written.
std::atomic<bool> is_interrupted{false};

/// During its lifetime, an interrupt sets `is_interrupted`; a second one ends the program.
class StopOnInterrupt {
 public:
  StopOnInterrupt() {
    struct sigaction action {};
    action.sa_handler = [](int) { is_interrupted = true; };
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, &before_);
    sigaction(SIGTERM, &action, nullptr);
  }
  ~StopOnInterrupt() { sigaction(SIGINT, &before_, nullptr); }
  StopOnInterrupt(const StopOnInterrupt&) = delete;

 private:
  struct sigaction before_ {};
};

/// A lab's program of a submission, to be measured.
struct Contender {
  Lab lab;
  std::string label;
  sandbox::Program program;
};

/// One run of a lab's bench cases on a contender's program.
struct Job {
  const Contender* entrant;
  std::string kind;  ///< "error", "time", "growth", "table", "table-time"
  fs::path rows;     ///< output file
};

std::string name_of(const Job& job) {
  return fmt::format("{} {} {}", job.entrant->lab.name, job.kind, job.entrant->label);
}

class BenchRun {
 public:
  BenchRun(const Context& context, fs::path place)
      : context_(context), place_(std::move(place)), progress_(place_.string() + "-seconds.txt") {
    fs::remove_all(place_);
    fs::create_directories(place_ / "rows");
  }

  /// Everything measurable in one lab; adds a remark for contenders that cannot be measured.
  void enter(const Lab& lab, const std::vector<Submission>& submissions) {
    for (const Submission& submission : submissions) {
      if (is_interrupted || !submission.files.contains(lab.name)) continue;
      BuildResult built = build_program(context_.layout, lab, submission);
      if (built.program) {
        entrants_.push_back({lab, submission.label, std::move(*built.program)});
      } else {
        fmt::print("{} is not benched: {}\n", submission.label, built.failure);
      }
    }
  }

  /// Errors in parallel; times one by one, each round with all contenders in turn; growth last, so
  /// that an interruption leaves the tables complete.
  void measure(unsigned rounds, bool tables_only) {
    std::vector<Job> errors, in_turn;
    const auto add = [&](std::vector<Job>& jobs, const char* kind, unsigned round) {
      for (const Contender& entrant : entrants_) {
        if (kind == std::string("growth") && entrant.label != "solutions") continue;
        if (has_cases(entrant.lab, kind)) jobs.push_back(job(entrant, kind, round));
      }
    };
    if (!tables_only) add(errors, "error", 0);
    add(errors, "table", 0);
    for (unsigned round = 0; round < rounds; ++round) {
      if (!tables_only) add(in_turn, "time", round);
      add(in_turn, "table-time", round);
    }
    if (!tables_only) add(in_turn, "growth", 0);
    if (errors.empty() && in_turn.empty()) {
      fmt::print("There is nothing to measure: no submission, or a lab without a bench.\n");
      return;
    }
    jobs_ = errors;
    jobs_.insert(jobs_.end(), in_turn.begin(), in_turn.end());
    constexpr unsigned workers = 2;
    for (const Job& one : errors) progress_.expect(name_of(one), workers);
    for (const Job& one : in_turn) progress_.expect(name_of(one));
    fmt::print("About {:.0f} s; what it has is kept if you interrupt it.\n", progress_.expected());
    run_side_by_side(errors.size(), workers, [&](std::size_t k) { run(errors[k], workers); });
    for (const Job& one : in_turn) run(one);
  }

  std::vector<Ratio> ratios(const std::string& program) {
    std::vector<Ratio> all;
    const fs::path path = context_.layout.build / "bin" / program;
    if (!fs::exists(path) || is_interrupted) return all;
    const auto result =
        sandbox::run_process({path.string()}, {.wall_seconds = 120, .stop = &is_interrupted});
    for (const std::string_view line : text::split(result.output, '\n')) {
      const auto parts = text::split(line, '\t');
      if (parts.size() != 6) continue;
      const auto number = [&](std::size_t i) { return std::strtod(parts[i].data(), nullptr); };
      all.push_back({std::string(parts[0]), std::string(parts[1]), number(2), number(3), number(4),
                     number(5)});
    }
    return all;
  }

  std::vector<BenchRow> rows() const {
    std::vector<BenchRow> all;
    for (const Contender& entrant : entrants_) {
      std::vector<BenchRow> mine;
      for (const Job& one : jobs_) {
        if (one.entrant != &entrant) continue;
        const auto some = read_bench_rows(one.rows, entrant.lab.name, entrant.label);
        mine.insert(mine.end(), some.begin(), some.end());
      }
      std::stable_sort(mine.begin(), mine.end(),
                       [](const BenchRow& a, const BenchRow& b) { return a.n < b.n; });
      all.insert(all.end(), mine.begin(), mine.end());
    }
    return medians(all);
  }

 private:
  Job job(const Contender& entrant, const std::string& kind, unsigned round) const {
    std::string label = entrant.label;
    std::replace(label.begin(), label.end(), '/', '_');
    return {&entrant, kind,
            place_ / "rows" / fmt::format("{}-{}.{}-{}.tsv", entrant.lab.name, label, kind, round)};
  }

  bool has_cases(const Lab& lab, const std::string& kind) {
    const auto [found, is_new] = has_cases_.try_emplace({lab.name, kind}, false);
    if (is_new) {
      found->second =
          fs::exists(context_.layout.measurements(lab.name)) &&
          !hidden_cases(context_.layout, lab, CaseKind::measurements, tag_of(kind)).empty();
    }
    return found->second;
  }
  static std::string tag_of(const std::string& kind) { return fmt::format("[.bench-{}]", kind); }

  void run(const Job& one, double workers = 1) {
    if (is_interrupted) return;
    progress_.begin(name_of(one));
    const auto start = Clock::now();
    run_hidden_cases(context_.layout, one.entrant->lab, CaseKind::measurements,
                     one.entrant->program, tag_of(one.kind),
                     {.environment = {{protocol::rows_variable, one.rows.string()}},
                      .wall_seconds = 300,
                      .stop = &is_interrupted});
    if (is_interrupted) return;
    progress_.end(name_of(one), std::chrono::duration<double>(Clock::now() - start).count(),
                  workers);
  }

  const Context& context_;
  fs::path place_;
  std::vector<Contender> entrants_;
  std::vector<Job> jobs_;
  std::map<std::pair<std::string, std::string>, bool> has_cases_;  // of a lab, of a kind
  BenchProgress progress_;
};

/// The machine and the version that were measured.
void describe_machine(const Layout& layout, Bench& bench) {
  bench.processor = "an unknown processor";
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) {
      bench.processor = line.substr(line.find(':') + 2);
      break;
    }
  }
  bench.cores = static_cast<unsigned>(sysconf(_SC_NPROCESSORS_ONLN));
  utsname system{};
  uname(&system);
  bench.system = fmt::format("{} {}", system.sysname, system.machine);
  const auto version = sandbox::run_process({layout.compiler, "--version"}).output;
  bench.compiler = version.substr(0, version.find('\n'));
  bench.flags = fmt::format("{}", fmt::join(compile_flags(), " "));
  bench.version = layout.version;
}

/// The lab of a file of the repository: autograder/submissions/<kind>/<lab>/<name>.cpp.
Lab lab_of_file(const Context& context, const fs::path& file) {
  if (!fs::is_regular_file(file)) throw UsageError("there is no file " + file.string());
  const fs::path folder = fs::canonical(file).parent_path();
  std::error_code missing;
  if (!fs::equivalent(folder.parent_path().parent_path(), context.layout.submissions(), missing)) {
    throw UsageError(file.string() + " is not in autograder/submissions/<kind>/<lab>");
  }
  return find_lab(context.labs, folder.filename().string());
}

int run_bench(const Context& context, const Arguments& arguments) {
  std::vector<Lab> labs, named;
  std::vector<Submission> submissions;
  const bool has_solutions = fs::exists(context.layout.solutions());
  if (has_solutions) {
    submissions.push_back(open_submission(context.labs, context.layout.solutions()));
    submissions.back().label = "solutions";
  }
  std::map<std::string, std::vector<Submission>> single;  // by lab
  for (const std::string& word : arguments.words) {
    if (fs::path(word).extension() == ".cpp") {
      const Lab lab = lab_of_file(context, word);
      single[lab.name].push_back(
          single_file_submission(context.layout, context.labs, lab, word, true));
      single[lab.name].back().label = fs::path(word).stem().string();
      named.push_back(lab);
    } else if (fs::is_directory(word)) {
      submissions.push_back(open_submission(context.labs, word));
      submissions.back().label = fs::path(word + "/").parent_path().string();
      if (is_reference(context.layout, submissions.back()) && submissions.size() > 1)
        submissions.pop_back();
    } else {
      named.push_back(find_lab(context.labs, word));
    }
  }
  for (const Lab& lab : context.labs) {  // in their order, each once
    const auto is_named = [&](const Lab& other) { return other.name == lab.name; };
    if (std::any_of(named.begin(), named.end(), is_named)) labs.push_back(lab);
  }
  Bench bench;
  bench.whole = labs.empty();
  bench.rounds = static_cast<unsigned>(
      std::clamp<std::uint64_t>(arguments.number("rounds").value_or(5), 1, 99));
  if (labs.empty()) labs = context.labs;
  if (arguments.has("calibrate")) {
    calibrate(context, labs, bench.rounds);
    return 0;
  }

  const auto start = Clock::now();
  const bool tables_only = arguments.has("tables");
  const fs::path place = context.layout.build / (tables_only ? "bench-tables" : "bench");
  {
    const StopOnInterrupt interrupts;
    BenchRun run(context, place);
    for (const Lab& lab : labs) {
      run.enter(lab, submissions);
      run.enter(lab, single[lab.name]);
      for (const std::string& library : peer_libraries(context.layout)) {
        if (const auto peer = peer_submission(context.layout, context.labs, lab, library)) {
          run.enter(lab, {*peer});
        }
      }
    }
    for (const std::string& library : peer_libraries(context.layout)) {
      if (!context.layout.peers.contains(library)) {
        fmt::print("{} is not installed: it is left out.\n", library);
      }
    }
    describe_machine(context.layout, bench);
    if (!tables_only) {
      bench.ratios = run.ratios("bench_ratios");
      bench.baseline = run.ratios("bench_ratios_baseline");
    }
    run.measure(bench.rounds, tables_only);
    bench.rows = run.rows();
  }
  if (tables_only) {
    fmt::print("\n{}", bench_tables(bench));
    return 0;
  }
  bench.whole = bench.whole && !is_interrupted;
  bench.peers = peers_of(context.layout, context.labs);
  bench.seconds = std::chrono::duration<double>(Clock::now() - start).count();

  write_text(place / "results.csv", bench_csv(bench));
  write_text(place / "results.json", bench_json(bench));
  const Plots plots = draw_bench(context.layout, bench, place);
  for (const std::string& remark : plots.remarks) fmt::print("{}\n", remark);
  fmt::print("\n{}\n", bench_summary(bench));
  fmt::print("{:.0f} s{}; {} (and .json), {} pictures next to it\n", bench.seconds,
             is_interrupted ? ", interrupted: results are partial" : "",
             (place / "results.csv").string(), plots.pictures.size());
  if (const auto page = arguments.get("page")) {
    const fs::path file = fs::absolute(*page);
    const fs::path pictures = file.parent_path() / file.stem();
    fs::create_directories(pictures);
    for (const fs::path& picture : plots.pictures) {
      if (picture.extension() != ".svg") continue;
      fs::copy_file(picture, pictures / picture.filename(), fs::copy_options::overwrite_existing);
    }
    const std::string outline = read_text(context.layout.root / "autograder" / "bench" / "page.md");
    write_text(file, bench_page(bench, outline, file.stem()));
    fmt::print("{}\n", file.string());
  }
  return 0;
}

const RegisterCommand bench_command{
    {.usage =
         "bench [LAB...] [DIR...] [FILE...] [--tables] [--rounds N] [--page FILE] [--calibrate]",
     .about = "measure speed against error: solutions, submissions, libraries",
     .details =
         "Measures every lab, unless some are named: the solutions, the installed libraries, each "
         "DIR and each FILE.cpp of autograder/submissions. Takes minutes, on an idle machine; an "
         "interrupted run keeps its results. Numbers and pictures go to build/bench/.",
     .options = {{"--tables",
                  "only the small tables, in a minute: the worth of each next2() of a sampler, the "
                  "cost of a number at small sample sizes, the tails of scrambling, and what "
                  "handouts quote"},
                 {"--rounds N", "time everything N times, in turn (5)"},
                 {"--page FILE", "also write the page: docs/speed-against-error.md"},
                 {"--calibrate",
                  "only write labs/*/speed.tsv: the solutions' times, from which a handout "
                  "estimates the reference's speed"}},
     .run = run_bench,
     .for_instructors = true,
     .place = "autograder/bench",
     .targets = [](const Context&, const Arguments&) {
       return std::vector<std::string>{"judge_all", "bench_programs"};
     }}};

}  // namespace
}  // namespace mc::grader
