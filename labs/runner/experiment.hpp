#pragma once
// An experiment: a named function from numbers to numbers, which a judge can ask for over the wire
// and a person by hand. A lab defines its experiments in experiments.cpp and lists them there, in
// experiments().

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "runner/text.hpp"
#include "runner/wire.hpp"

namespace mc::runner {

struct Experiment {
  std::string_view name;
  std::string_view parameters;   ///< their names, as one types them: "x rounds"
  std::string_view description;  ///< one line
  std::string (*from_wire)(wire::Reader& arguments);
  std::string (*by_hand)(std::span<const std::string> arguments);
};

/// The experiments of the lab that this program was built for.
std::span<const Experiment> experiments();

/// For a list of experiments: MC_EXPERIMENT(mean, "x", "the mean of x")
#define MC_EXPERIMENT(name, parameters, description) \
  ::mc::runner::make_experiment<&mc::experiments::name>(#name, parameters, description)

template <auto function>
struct Adapter;

template <class Result, class... Parameters, Result (*function)(Parameters...)>
struct Adapter<function> {
  using Arguments = std::tuple<std::remove_cvref_t<Parameters>...>;

  static std::string from_wire(wire::Reader& from) {
    Arguments arguments;
    std::apply([&](auto&... argument) { (from.get(argument), ...); }, arguments);
    from.end();
    wire::Writer to;
    to.put(std::apply(function, std::move(arguments)));
    return std::move(to.bytes);
  }

  static std::string by_hand(std::span<const std::string> texts) {
    if (texts.size() != sizeof...(Parameters)) {
      throw std::invalid_argument("wrong number of arguments");
    }
    Arguments arguments;
    std::size_t i = 0;
    std::apply([&](auto&... argument) { (text::parse(texts[i++], argument), ...); }, arguments);
    return text::print(std::apply(function, std::move(arguments)));
  }
};

template <auto function>
constexpr Experiment make_experiment(std::string_view name, std::string_view parameters,
                                     std::string_view description) {
  return {name, parameters, description, Adapter<function>::from_wire, Adapter<function>::by_hand};
}

}  // namespace mc::runner
