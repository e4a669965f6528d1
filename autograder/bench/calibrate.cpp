// bench --calibrate: stores the reference's times with each lab, for handouts without solutions.

#include <map>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/bench.hpp"
#include "grader/base/errors.hpp"
#include "grader/base/text_file.hpp"
#include "grader/judging/speed.hpp"
#include "grader/submission/build.hpp"
#include "grader/submission/submission.hpp"

namespace mc::grader {
namespace {

/// The names of all possible tasks of a lab.
std::set<std::string> tasks_of(const Lab& lab) {
  std::set<std::string> tasks;
  for (int task = 1; task < 100; ++task) tasks.insert(fmt::format("{}.{}", lab.number, task));
  return tasks;
}

/// The median time of each speed task over `rounds`, in additions of a running sum.
std::map<std::string, double> ratios_of(const Layout& layout, const Lab& lab,
                                        const sandbox::Program& program, unsigned rounds) {
  std::map<std::string, std::vector<double>> ratios;
  for (unsigned round = 0; round < rounds; ++round) {
    std::map<std::string, double> additions;
    for (const protocol::Row& row : speed_rows(layout, lab, program, tasks_of(lab))) {
      if (row.kind == "speed unit") additions[row.what] = row.value;
      if (row.kind == "speed") ratios[row.what].push_back(row.value / additions.at(row.what));
    }
  }
  std::map<std::string, double> medians;
  for (const auto& [name, all] : ratios) medians[name] = median(all);
  return medians;
}

}  // namespace

void calibrate(const Context& context, const std::vector<Lab>& labs, unsigned rounds) {
  const Submission solutions = open_submission(context.labs, context.layout.solutions());
  for (const Lab& lab : labs) {
    const BuildResult built = build_program(context.layout, lab, solutions);
    if (!built.program) throw MachineError(built.failure);
    std::string text =
        "# What the reference takes, in additions of a running sum: ./lab bench --calibrate\n";
    for (const auto& [name, ratio] : ratios_of(context.layout, lab, *built.program, rounds)) {
      text += fmt::format("{}\t{:.3g}\n", name, ratio);
    }
    write_text(ratios_file(context.layout, lab), text);
    fmt::print("{}\n{}", ratios_file(context.layout, lab).string(), text);
  }
}

}  // namespace mc::grader
