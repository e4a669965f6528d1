#pragma once
// An experiment: a named function from numbers to numbers, which a judge calls over the wire and a
// person by hand. A lab defines its experiments in experiments.cpp and lists them there, in
// experiments().

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "runner/table.hpp"
#include "runner/text.hpp"
#include "runner/wire.hpp"

namespace mc::runner {

struct Experiment {
  std::string_view name;
  std::string_view parameters;   ///< their names, as experiments.hpp declares them: "x rounds"
  std::string_view description;  ///< one line
  std::string (*from_wire)(wire::Reader& arguments);
  std::string (*by_hand)(const Experiment&, std::span<const std::string> arguments);
  std::vector<std::string> (*forms)();  ///< how each argument is written: "NUMBER", "LIST"
  Layout layout = {};                   ///< how the result is printed by hand
};

/// The experiments of the lab that this program was built for.
std::span<const Experiment> experiments();

/// The values that a parameter may have, if it is a word, or a number with a meaning.
struct Choice {
  std::string parameter;
  std::string meaning;  ///< may be empty
  std::vector<std::string> values;
};

/// Those of this lab's parameters.
std::vector<Choice> choices();

/// How an experiment is called by hand: "welford --x LIST".
std::string call_of(const Experiment& experiment);

/// All experiments of this lab, with their parameters and what they do, in lines of at most `width`
/// columns.
std::string list_of_experiments(std::size_t width);

/// For a list of experiments: MC_EXPERIMENT(mean, "x", "the mean of x"). One that returns a list
/// says how to print it: MC_EXPERIMENT(halton, "n dims", "…", {.dims = "dims"})
#define MC_EXPERIMENT(name, parameters, description, ...)                  \
  ::mc::runner::make_experiment<&mc::experiments::name>(#name, parameters, \
                                                        description __VA_OPT__(, ) __VA_ARGS__)

/// How a person types a value of a type: "NUMBER", "LIST", "x:y".
template <class T>
std::string form_of() {
  if constexpr (wire::Listed<T>) {
    const auto names = text::split(field_names(T{}), ',');
    return text::joined({names.begin(), names.end()}, ":", names.size(), "");
  } else if constexpr (std::is_same_v<T, std::string>) {
    return "NAME";
  } else if constexpr (is_list<T>) {
    using Value = typename T::value_type;
    return wire::Listed<Value> ? form_of<Value>() + ",..." : "LIST";
  } else {
    return std::is_floating_point_v<T> ? "NUMBER" : "N";
  }
}

template <auto function>
struct Adapter;

template <class Result, class... Parameters, Result (*function)(Parameters...)>
struct Adapter<function> {
  using Arguments = std::tuple<std::remove_cvref_t<Parameters>...>;
  static constexpr std::size_t parameters = sizeof...(Parameters);

  static std::string from_wire(wire::Reader& from) {
    Arguments arguments;
    std::apply([&](auto&... argument) { (from.get(argument), ...); }, arguments);
    from.end();
    wire::Writer to;
    to.put(std::apply(function, std::move(arguments)));
    return std::move(to.bytes);
  }

  static std::vector<std::string> forms() {
    return {form_of<std::remove_cvref_t<Parameters>>()...};
  }

  static std::string by_hand(const Experiment& experiment, std::span<const std::string> texts) {
    if (texts.size() != sizeof...(Parameters)) {
      throw std::invalid_argument("wrong number of arguments");
    }
    Arguments arguments;
    std::size_t i = 0;
    std::apply([&](auto&... argument) { (text::parse(texts[i++], argument), ...); }, arguments);
    constexpr bool are_lists[] = {is_list<std::remove_cvref_t<Parameters>>..., false};
    const auto names = text::split(experiment.parameters, ' ');
    TypedArguments typed;
    for (i = 0; i < texts.size(); ++i) typed.push_back({names[i], texts[i], are_lists[i]});
    return printed(std::apply(function, std::move(arguments)), experiment.name, experiment.layout,
                   typed);
  }
};

template <auto function>
constexpr Experiment make_experiment(std::string_view name, std::string_view parameters,
                                     std::string_view description, Layout layout = {}) {
  using Adapted = Adapter<function>;
  std::size_t names = parameters.empty() ? 0 : 1;
  for (const char c : parameters) names += c == ' ';
  if (names != Adapted::parameters) throw "not as many names as parameters";  // while compiling
  return {name,           parameters, description, Adapted::from_wire, Adapted::by_hand,
          Adapted::forms, layout};
}

}  // namespace mc::runner
