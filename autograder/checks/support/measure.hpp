#pragma once
// Requests a measurement from a submission's program.
//
//   const auto got = MEASURE(variance_two_pass, x);        // Measured<double>: got.value, got.call
//   const auto& u = MEASURE(uniforms, 1000, seed).exactly(1000, unit);  // lists: validated
//   const auto refused = MEASURE_OUTCOME(covariance, x, y);  // to look at exceptions
//
// Only the declaration of an experiment is used; its definition is not linked. A measurement
// without a value (not written yet, crashed, threw …) ends the check and reports the reason.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "checks/support/validation.hpp"
#include "common/rng.hpp"
#include "protocol/records.hpp"
#include "runner/spelling.hpp"
#include "runner/text.hpp"
#include "runner/wire.hpp"
#include "sandbox/jail.hpp"

#define MC_MEASURE(member, limits, experiment, ...)                       \
  ::mc::checks::Measure<decltype(::mc::experiments::experiment)>::member( \
      #experiment, limits __VA_OPT__(, ) __VA_ARGS__)
#define MEASURE(...) MC_MEASURE(value, {}, __VA_ARGS__)
#define MEASURE_WITH(limits, ...) MC_MEASURE(value, limits, __VA_ARGS__)
#define MEASURE_OUTCOME(...) MC_MEASURE(outcome, {}, __VA_ARGS__)
#define MEASURE_OUTCOME_WITH(limits, ...) MC_MEASURE(outcome, limits, __VA_ARGS__)
/// A measurement that may be missing: empty if the task is not written, or fails. Plots write the
/// reason next to their data (measurements/support/plot_data.hpp).
#define TRY_MEASURE(...) MC_MEASURE(value_if_any, {}, __VA_ARGS__)
#define TRY_MEASURE_WITH(limits, ...) MC_MEASURE(value_if_any, limits, __VA_ARGS__)

namespace mc::checks {

/// The result of a call: a number, or a struct of numbers. Lists must be validated before use.
template <class T>
struct Measured {
  T value;
  std::string call;             ///< "mean({1, 2, 4})"
  double cpu_seconds = 0;       ///< of the whole program
  std::size_t peak_memory = 0;  ///< of the program, in bytes
};
template <HasLists T>
struct Measured<T> {
 public:
  Measured(T value, std::string from, double cpu, std::size_t memory)
      : call(std::move(from)), cpu_seconds(cpu), peak_memory(memory), value_(std::move(value)) {}

  std::string call;
  double cpu_seconds = 0;
  std::size_t peak_memory = 0;

  /// Exactly `count` values in each list, each in `range`; ends the check otherwise.
  const T& exactly(std::size_t count, const Range& range = finite) const {
    return list_by_list({{count, range}});
  }
  /// The same with a separate count for each list of a struct, in order.
  const T& exactly(std::initializer_list<std::size_t> counts, const Range& range = finite) const {
    return list_by_list(specs_of(counts, range));
  }
  /// The same with a separate count and range for each list, in order.
  const T& list_by_list(const std::vector<ListSpec>& specs) const {
    if (const auto what = failure_of(value_, specs)) refuse(call, *what);
    pass();
    return value_;
  }
  /// Null where the functions above would end the check.
  const T* if_exactly(std::initializer_list<std::size_t> counts, const Range& range) const {
    return if_list_by_list(specs_of(counts, range));
  }
  const T* if_list_by_list(const std::vector<ListSpec>& specs) const {
    return failure_of(value_, specs) ? nullptr : &value_;
  }

 private:
  static std::vector<ListSpec> specs_of(std::initializer_list<std::size_t> counts,
                                        const Range& range) {
    std::vector<ListSpec> specs;
    for (const std::size_t count : counts) specs.push_back({count, range});
    return specs;
  }
  T value_;
};

struct Call {
  std::string text;  ///< "mean({1, 2, 4})"
  sandbox::Outcome outcome;
};

/// The generator of this check in this run, seeded by the run's seed and the check's name.
Rng check_rng();

/// A generator for random choices of the judge: a different one in each call.
Rng side_rng();

/// A call that was not made.
struct PossibleCall {
  std::string text, request;
};

/// The arguments of a call, for later use: most calls need none of it.
struct Arguments {
  std::shared_ptr<const void> values;  ///< the tuple that with_smaller() of another call takes
  /// As a user would type them, one per line.
  std::function<std::string()> typed;
  /// The call with argument k of another call of this experiment, if that is a smaller integer.
  std::function<std::optional<PossibleCall>(std::size_t k, const void* other)> with_smaller;
  std::size_t count = 0;
};

/// Calls the program.
Call ask(std::string_view experiment, std::string call, Arguments arguments, std::string request,
         const sandbox::Limits& limits);

/// Keeps a call for the replay (catch.hpp), if it was cheap enough.
void keep_call(std::string_view experiment, const Call& made, const std::string& request,
               Arguments arguments);

/// Records how often a cost grew, and its limit; self_test cost prints both for right answers.
void record_growth(double ratio, double limit, const std::string& what);

/// Runs the program without keeping the call. A failure of the machine is recorded as such.
sandbox::Outcome run_program(std::string_view request, const sandbox::Limits& limits);

/// Called for each missing value, if values may be missing; set by the plots.
extern void (*on_missing)(std::string_view experiment, const Call& call);

/// Ends the check unless the call returned a value.
void require_value(const Call& call);

void record(protocol::RecordKind kind, const std::string& text);

/// A value as shown in a call: as its lab spells it; lists as {1, 2, 4, …}, with their length if
/// shortened; structs as {count = 3, mean = 0.5}.
template <class T>
std::string shown(const T& value) {
  return text::print(value);
}
template <wire::Listed T>
std::string shown(const T& value);
template <class T>
std::string shown(const std::vector<T>& values) {
  constexpr std::size_t most = 5;
  std::string all = "{";
  for (std::size_t i = 0; i < values.size() && i < most; ++i) {
    all += (i > 0 ? ", " : "") + shown(values[i]);
  }
  if (values.size() > most) all += ", … (" + std::to_string(values.size()) + " values)";
  return all + "}";
}
template <wire::Listed T>
std::string shown(const T& value) {
  if constexpr (requires { spelled(value); }) {
    return spelled(value);
  } else {
    const auto names = text::split(field_names(value), ',');
    std::string all;
    std::apply(
        [&](const auto&... field) {
          std::size_t i = 0;
          ((all += (all.empty() ? "{" : ", "), all += names[i++], all += " = ",
            all += shown(field)),
           ...);
        },
        fields(const_cast<T&>(value)));
    return all + '}';
  }
}

/// A call as its lab spells it, by default as "mean({1, 2, 4})".
template <class... Arguments>
std::string shown_call(std::string_view experiment, const Arguments&... arguments) {
  if constexpr (requires { spelled_call(experiments::Spelling{}, experiment, arguments...); }) {
    return spelled_call(experiments::Spelling{}, experiment, arguments...);
  } else {
    std::string all;
    ((all += (all.empty() ? "" : ", ") + shown(arguments)), ...);
    return std::string(experiment) + '(' + all + ')';
  }
}

/// The value in these bytes, if they are valid.
template <class T>
std::optional<T> decoded(const std::string& bytes) {
  try {
    wire::Reader from(bytes);
    auto value = from.get<T>();
    from.end();
    return value;
  } catch (const wire::malformed&) {
    return {};
  }
}

/// The value that the call returned; ends the check if there is none.
template <class Result>
Measured<Result> result_of(const Call& call) {
  require_value(call);
  auto result = decoded<Result>(call.outcome.bytes);
  if (!result) fail("measured  " + call.text + " sent something that is not a result");
  return Measured<Result>{std::move(*result), call.text, call.outcome.cpu_seconds,
                          call.outcome.peak_memory};
}

template <class Function>
struct Measure;

template <class Result, class... Parameters>
struct Measure<Result(Parameters...)> {
  using Given = std::tuple<std::remove_cvref_t<Parameters>...>;

  static PossibleCall call_of(std::string_view experiment, const Given& given) {
    wire::Writer request;
    request.put(std::string(experiment));
    std::string text = std::apply(
        [&](const auto&... each) {
          (request.put(each), ...);
          return shown_call(experiment, each...);
        },
        given);
    return {std::move(text), std::move(request.bytes)};
  }

  /// Replaces argument k by that of `other`, if that is a smaller integer.
  template <std::size_t k = 0>
  static bool take_smaller(Given& given, std::size_t wanted, const Given& other) {
    if constexpr (k < sizeof...(Parameters)) {
      if (k != wanted) return take_smaller<k + 1>(given, wanted, other);
      if constexpr (std::is_integral_v<std::tuple_element_t<k, Given>>) {
        const bool is_smaller = std::get<k>(other) < std::get<k>(given);
        if (is_smaller) std::get<k>(given) = std::get<k>(other);
        return is_smaller;
      }
    }
    return false;
  }

  static Call outcome(std::string_view experiment, const sandbox::Limits& limits,
                      std::type_identity_t<std::remove_cvref_t<Parameters>>... arguments) {
    const auto given = std::make_shared<const Given>(std::move(arguments)...);
    auto [text, request] = call_of(experiment, *given);
    auto typed = [given] {
      std::string lines;
      std::apply([&](const auto&... each) { ((lines += '\n' + text::as_typed(each)), ...); },
                 *given);
      return lines;
    };
    auto with_smaller = [=](std::size_t k, const void* other) -> std::optional<PossibleCall> {
      Given changed = *given;
      if (!take_smaller(changed, k, *static_cast<const Given*>(other))) return {};
      return call_of(experiment, changed);
    };
    return ask(experiment, std::move(text), {given, typed, with_smaller, sizeof...(Parameters)},
               std::move(request), limits);
  }

  static Measured<Result> value(
      std::string_view experiment, const sandbox::Limits& limits,
      std::type_identity_t<std::remove_cvref_t<Parameters>>... arguments) {
    return result_of<Result>(outcome(experiment, limits, std::move(arguments)...));
  }

  static std::optional<Measured<Result>> value_if_any(
      std::string_view experiment, const sandbox::Limits& limits,
      std::type_identity_t<std::remove_cvref_t<Parameters>>... arguments) {
    const Call call = outcome(experiment, limits, std::move(arguments)...);
    if (!call.outcome.answered || call.outcome.status != wire::Status::value) {
      if (on_missing != nullptr) on_missing(experiment, call);
      return {};
    }
    return result_of<Result>(call);
  }
};

}  // namespace mc::checks
