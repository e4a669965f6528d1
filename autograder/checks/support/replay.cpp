#include "checks/support/replay.hpp"

#include <vector>

#include <fmt/format.h>

#include "checks/support/measure.hpp"

namespace mc::checks {
namespace {

struct Kept {
  std::string call, request;
  wire::Status status;
  std::string bytes;
};
std::vector<Kept> kept;

// A replay costs a check no more than about one of its measurements.
constexpr std::size_t most_kept = 12, largest = std::size_t{1} << 18;
constexpr double most_seconds = 0.01;

}  // namespace

void keep_for_replay(const std::string& call, const std::string& request,
                     const sandbox::Outcome& outcome) {
  if (!outcome.answered || outcome.cpu_seconds > most_seconds) return;
  if (request.size() > largest || outcome.bytes.size() > largest) return;
  if (kept.size() >= most_kept) kept.erase(kept.begin() + most_kept / 2);  // the first, the latest
  kept.push_back({call, request, outcome.status, outcome.bytes});
}

void replay() {
  const std::vector<Kept> calls(kept.rbegin(), kept.rend());
  kept.clear();
  if (calls.empty()) return;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < calls.size(); ++i) order.push_back(i);
  order.push_back(calls.size() - 1);  // the last one twice in a row
  wire::Writer request;
  request.put(std::string());  // no experiment: a list of requests
  std::vector<std::string> requests;
  for (const std::size_t i : order) requests.push_back(calls[i].request);
  request.put(requests);
  const auto fail_at = [&](std::size_t k, const std::string& what) {
    fail(Failure{fmt::format("{} {}", calls[order[k]].call, what),
                 "the same result as when it is the first call",
                 "a function of its arguments, whatever was called before: checks call it in one "
                 "process and in another",
                 "a static or global variable keeps something between calls"});
  };
  const Call together =
      ask_again(fmt::format("{} and {} calls before it", calls.back().call, calls.size()),
                std::move(request.bytes));
  const sandbox::Outcome& outcome = together.outcome;
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

void run_check(void (*body)()) {
  kept.clear();
  body();
  replay();
}

}  // namespace mc::checks
