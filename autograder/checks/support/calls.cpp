#include "checks/support/calls.hpp"

#include <vector>

#include <fmt/format.h>

#include "checks/support/measure.hpp"

namespace mc::checks {
namespace {

struct Kept {
  std::string call, request;
  wire::Status status;
  std::string bytes;
  double cpu_seconds;
};
std::vector<Kept> kept_calls;

// A replay costs a check no more than about one of its measurements.
constexpr std::size_t most_replayed = 12, largest = std::size_t{1} << 18;
constexpr double most_seconds = 0.01;

/// The answers to a list of requests in one process, each a status in one byte and its bytes.
std::vector<std::string> answers_in(const sandbox::Outcome& outcome) {
  std::vector<std::string> answers;
  try {
    if (outcome.answered && outcome.status == wire::Status::value) {
      wire::Reader from(outcome.bytes);
      answers = from.get<std::vector<std::string>>();
      from.end();
    }
  } catch (const wire::malformed&) {
    answers.clear();
  }
  return answers;
}

std::string request_of(const std::vector<std::string>& requests) {
  wire::Writer request;
  request.put(std::string());  // no experiment: a list of requests
  request.put(requests);
  return std::move(request.bytes);
}

/// Ends the check where a measurement of it gives another result after others.
void replay() {
  std::vector<Kept> calls(kept_calls.rbegin(), kept_calls.rend());
  if (calls.size() > most_replayed) {  // the latest and the first
    calls.erase(calls.begin() + most_replayed / 2, calls.end() - most_replayed / 2);
  }
  if (calls.empty()) return;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < calls.size(); ++i) order.push_back(i);
  order.push_back(calls.size() - 1);  // the last one twice in a row
  std::vector<std::string> requests;
  for (const std::size_t i : order) requests.push_back(calls[i].request);
  const auto fail_at = [&](std::size_t k, const std::string& what) {
    fail(Failure{fmt::format("{} {}", calls[order[k]].call, what),
                 "the same result as when it is the first call",
                 "a function of its arguments, whatever was called before: checks call it in one "
                 "process and in another",
                 "a static or global variable keeps something between calls"});
  };
  const sandbox::Outcome outcome = run_program(request_of(requests), {});
  const auto answers = answers_in(outcome);
  if (answers.size() != order.size()) {
    fail_at(order.size() - 1, fmt::format("ends the program after other calls: {}",
                                          outcome.failure.empty() ? "no answer" : outcome.failure));
  }
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Kept& alone = calls[order[k]];
    const std::string& answer = answers[k];
    const bool is_same = !answer.empty() && answer[0] == static_cast<char>(alone.status) &&
                         (alone.status != wire::Status::value || answer.substr(1) == alone.bytes);
    if (is_same) continue;
    fail_at(k, k == 0 ? "gives two results in two processes"
               : order[k] == order[k - 1]
                   ? "gives another result when it is called twice"
                   : "gives another result after " + calls[order[k - 1]].call);
  }
}

}  // namespace

void keep_call(const std::string& call, const std::string& request,
               const sandbox::Outcome& outcome) {
  if (!outcome.answered || outcome.cpu_seconds > most_seconds) return;
  if (request.size() > largest || outcome.bytes.size() > largest) return;
  kept_calls.push_back({call, request, outcome.status, outcome.bytes, outcome.cpu_seconds});
}

void run_check(void (*body)()) {
  kept_calls.clear();  // by hand, several checks run in one process
  body();
  replay();
}

}  // namespace mc::checks
