#pragma once
// Columns of points for plots and bench: what is not there, or not in order, is left out.

#include <optional>
#include <vector>

#include "measurements/support/plot_data.hpp"

namespace mc::checks {

using Column = std::optional<std::vector<double>>;

/// `count` numbers in [0, 1), if that is what was measured.
template <class Measurement>
Column column_of(const Measurement& measured, std::size_t count) {
  const auto* values = measured ? measured->if_exactly(count, unit) : nullptr;
  if (values == nullptr) return {};
  return *values;
}

}  // namespace mc::checks
