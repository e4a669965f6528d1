#include "judge/judging/judge_submission.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "judge/base/errors.hpp"
#include "judge/base/text_file.hpp"
#include "judge/judging/speed.hpp"
#include "judge/submission/compile.hpp"
#include "judge/submission/source.hpp"

namespace mc::grader {
namespace {

/// Builds the program within the submission's budget.
BuildResult build_within(const Context& context, const Lab& lab, const Submission& submission,
                         const JudgeOptions& options) {
  if (options.budget != nullptr && options.budget->is_used_up()) {
    BuildResult none;
    none.failure = Budget::why() + ".";
    return none;
  }
  // One worker: the others have other submissions.
  BuildResult built =
      build_program(context.layout, lab, submission, options.workers == 1 ? 1 : cores());
  if (options.budget != nullptr) options.budget->use(built.cpu_seconds);
  return built;
}

/// The submission with the reference's files of the labs that this one depends on.
Submission on_reference(const Context& context, Submission submission, const Lab& lab) {
  for (const std::string& name : lab.depends_on) {
    const std::filesystem::path file =
        context.layout.solutions() / find_lab(context.labs, name).file();
    if (!std::filesystem::exists(file)) {
      throw UsageError("--with-reference needs the solutions, which a handout does not have");
    }
    submission.files[name] = file;
  }
  return submission;
}

/// Compiles the files of several labs at the same time, for their programs to be linked from. The
/// lab that depends on most others has them all.
void compile_side_by_side(const Context& context, const Submission& submission,
                          const std::vector<Lab>& labs, const JudgeOptions& options) {
  if (labs.size() < 2 || options.workers == 1) return;
  build_within(context,
               *std::ranges::max_element(labs,
                                         [](const Lab& one, const Lab& other) {
                                           return one.depends_on.size() < other.depends_on.size();
                                         }),
               submission, options);
}

/// Does the submission have full marks in this lab ("3"), or in this task ("1.4")? Judges it if
/// that is not known yet. Yes if the checks of that lab are not built: ./lab check builds those of
/// its own lab.
class CompletionCache {
 public:
  CompletionCache(const Context& context, const Submission& submission, const JudgeOptions& options)
      : context_(context), submission_(submission), options_(options) {
    options_.only.clear();
    options_.progress = {};
  }

  void add(const LabVerdict& verdict) {
    const std::string lab = std::to_string(verdict.lab.number);
    known_[lab] = verdict.earned() == verdict.points();
    for (const CheckResult& result : verdict.checks) known_[result.check.task] = true;
    for (const CheckResult& result : verdict.checks) {
      if (result.status != Status::passed) known_[result.check.task] = false;
    }
  }

  bool operator()(const std::string& need) {
    if (!known_.contains(need)) {
      const auto dot = need.find('.');
      const Lab& lab = find_lab(context_.labs, need.substr(0, dot));
      if (!std::filesystem::exists(context_.layout.checks(lab.name))) return known_[need] = true;
      options_.only = dot == std::string::npos ? "" : need;
      const auto checks = expected_checks(context_.layout, lab);
      const auto is_about = [&](const Check& check) { return check.task == need; };
      if (dot != std::string::npos && std::ranges::none_of(checks, is_about)) {
        return known_[need] = true;  // points.csv leaves it out
      }
      const BuildResult built = build_within(context_, lab, submission_, options_);
      const LabVerdict verdict = judge_lab(context_.layout, lab, built, options_);
      known_[need] = verdict.earned() == verdict.points();
    }
    return known_[need];
  }

 private:
  const Context& context_;
  const Submission& submission_;
  JudgeOptions options_;
  std::map<std::string, bool> known_;
};

/// The first check without a verdict, and why.
std::string fault_in(const LabVerdict& judged) {
  for (const CheckResult& result : judged.checks) {
    if (result.status != Status::not_judged && result.status != Status::internal_error) continue;
    return fmt::format("{}: {}", result.check.name, result.report);
  }
  return {};
}

/// Keeps what the autograder failed on, so that it can be looked into.
void keep_for_report(const Layout& layout, const Submission& submission, const Verdict& verdict) {
  std::error_code ignored;  // the disk may be full
  const auto place = layout.build / "not-judged" /
                     fmt::format("{}-{:08x}", verdict.seed,
                                 static_cast<std::uint32_t>(hash_text(verdict.submission)));
  std::filesystem::create_directories(place, ignored);
  for (const auto& [lab, file] : submission.files) {
    if (std::filesystem::file_size(file, ignored) > longest_source) continue;
    std::filesystem::copy_file(file, place / file.filename(),
                               std::filesystem::copy_options::overwrite_existing, ignored);
  }
}

}  // namespace

void add_speed(const Context& context, const Submission& submission, LabVerdict& judged) {
  if (!judged.no_program.empty()) return;
  const BuildResult fast = build_program(context.layout, judged.lab, submission);
  if (fast.program) judged.speed = measure_speed(context.layout, judged, *fast.program);
}

Verdict judge_submission(const Context& context, const Submission& submission,
                         const std::vector<Lab>& labs, const SubmissionOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  Verdict verdict;
  verdict.submission = submission.label;
  verdict.found_in = submission.found_in;
  verdict.seed = options.judge.seed;
  verdict.version = context.layout.version;
  verdict.flags = fmt::format("{}", fmt::join(compile_flags(), " "));
  verdict.jail_complete = sandbox::jail_is_complete();
  verdict.reads_confined = sandbox::places_are_enforced();

  JudgeOptions judge = options.judge;
  std::error_code none;
  const bool own = std::filesystem::equivalent(submission.path, context.layout.starter(), none);
  judge.submission = own ? "" : submission.path.string();
  CompletionCache finished(context, submission, judge);
  const auto all = static_cast<double>(labs.size());
  if (labs.size() > 1 && options.progress) options.progress(0, all, "compiling");
  if (!judge.with_reference) compile_side_by_side(context, submission, labs, judge);
  for (std::size_t i = 0; i < labs.size(); ++i) {
    const Lab& lab = labs[i];
    const auto show_progress = [&](double part, const std::string& what) {
      if (options.progress) options.progress(static_cast<double>(i) + part, all, what);
    };
    show_progress(0, "compiling " + lab.file());
    const bool is_mixed = judge.with_reference && !lab.depends_on.empty();
    const BuildResult built = build_within(
        context, lab, is_mixed ? on_reference(context, submission, lab) : submission, judge);
    judge.progress = [&](std::size_t done, std::size_t checks) {
      show_progress(static_cast<double>(done) / static_cast<double>(checks), "judging " + lab.name);
    };
    LabVerdict judged = judge_lab(context.layout, lab, built, judge);
    if (is_mixed) {
      judged.on_reference = lab.depends_on;
    } else {
      wait_for_labs(judged, std::ref(finished));
    }
    if (judge.only.empty()) finished.add(judged);
    if (judge.only.empty() && options.with_speed && built.program) {
      show_progress(1, "timing " + lab.name);
      judged.speed = measure_speed(context.layout, judged, *built.program);
    }
    if (verdict.not_judged.empty()) verdict.not_judged = fault_in(judged);
    verdict.labs.push_back(std::move(judged));
  }
  if (!verdict.not_judged.empty()) keep_for_report(context.layout, submission, verdict);
  for (const Lab& lab : context.labs) {
    if (!submission.files.contains(lab.name)) verdict.absent.push_back(lab.name);
  }
  verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return verdict;
}

}  // namespace mc::grader
