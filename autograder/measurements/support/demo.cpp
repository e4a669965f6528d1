#include "measurements/support/demo.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "measurements/support/integrands.hpp"
#include "measurements/support/plot_data.hpp"

namespace mc::measurements {
namespace {

using nlohmann::ordered_json;

/// How many sets an RMSE is of (it is known to a part 1/sqrt(2 sets), 6 %), how many are shown.
constexpr std::size_t sets_in_all = 128, sets_shown = 6;

double rounded(double value, int digits) {
  return std::strtod(fmt::format("{:.{}g}", value, digits).c_str(), nullptr);
}

/// The points of a set, x and y in turn, as parts of 65536: four hexadecimal digits each.
std::string as_hex(const PointSet& set) {
  std::string text;
  for (std::size_t i = 0; i < set.size(); ++i) {
    for (const std::size_t d : {0u, 1u}) {
      text += fmt::format("{:04x}", static_cast<unsigned>(set.column(d)[i] * 65536));
    }
  }
  return text;
}

/// The shades of an integrand on a grid, row by row from y = 0, from its least value to its
/// largest: 64 of them, the characters from '0' on.
std::string picture_of(const Integrand& integrand) {
  constexpr std::size_t width = 96;
  std::vector<double> values;
  for (std::size_t i = 0; i < width * width; ++i) {
    const auto middle = [](std::size_t k) { return (static_cast<double>(k) + 0.5) / width; };
    values.push_back(integrand.g(std::array{middle(i % width), middle(i / width)}));
  }
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  std::string shades;
  for (const double value : values) {
    const auto shade = '0' + std::lround(63 * (value - *low) / (*high - *low));
    shades += static_cast<char>(shade == '\\' ? '~' : shade);  // JSON would double it
  }
  return shades;
}

ordered_json as_json(const Integrand& one) {
  return {{"name", one.name.starts_with("smooth") ? "smooth" : one.name},
          {"formula", one.formula},
          {"exact", rounded(one.mean, 12)},
          {"variance", rounded(variance_in_the_plane(one), 6)},
          {"picture", picture_of(one)}};
}

}  // namespace

void write_demo(int place, const Method& method) {
  auto file = plot_file(fmt::format("demo-{}-{}.json", place, method.key));
  std::vector<Integrand> shown;
  for (const Integrand& one : integrands()) {
    if (one.in_demo) shown.push_back(one);
  }
  ordered_json sizes, points, all, estimates = std::vector(shown.size(), ordered_json::array()),
                                   rmse = estimates;
  const std::uint64_t most = std::min<std::uint64_t>(4096, method.most);
  Sets sets;
  if (method.is_sequence) sets = method.points(most, 2, sets_in_all, 1);
  for (std::uint64_t n = 1; n <= most; n *= 2) {
    if (!method.is_sequence) sets = method.points(n, 2, sets_in_all, n);
    if (sets.empty()) return;
    sizes.push_back(n);
    for (std::size_t i = 0; i < shown.size(); ++i) {
      ErrorSums errors;
      for (std::size_t set = 0; set < sets.size(); ++set) {
        const double error = error_of(shown[i], sets[set], n);
        errors.add(error);
        if (set < sets_shown) estimates[i].push_back(rounded(shown[i].mean + error, 9));
      }
      rmse[i].push_back(rounded(errors.rmse(), 4));
    }
    if (method.is_sequence && n != most) continue;
    for (std::size_t set = 0; set < sets_shown; ++set) points.push_back(as_hex(sets[set]));
  }
  for (const Integrand& one : shown) all.push_back(as_json(one));
  file << ordered_json{{"name", method.name}, {"sequence", method.is_sequence},
                       {"shown", sets_shown}, {"sets", sets_in_all},
                       {"sizes", sizes},      {"integrands", all},
                       {"points", points},    {"estimates", estimates},
                       {"rmse", rmse}}
       << '\n';
}

}  // namespace mc::measurements
