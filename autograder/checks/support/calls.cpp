#include "checks/support/catch.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "checks/support/measure.hpp"

namespace mc::checks {
namespace {

struct KeptCall {
  std::string experiment;
  Call made;
  std::string request;
  Arguments arguments;
};
std::vector<KeptCall> kept_calls;

// A replay takes about as long as one measurement at most.
constexpr std::size_t most_replayed = 12, most_between = 24, largest = std::size_t{1} << 18;
constexpr double most_seconds = 0.01;

/// A call of the replay; those in between have no expected result.
struct Step {
  std::string text, request;
  const KeptCall* expected = nullptr;
};

/// The answers to the steps, in one process, each a status byte and the bytes of a result; fewer if
/// the process ended, for the reason in `failure`.
std::vector<std::string> answers_to(std::span<const Step> steps, std::string& failure) {
  std::vector<std::string> requests;
  for (const Step& step : steps) requests.push_back(step.request);
  wire::Writer request;
  request.put(std::string());  // no experiment: a list of requests
  request.put(requests);
  const sandbox::Outcome outcome = run_program(request.bytes, {});
  if (!outcome.answered || outcome.status != wire::Status::value) {
    failure = outcome.failure.empty() ? "no answer" : outcome.failure;
    return {};
  }
  return decoded<std::vector<std::string>>(outcome.bytes).value_or(std::vector<std::string>());
}

[[noreturn]] void fail_at(const Step& step, const std::string& what) {
  fail(Failure{step.text + ' ' + what, "the same result as from the first call of a process",
               "a result depends on the arguments only, not on earlier calls",
               "a static or global variable keeps its value between calls"_likely});
}

void compare(std::span<const Step> steps, std::span<const std::string> answers) {
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (steps[k].expected == nullptr) continue;
    const sandbox::Outcome& alone = steps[k].expected->made.outcome;
    const std::string& answer = answers[k];
    const bool is_same = !answer.empty() && answer[0] == static_cast<char>(alone.status) &&
                         (alone.status != wire::Status::value || answer.substr(1) == alone.bytes);
    if (is_same) continue;
    fail_at(steps[k], k == 0 ? "gives different results in two processes"
                      : steps[k].request == steps[k - 1].request
                          ? "gives a different result when it is called twice"
                          : "gives a different result after " + steps[k - 1].text);
  }
}

/// The latest calls and the first, each after calls that differ from it in one argument.
std::vector<Step> steps_of_replay() {
  std::vector<const KeptCall*> calls;
  for (auto call = kept_calls.rbegin(); call != kept_calls.rend(); ++call) calls.push_back(&*call);
  if (calls.size() > most_replayed) {
    calls.erase(calls.begin() + most_replayed / 2, calls.end() - most_replayed / 2);
  }
  std::vector<Step> steps;
  std::size_t between = 0;
  for (const KeptCall* call : calls) {
    for (std::size_t k = 0; k < call->arguments.count; ++k) {
      for (const KeptCall* other : calls) {
        if (other->experiment != call->experiment || between == most_between) continue;
        auto one = call->arguments.with_smaller(k, other->arguments.values.get());
        if (!one) continue;
        steps.push_back({std::move(one->text), std::move(one->request)});
        steps.push_back({call->made.text, call->request, call});
        ++between;
        break;
      }
    }
    if (steps.empty() || steps.back().expected != call) {
      steps.push_back({call->made.text, call->request, call});
    }
  }
  if (!steps.empty()) steps.push_back(steps.back());  // the last one twice in a row
  return steps;
}

/// Fails the check if one of its calls gives a different result after other calls.
void replay() {
  const std::vector<Step> steps = steps_of_replay();
  if (steps.empty()) return;
  std::string failure;
  if (const auto answers = answers_to(steps, failure); answers.size() == steps.size()) {
    return compare(steps, answers);
  }
  // Those in between may be invalid, and end the program by themselves.
  std::vector<Step> made;
  std::ranges::copy_if(steps, std::back_inserter(made), [](auto& one) { return one.expected; });
  const auto answers = answers_to(made, failure);
  if (answers.size() != made.size()) {
    fail_at(made.back(), "ends the program after other calls: " + failure);
  }
  compare(made, answers);
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (steps[k].expected != nullptr) continue;
    const auto both = std::array{steps[k], *std::find_if(steps.begin() + k, steps.end(),
                                                         [](auto& one) { return one.expected; })};
    if (answers_to(std::span(both).first(1), failure).empty()) continue;
    const auto two = answers_to(both, failure);
    if (two.size() != 2)
      fail_at(both[1], "ends the program after " + both[0].text + ": " + failure);
    compare(both, two);
  }
}

}  // namespace

void keep_call(std::string_view experiment, const Call& made, const std::string& request,
               Arguments arguments) {
  const sandbox::Outcome& outcome = made.outcome;
  if (!outcome.answered || outcome.cpu_seconds > most_seconds) return;
  if (request.size() > largest || outcome.bytes.size() > largest) return;
  kept_calls.push_back({std::string(experiment), made, request, std::move(arguments)});
}

void run_check(void (*body)(Rng&)) {
  kept_calls.clear();  // without the grader, several checks run in one process
  Rng rng = check_rng();
  body(rng);
  replay();
}

}  // namespace mc::checks
