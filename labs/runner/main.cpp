// main() of a submission's program. Without arguments it is judged: one request on descriptor 0,
// one response on descriptor 3 (wire.hpp). With arguments it is run by hand:
//
//   program                 (judged)
//   program --list 80       the experiments of this lab, in lines of 80 columns
//   program mean 1,2,4      one of them

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/todo.hpp"
#include "runner/experiment.hpp"

namespace {

using mc::wire::Status;

constexpr int request_descriptor = 0;
constexpr int response_descriptor = 3;
constexpr std::size_t default_width = 100;

const mc::runner::Experiment* find(std::string_view name) {
  for (const auto& experiment : mc::runner::experiments()) {
    if (experiment.name == name) return &experiment;
  }
  return nullptr;
}

std::string read_all(int descriptor) {
  std::string all;
  char buffer[1 << 16];
  for (;;) {
    const ssize_t got = read(descriptor, buffer, sizeof buffer);
    if (got <= 0) return all;
    all.append(buffer, static_cast<std::size_t>(got));
  }
}

void write_all(int descriptor, const void* data, std::size_t size) {
  auto bytes = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t wrote = write(descriptor, bytes, size);
    if (wrote <= 0) return;  // the judge has closed its end
    bytes += wrote;
    size -= static_cast<std::size_t>(wrote);
  }
}

/// Runs `work` and turns whatever it throws into a status and a text.
template <class Work>
std::pair<Status, std::string> outcome_of(Work work) {
  try {
    return {Status::value, work()};
  } catch (const mc::todo& task) {
    return {Status::todo, task.what()};
  } catch (const std::invalid_argument& error) {
    return {Status::invalid_argument, error.what()};
  } catch (const std::out_of_range& error) {
    return {Status::out_of_range, error.what()};
  } catch (const std::bad_alloc&) {
    return {Status::other_exception, "std::bad_alloc"};
  } catch (const std::exception& error) {
    return {Status::other_exception, error.what()};
  } catch (...) {
    return {Status::other_exception, "an exception that is not a std::exception"};
  }
}

std::string answer_all(mc::wire::Reader& from);

/// The result of one request.
std::string answer(std::string_view request) {
  mc::wire::Reader from(request);
  const auto name = from.get<std::string>();
  if (name.empty()) return answer_all(from);
  const auto* experiment = find(name);
  if (experiment == nullptr) throw mc::wire::malformed("no experiment " + name);
  return experiment->from_wire(from);
}

/// The results of a list of requests, each with its status before it, in one byte.
std::string answer_all(mc::wire::Reader& from) {
  const auto requests = from.get<std::vector<std::string>>();
  from.end();
  std::vector<std::string> answers;
  for (const std::string& request : requests) {
    auto [status, bytes] = outcome_of([&] { return answer(request); });
    answers.push_back(static_cast<char>(status) + std::move(bytes));
  }
  mc::wire::Writer to;
  to.put(answers);
  return std::move(to.bytes);
}

[[noreturn]] void answer_judge() {
  const std::string request = read_all(request_descriptor);
  const auto [status, bytes] = outcome_of([&] { return answer(request); });
  const mc::wire::Header header{mc::wire::magic, status, 0, bytes.size()};
  std::fflush(nullptr);
  write_all(response_descriptor, &header, sizeof header);
  write_all(response_descriptor, bytes.data(), bytes.size());
  _exit(0);  // what the submission registered to run at exit is not part of the measurement
}

/// The content of the file that "@file" names, with commas for line ends; any other text unchanged.
std::string contents_of(const std::string& argument) {
  if (!argument.starts_with('@')) return argument;
  std::FILE* const file = std::fopen(argument.c_str() + 1, "r");
  if (file == nullptr) throw std::invalid_argument("cannot read " + argument.substr(1));
  std::string text;
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) {
    text += c == '\n' ? ',' : static_cast<char>(c);
  }
  std::fclose(file);
  while (text.ends_with(',')) text.pop_back();
  return text;
}

/// Is "--per-axis" the parameter per_axis?
bool is_named(std::string_view given, std::string_view name) {
  if (!given.starts_with("--") || given.size() != name.size() + 2) return false;
  given.remove_prefix(2);
  return std::equal(given.begin(), given.end(), name.begin(),
                    [](char a, char b) { return a == b || (a == '-' && b == '_'); });
}

/// The arguments in the order of the parameters; they may be given by name: --n 12 --dims 2.
std::vector<std::string> in_order(const mc::runner::Experiment& experiment,
                                  std::span<char* const> given) {
  const std::vector<std::string> names = mc::text::words_of(experiment.parameters);
  std::vector<std::string> all;
  if (given.empty() || !std::string_view(given[0]).starts_with("--")) {
    for (const char* argument : given) all.push_back(contents_of(argument));
    return all;
  }
  for (const std::string& name : names) {
    bool found = false;
    for (std::size_t i = 0; i + 1 < given.size() && !found; i += 2) {
      if (!is_named(given[i], name)) continue;
      all.push_back(contents_of(given[i + 1]));
      found = true;
    }
    if (!found) throw std::invalid_argument("--" + name + " is missing");
  }
  if (given.size() != 2 * names.size()) {
    throw std::invalid_argument("an unknown or repeated name, or a name without a value");
  }
  return all;
}

int run_by_hand(std::string_view name, std::span<char* const> arguments) {
  const auto* experiment = find(name);
  if (experiment == nullptr) {
    std::fprintf(stderr, "no experiment '%s'; there are\n\n", std::string(name).c_str());
    std::fputs(mc::runner::list_of_experiments(default_width).c_str(), stderr);
    return 2;
  }
  const auto [status, text] = outcome_of(
      [&] { return experiment->by_hand(*experiment, in_order(*experiment, arguments)); });
  switch (status) {
    case Status::value:
      std::printf("%s\n", text.c_str());
      return 0;
    case Status::todo:
      std::printf("not written yet: TODO(%s)\n", text.c_str());
      return 1;
    case Status::invalid_argument:
      std::printf("std::invalid_argument: %s\n(%s; numbers as 0.5, lists as 1,2,4)\n", text.c_str(),
                  mc::runner::call_of(*experiment).c_str());
      return 1;
    case Status::out_of_range:
      std::printf("std::out_of_range: %s\n", text.c_str());
      return 1;
    case Status::other_exception:
      break;
  }
  std::printf("an exception: %s\n", text.c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc <= 1) answer_judge();
  if (std::string_view(argv[1]) == "--list") {
    const std::size_t width = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : default_width;
    std::fputs(mc::runner::list_of_experiments(width).c_str(), stdout);
    return 0;
  }
  return run_by_hand(argv[1], std::span(argv + 2, static_cast<std::size_t>(argc - 2)));
}
