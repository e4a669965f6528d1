#include "judge/judging/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace mc::grader {

namespace {

template <class Item, class Value>
double sum(const std::vector<Item>& items, Value value) {
  double total = 0;
  for (const Item& item : items) total += value(item);
  return total;
}

}  // namespace

double LabVerdict::earned() const {
  return sum(checks, [](auto& result) { return result.earned(); });
}
double LabVerdict::points() const {
  return sum(checks, [](auto& result) { return result.check.points; });
}
double Verdict::earned() const {
  return sum(labs, [](auto& lab) { return lab.earned(); });
}
double Verdict::points() const {
  return sum(labs, [](auto& lab) { return lab.points(); });
}

std::optional<double> LabVerdict::times_plain() const {
  double logarithms = 0, count = 0;
  for (const Speed& one : speed) {
    if (!one.plain) continue;
    logarithms += std::log(*one.plain / one.nanoseconds);
    ++count;
  }
  if (count == 0) return {};
  return std::exp(logarithms / count);
}

int task_number(const std::string& task) {
  return std::atoi(task.c_str() + std::min(task.size(), task.find('.') + 1));
}

std::string describe(const CheckResult& result, const LabVerdict& verdict) {
  const auto is_unfinished = [&](const std::string& need) {
    const auto& labs = verdict.unfinished;
    return std::ranges::find(labs, need) != labs.end();
  };
  const auto is_not_passed = [&](const std::string& need) {
    return std::ranges::any_of(verdict.checks, [&](auto& other) {
      return other.check.task == need && other.status != Status::passed;
    });
  };
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
        if (need == result.check.task) return "wrong, too, probably for the same reason";
        if (is_unfinished(need)) return "waiting for " + lab_or_task(need);
        if (is_not_passed(need)) return "waiting for " + need;
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

std::string lab_or_task(const std::string& need) {
  return (need.find('.') == std::string::npos ? "lab " : "task ") + need;
}

}  // namespace mc::grader
