// bench: speed against error, of the solutions, of any submission, and of libraries.

#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "bench/bench.hpp"
#include "commands/command.hpp"
#include "judge/judging/judge.hpp"
#include "judge/reports/progress_line.hpp"
#include "judge/submission/build.hpp"
#include "judge/submission/compile.hpp"
#include "protocol/environment.hpp"
#include "runner/text.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {
namespace {

/// A lab's program of a submission, to be measured.
struct Contender {
  Lab lab;
  std::string label;
  sandbox::Program program;
};

/// Of the solutions, of `submissions` and of the libraries; a remark on those that do not compile.
std::vector<Contender> contenders(const Context& context, const std::vector<Lab>& labs,
                                  const std::vector<std::pair<std::string, Submission>>& others) {
  std::vector<Contender> all;
  for (const Lab& lab : labs) {
    std::vector<Submission> submissions;
    if (std::filesystem::exists(context.layout.solutions())) {
      submissions.push_back(open_submission(context.labs, context.layout.solutions()));
      submissions.back().label = "solutions";
    }
    for (const auto& [only, submission] : others) {
      if (only.empty() || only == lab.name) submissions.push_back(submission);
    }
    for (const std::string& library : peer_libraries(context.layout)) {
      const auto peer = peer_submission(context.layout, context.labs, lab, library);
      if (peer) submissions.push_back(*peer);
    }
    for (const Submission& submission : submissions) {
      if (!submission.files.contains(lab.name)) continue;
      BuildResult built = build_program(context.layout, lab, submission);
      if (built.program) {
        all.push_back({lab, submission.label, std::move(*built.program)});
      } else {
        fmt::print("{} is not benched: {}\n", submission.label, built.failure);
      }
    }
  }
  return all;
}

/// What a contender's hidden cases with this tag write.
fs::path measured(const Context& context, const Contender& one, const std::string& tag,
                  const fs::path& place) {
  std::string name = one.lab.name + '-' + one.label;
  std::ranges::replace(name, '/', '_');
  const fs::path file = place / "rows" / (name + ".csv");
  if (!fs::exists(context.layout.measurements(one.lab.name))) return file;  // none to run
  run_hidden_cases(
      context.layout, one.lab, CaseKind::measurements, one.program, tag,
      {.environment = {{protocol::rows_variable, file.string()}}, .wall_seconds = 600});
  return file;
}

/// What a program of autograder/bench/ratios prints.
std::vector<protocol::Row> rows_of(const Context& context, const std::string& program,
                                   const std::vector<std::string>& words = {}) {
  std::vector<std::string> command{(context.layout.build / "bin" / program).string()};
  if (!fs::exists(command[0])) return {};
  command.insert(command.end(), words.begin(), words.end());
  std::vector<protocol::Row> rows;
  const auto result = sandbox::run_process(command, {.wall_seconds = 600});
  for (const std::string_view line : text::split(result.output, '\n')) {
    if (auto row = protocol::row_in(line)) rows.push_back(std::move(*row));
  }
  return rows;
}

/// The machine and the version that are measured.
std::string described_machine(const Layout& layout) {
  std::string processor = "an unknown processor";
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("model name")) continue;
    processor = line.substr(line.find(':') + 2);
    break;
  }
  utsname system{};
  uname(&system);
  const auto version = sandbox::run_process({layout.compiler, "--version"}).output;
  return fmt::format("{}, {} cores, {} {}; {}; `{}`; version {}", processor,
                     sysconf(_SC_NPROCESSORS_ONLN), system.sysname, system.machine,
                     version.substr(0, version.find('\n')), fmt::join(compile_flags(), " "),
                     layout.version);
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

/// The tables that a contender's cases wrote; of others than the solutions, each title says whose.
void print_tables(const std::string& text, const std::string& label) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find("\n\n", at), text.size());
    const std::string paragraph = text.substr(at, end - at);
    const bool is_title = !paragraph.starts_with('|') && label != "solutions";
    fmt::print("\n{}{}\n", paragraph, is_title ? ", " + label : "");
    at = end + 2;
  }
}

