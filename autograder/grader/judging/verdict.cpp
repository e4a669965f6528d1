#include "grader/judging/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace mc::grader {

double LabVerdict::earned() const {
  double total = 0;
  for (const auto& result : checks) total += result.earned();
  return total;
}

double LabVerdict::points() const {
  double total = 0;
  for (const auto& result : checks) total += result.check.points;
  return total;
}

std::optional<double> LabVerdict::times_the_reference() const {
  double logarithms = 0, count = 0;
  for (const Speed& one : speed) {
    if (!one.reference) continue;
    logarithms += std::log(*one.reference / one.nanoseconds);
    ++count;
  }
  if (count == 0) return {};
  return std::exp(logarithms / count);
}

double Verdict::earned() const {
  double total = 0;
  for (const auto& lab : labs) total += lab.earned();
  return total;
}

double Verdict::points() const {
  double total = 0;
  for (const auto& lab : labs) total += lab.points();
  return total;
}

int task_number(const std::string& task) {
  return std::atoi(task.c_str() + std::min(task.size(), task.find('.') + 1));
}

std::string describe(const CheckResult& result, const LabVerdict& verdict) {
  switch (result.status) {
    case Status::passed:
      return "passed";
    case Status::failed:
      return "failed";
    case Status::not_written:
      return "not written yet";
    case Status::withheld:
      return "passed; counts once the main check of " + result.check.task + " passes";
    case Status::waiting:
      for (const std::string& need : result.check.needs) {
        for (const std::string& lab : verdict.unfinished) {
          if (lab != need) continue;
          return need.find('.') == std::string::npos ? "waiting for lab " + need
                                                     : "waiting for task " + need;
        }
        for (const auto& other : verdict.checks) {
          if (other.check.task == need && other.status != Status::passed)
            return "waiting for " + need;
        }
      }
      return "waiting";
    case Status::not_run:
      return "not run";
    case Status::not_judged:
      return "not judged";
    case Status::internal_error:
      break;
  }
  return "internal error of the autograder";
}

}  // namespace mc::grader
