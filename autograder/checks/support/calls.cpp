#include "checks/support/catch.hpp"

#include <numeric>
#include <vector>

#include <fmt/format.h>

#include "checks/support/measure.hpp"

namespace mc::checks {
namespace {

struct ReplayedCall {
  std::string call, request;
  wire::Status status;
  std::string bytes;
};
std::vector<ReplayedCall> kept_calls;

// A replay takes about as long as one measurement at most.
constexpr std::size_t most_replayed = 12, largest = std::size_t{1} << 18;
constexpr double most_seconds = 0.01;

/// Fails the check if one of its calls gives a different result after other calls.
void replay() {
  std::vector<ReplayedCall> calls(kept_calls.rbegin(), kept_calls.rend());
  if (calls.size() > most_replayed) {  // the latest and the first
    calls.erase(calls.begin() + most_replayed / 2, calls.end() - most_replayed / 2);
  }
  if (calls.empty()) return;
  std::vector<std::size_t> order(calls.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  order.push_back(calls.size() - 1);  // the last one twice in a row
  std::vector<std::string> requests;
  for (const std::size_t i : order) requests.push_back(calls[i].request);
  const auto fail_at = [&](std::size_t k, const std::string& what) {
    fail(Failure{fmt::format("{} {}", calls[order[k]].call, what),
                 "the same result as from the first call of a process",
                 "a result depends on the arguments only, not on earlier calls",
                 "a static or global variable keeps its value between calls"_likely});
  };
  wire::Writer request;
  request.put(std::string());  // no experiment: a list of requests
  request.put(requests);
  const sandbox::Outcome outcome = run_program(request.bytes, {});
  std::vector<std::string> answers;  // each is a status byte and the bytes of a result
  if (outcome.answered && outcome.status == wire::Status::value) {
    answers = decoded<std::vector<std::string>>(outcome.bytes).value_or(answers);
  }
  if (answers.size() != order.size()) {
    fail_at(order.size() - 1, fmt::format("ends the program after other calls: {}",
                                          outcome.failure.empty() ? "no answer" : outcome.failure));
  }
  for (std::size_t k = 0; k < order.size(); ++k) {
    const ReplayedCall& alone = calls[order[k]];
    const std::string& answer = answers[k];
    const bool is_same = !answer.empty() && answer[0] == static_cast<char>(alone.status) &&
                         (alone.status != wire::Status::value || answer.substr(1) == alone.bytes);
    if (is_same) continue;
    fail_at(k, k == 0 ? "gives different results in two processes"
               : order[k] == order[k - 1]
                   ? "gives a different result when it is called twice"
                   : "gives a different result after " + calls[order[k - 1]].call);
  }
}

}  // namespace

void keep_call(const std::string& call, const std::string& request,
               const sandbox::Outcome& outcome) {
  if (!outcome.answered || outcome.cpu_seconds > most_seconds) return;
  if (request.size() > largest || outcome.bytes.size() > largest) return;
  kept_calls.push_back({call, request, outcome.status, outcome.bytes});
}

void run_check(void (*body)(Rng&)) {
  kept_calls.clear();  // without the grader, several checks run in one process
  Rng rng = check_rng();
  body(rng);
  replay();
}

}  // namespace mc::checks
