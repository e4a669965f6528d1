#include "experiments.hpp"

#include "runner/experiment.hpp"

namespace mc::experiments {

std::vector<double> squares(std::vector<double> x) {
  for (double& value : x) value = mc::square(value);
  return x;
}

}  // namespace mc::experiments

std::span<const mc::runner::Experiment> mc::runner::experiments() {
  static constexpr Experiment all[] = {
      MC_EXPERIMENT(squares, "x", "@number@.1  the square of each value of x", {.row_labels = "x"}),
  };
  return all;
}

std::vector<mc::runner::Choice> mc::runner::choices() {
  return {};
}