int run_bench(const Context& context, const Arguments& arguments) {
  std::vector<Lab> labs;
  std::vector<std::pair<std::string, Submission>> others;  // the only lab of each, or all
  for (const std::string& word : arguments.words) {
    if (fs::path(word).extension() == ".cpp") {
      labs.push_back(lab_of_file(context, word));
      others.emplace_back(labs.back().name, single_file_submission(context.layout, context.labs,
                                                                   labs.back(), word, true));
      others.back().second.label = fs::path(word).stem().string();
    } else if (fs::is_directory(word)) {
      Submission submission = open_submission(context.labs, word);
      submission.label = fs::path(word + "/").parent_path().string();
      if (!is_reference(context.layout, submission)) others.emplace_back("", submission);
    } else {
      labs.push_back(find_lab(context.labs, word));
    }
  }
  const bool is_whole = labs.empty();
  if (is_whole) labs = context.labs;
  std::ranges::sort(labs, {}, &Lab::number);  // each once
  const auto is_same = [](const Lab& a, const Lab& b) { return a.number == b.number; };
  labs.erase(std::unique(labs.begin(), labs.end(), is_same), labs.end());

  const auto start = std::chrono::steady_clock::now();
  const bool tables_only = arguments.has("tables");
  const fs::path place = context.layout.build / (tables_only ? "bench-tables" : "bench");
  fs::remove_all(place);
  fs::create_directories(place / "rows");
  Bench bench;
  {
    ProgressLine progress("bench");
    const auto all = contenders(context, labs, others);
    if (!tables_only && is_whole) {
      progress.show(0, static_cast<double>(all.size()), "ratios");
      bench.ratios = protocol::comparisons_in(rows_of(context, "bench_ratios"));
      bench.baseline = protocol::comparisons_in(rows_of(context, "bench_ratios_baseline"));
      bench.samplers = rows_of(context, "bench_ratios", {"samplers"});
    }
    double done = 0;
    for (const Contender& one : all) {
      progress.show(done++, static_cast<double>(all.size()), one.lab.name + ' ' + one.label);
      const fs::path file =
          measured(context, one, tables_only ? "[.bench-table]" : "[.bench]", place);
      if (tables_only) {
        progress.clear();
        print_tables(read_text(file), one.label);
        continue;
      }
      for (protocol::Row row : protocol::rows_in(file)) {
        row.lab = one.lab.name;
        if (one.label != "solutions") row.method += ", " + one.label;
        bench.rows.push_back(row);
      }
    }
  }
  if (tables_only) return 0;
  bench.machine =
      fmt::format("{}; {:.0f} s.{}", described_machine(context.layout),
                  std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
                  is_whole ? "" : " Not all labs were measured.");

  std::string all = std::string(protocol::rows_header) + '\n';
  for (const auto& rows : {bench.rows, bench.samplers}) {
    for (const protocol::Row& row : rows) all += line_of(row) + '\n';
  }
  write_text(place / "rows.csv", all);
  const Plots plots = draw_bench(context.layout, bench, place);
  for (const std::string& remark : plots.remarks) fmt::print("{}\n", remark);
  fmt::print("{}\n{}\n", bench_summary(bench), (place / "rows.csv").string());
  if (const auto page = arguments.get("page")) {
    const fs::path file = fs::absolute(*page), pictures = file.parent_path() / file.stem();
    fs::create_directories(pictures);
    for (const fs::path& picture : plots.pictures) {
      fs::copy_file(picture, pictures / picture.filename(), fs::copy_options::overwrite_existing);
    }
    const std::string outline = read_text(context.layout.root / "autograder" / "bench" / "page.md");
    write_text(file, bench_page(bench, outline, file.stem()));
    fmt::print("{}\n", file.string());
  }
  return 0;
}

const RegisterCommand bench_command{
    {.usage = "bench [LAB...] [DIR...] [FILE...] [--tables] [--page FILE]",
     .about = "measure speed against error: solutions, submissions, libraries",
     .details =
         "Measures every lab, unless some are named: the solutions, the installed libraries, each "
         "DIR and each FILE.cpp of autograder/submissions. Takes minutes, on an idle machine. "
         "Numbers and pictures go to build/bench/.",
     .options = {{"--tables", "only the tables that documents show: numbers without times"},
                 {"--page FILE", "also write the page: docs/speed-against-error.md"}},
     .run = run_bench,
     .for_instructors = true,
     .place = "autograder/bench",
     .targets = [](const Context&, const Arguments&) {
       return std::vector<std::string>{"judge_all", "bench_programs"};
     }}};

}  // namespace
}  // namespace mc::grader
