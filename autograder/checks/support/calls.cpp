#include "checks/support/calls.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "checks/support/measure.hpp"
#include "protocol/environment.hpp"

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

// What is sent ahead: a tenth of a second of work for the submission that was asked first. Of one
// that takes five times as long, calls are made one by one.
constexpr std::size_t most_bytes = std::size_t{4} << 20;
constexpr double most_seconds_ahead = 0.1;
constexpr sandbox::Limits limits_ahead{.cpu_seconds = 1, .wall_seconds = 0.5};

struct SentAhead {
  std::string request, answer;
  bool is_used = false;
};
std::vector<SentAhead> ahead;
std::size_t next_ahead = 0;

struct Retry {};

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

/// What is not written, or runs out of memory, is asked alone.
bool is_sendable(wire::Status status) {
  return status == wire::Status::value || status == wire::Status::invalid_argument ||
         status == wire::Status::out_of_range;
}

std::string request_of(const std::vector<std::string>& requests) {
  wire::Writer request;
  request.put(std::string());  // no experiment: a list of requests
  request.put(requests);
  return std::move(request.bytes);
}

/// The file for the calls of this check with this seed; empty for none.
std::string file_of_calls() {
  const char* const file = std::getenv(protocol::calls_variable);
  return file == nullptr ? "" : file;
}

/// Sends the calls ahead that the last submission was asked, if all of them get an answer.
void send_ahead() {
  std::ifstream file(file_of_calls(), std::ios::binary);
  if (!file) return;
  std::vector<std::string> requests;
  try {
    const std::string bytes(std::istreambuf_iterator<char>(file), {});
    wire::Reader from(bytes);
    requests = from.get<std::vector<std::string>>();
    const sandbox::Outcome outcome = run_program(request_of(requests), limits_ahead);
    if (!outcome.printed.empty()) return;
    const auto answers = answers_in(outcome);
    if (answers.size() != requests.size()) return;
    for (std::size_t i = 0; i < answers.size(); ++i) ahead.push_back({requests[i], answers[i]});
  } catch (const wire::malformed&) {    // a file that was cut
  } catch (const std::system_error&) {  // the machine is busy
  }
}

std::size_t used_ahead() {
  return static_cast<std::size_t>(
      std::count_if(ahead.begin(), ahead.end(), [](const SentAhead& one) { return one.is_used; }));
}

void keep_for_others() {
  const std::string file = file_of_calls();
  if (file.empty()) return;
  std::vector<std::string> requests;
  std::size_t bytes = 0;
  double to_start = most_seconds, seconds = 0;
  for (const Kept& one : kept_calls) to_start = std::min(to_start, one.cpu_seconds);
  for (const Kept& one : kept_calls) {
    bytes += one.request.size() + one.bytes.size();
    seconds += one.cpu_seconds - to_start;
    if (bytes > most_bytes || seconds > most_seconds_ahead) break;
    if (is_sendable(one.status)) requests.push_back(one.request);
  }
  if (requests.size() < 2) return;
  wire::Writer to;
  to.put(requests);
  // Renamed when it is whole: other checks may read it at the same time.
  const std::string part = fmt::format("{}.{}", file, getpid());
  std::ofstream(part, std::ios::binary) << to.bytes;
  if (std::rename(part.c_str(), file.c_str()) != 0) std::remove(part.c_str());
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

std::optional<sandbox::Outcome> sent_ahead(std::string_view request) {
  for (std::size_t i = next_ahead; i < ahead.size(); ++i) {
    SentAhead& one = ahead[i];
    if (one.is_used || one.request != request || one.answer.empty()) continue;
    one.is_used = true;
    while (next_ahead < ahead.size() && ahead[next_ahead].is_used) ++next_ahead;
    sandbox::Outcome outcome;
    outcome.answered = true;
    outcome.status = static_cast<wire::Status>(one.answer[0]);
    outcome.bytes = one.answer.substr(1);
    if (!is_sendable(outcome.status)) return {};
    if (outcome.status != wire::Status::value) {
      outcome.bytes = sandbox::exception_text(outcome.bytes);
    }
    return outcome;
  }
  return {};
}

void retry_if_sent_ahead() {
  if (!ahead.empty()) throw Retry{};
}

void run_check(void (*body)()) {
  kept_calls.clear();  // by hand, several checks run in one process
  ahead.clear();
  next_ahead = 0;
  hold_records();
  send_ahead();
  if (!ahead.empty()) {
    try {
      body();
      replay();
      if (used_ahead() < ahead.size() / 2) keep_for_others();  // other checks wrote the file
      return release_records(true);
    } catch (const Retry&) {
    }
    ahead.clear();
    kept_calls.clear();
    forget_calls();
  }
  release_records(false);
  body();
  replay();
  keep_for_others();
}

}  // namespace mc::checks
