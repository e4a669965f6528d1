#include "measurements/support/demo.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include <fmt/format.h>

#include "checks/support/rect_light_exact.hpp"

namespace mc::checks {
namespace {

constexpr RectLight lamp;

/// Cosines at receiver and light, both height / r, over r^2, times the light's area.
double under_lamp(double u, double v) {
  const double x = lamp.x0 + (lamp.x1 - lamp.x0) * u, y = lamp.y0 + (lamp.y1 - lamp.y0) * v;
  const double h2 = lamp.height * lamp.height, r2 = x * x + y * y + h2;
  return (lamp.x1 - lamp.x0) * (lamp.y1 - lamp.y0) * lamp.radiance * h2 / (r2 * r2);
}

/// What is dark of the lamp behind a small disk: another disk, that lies within the lamp.
constexpr double dark_x = 0.3, dark_y = 0.05, dark_radius = 0.3;

double in_shadow(double u, double v) {
  const double x = lamp.x0 + (lamp.x1 - lamp.x0) * u, y = lamp.y0 + (lamp.y1 - lamp.y0) * v;
  const double dx = x - dark_x, dy = y - dark_y;
  return dx * dx + dy * dy < dark_radius * dark_radius ? 0 : under_lamp(u, v);
}

/// The irradiance under a disk parallel to the receiver, its centre off the axis (Howell, "A
/// catalog of radiation heat transfer configuration factors", B-13).
double irradiance_of_dark_disk() {
  const double h2 = lamp.height * lamp.height, d2 = dark_x * dark_x + dark_y * dark_y;
  const double r2 = dark_radius * dark_radius, sum = h2 + d2 + r2;
  return lamp.radiance * std::numbers::pi / 2 *
         (1 - (h2 + d2 - r2) / std::sqrt(sum * sum - 4 * r2 * d2));
}

constexpr double wave_x = 40, wave_y = 23;

/// The mean of exp(i k x) over [0, 1].
std::complex<double> mean_of_wave(double k) {
  return (std::polar(1.0, k) - 1.0) / std::complex<double>(0, k);
}

std::string with_commas(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : ",") + text;
  return all;
}
std::string list_of(const std::vector<std::string>& texts) {
  return '[' + with_commas(texts) + ']';
}

/// 1, 2, 4, … most
std::vector<std::uint64_t> sizes_up_to(std::uint64_t most) {
  std::vector<std::uint64_t> sizes;
  for (std::uint64_t n = 1; n <= most; n *= 2) sizes.push_back(n);
  return sizes;
}

/// Coordinates as 16 bits each, x and y in turn, the lower byte first; all in base 64.
std::string as_base64(std::span<const double> x, std::span<const double> y) {
  std::string bytes;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (const double value : {x[i], y[i]}) {
      const auto step = static_cast<unsigned>(value * 65536);
      bytes += static_cast<char>(step & 0xff);
      bytes += static_cast<char>(step >> 8);
    }
  }
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned three = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const unsigned byte = i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u;
      three = three << 8 | byte;
    }
    for (unsigned k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? digits[three >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

/// One set of points of the plane, and the first n of it.
struct PlaneSet {
  std::span<const double> x, y;
  PlaneSet first(std::size_t n) const { return {x.first(n), y.first(n)}; }
};
PlaneSet set_of(const PointSets& sets, std::size_t which) {
  const std::span<const double> all(sets.values);
  return {all.subspan(2 * which * sets.n, sets.n), all.subspan((2 * which + 1) * sets.n, sets.n)};
}

double mean_over(const DemoIntegrand& integrand, const PlaneSet& set) {
  double sum = 0;
  for (std::size_t i = 0; i < set.x.size(); ++i) sum += integrand.g(set.x[i], set.y[i]);
  return sum / static_cast<double>(set.x.size());
}

/// Of one value at a uniform point: by the midpoint rule, in 1024 x 1024 cells.
double variance_of(const DemoIntegrand& integrand) {
  constexpr int width = 1024;
  double squares = 0;
  for (int i = 0; i < width * width; ++i) {
    const double g = integrand.g((i % width + 0.5) / width, (i / width + 0.5) / width);
    squares += g * g;
  }
  return squares / (width * width) - integrand.exact * integrand.exact;
}

/// The shades of an integrand on a grid, row by row from y = 0, from its least value to its
/// largest.
std::string picture_of(const DemoIntegrand& integrand) {
  constexpr std::size_t width = 96;
  std::vector<double> values;
  for (std::size_t i = 0; i < width * width; ++i) {
    const auto middle = [&](std::size_t k) { return (static_cast<double>(k) + 0.5) / width; };
    values.push_back(integrand.g(middle(i % width), middle(i / width)));
  }
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  std::string digits;  // one of 64 shades each: the digits of base 64, from '0' on
  for (const double value : values) {
    const double part = (value - *low) / (*high - *low);
    const char digit = static_cast<char>('0' + std::lround(63 * part));
    digits += digit == '\\' ? '~' : digit;
  }
  return digits;
}

std::string all_integrands() {
  std::vector<std::string> all;
  for (const DemoIntegrand& one : demo_integrands()) {
    all.push_back(fmt::format(
        R"({{"name":"{}","formula":"{}","exact":{:.12g},"variance":{:.6g},"picture":"{}"}})",
        one.name, one.formula, one.exact, variance_of(one), picture_of(one)));
  }
  return list_of(all);
}

}  // namespace

std::span<const DemoIntegrand> demo_integrands() {
  static const double e_1 = std::exp(1.0) - 1;
  static const std::array<DemoIntegrand, 5> all{{
      {"smooth", "exp(x + y)", e_1 * e_1, [](double x, double y) { return std::exp(x + y); }},
      {"lamp", "the irradiance under a rectangular lamp", irradiance(lamp), under_lamp},
      {"penumbra", "the same lamp, partly behind a disk",
       irradiance(lamp) - irradiance_of_dark_disk(), in_shadow},
      // Where y < 0.65 - x/2: from 0.65 on the left to 0.15 on the right.
      {"edge", "1 where x + 2y < 1.3, else 0", 0.4,
       [](double x, double y) { return x + 2 * y < 1.3 ? 1.0 : 0.0; }},
      {"wave", "1 + cos(40 x + 23 y)", 1 + (mean_of_wave(wave_x) * mean_of_wave(wave_y)).real(),
       [](double x, double y) { return 1 + std::cos(wave_x * x + wave_y * y); }},
  }};
  return all;
}

void write_demo(const std::string& file, const DemoPoints& points) {
  auto out = plot_file("demo-" + file + ".json");
  const auto sizes = sizes_up_to(points.most);
  const auto integrands = demo_integrands();
  std::vector<std::vector<std::string>> errors(integrands.size()), estimates(integrands.size());
  std::vector<std::string> shown;
  std::optional<PointSets> sets;
  if (points.is_sequence) sets = points.points(points.most, demo_sets, 1);
  for (const std::uint64_t n : sizes) {
    if (!points.is_sequence) sets = points.points(n, demo_sets, n);
    if (!sets) return;
    for (std::size_t i = 0; i < integrands.size(); ++i) {
      double squares = 0;
      for (std::size_t set = 0; set < demo_sets; ++set) {
        const double estimate = mean_over(integrands[i], set_of(*sets, set).first(n));
        squares += std::pow(estimate - integrands[i].exact, 2);
        if (set < demo_shown) estimates[i].push_back(fmt::format("{:.9g}", estimate));
      }
      errors[i].push_back(fmt::format("{:.4g}", std::sqrt(squares / demo_sets)));
    }
    for (std::size_t set = 0; set < demo_shown; ++set) {
      if (points.is_sequence && n != points.most) break;
      const PlaneSet plane = set_of(*sets, set).first(n);
      shown.push_back('"' + as_base64(plane.x, plane.y) + '"');
    }
  }
  std::vector<std::string> rmse, values;
  for (const auto& row : errors) rmse.push_back(list_of(row));
  for (const auto& row : estimates) values.push_back(list_of(row));
  std::vector<std::string> numbers;
  for (const std::uint64_t n : sizes) numbers.push_back(std::to_string(n));
  out << fmt::format(R"({{"name":"{}","sequence":{},"shown":{},"sets":{},)", points.name,
                     points.is_sequence, demo_shown, demo_sets)
      << "\"sizes\":" << list_of(numbers) << ",\n\"integrands\":" << all_integrands()
      << ",\n\"points\":" << list_of(shown) << ",\n\"estimates\":" << list_of(values)
      << ",\n\"rmse\":" << list_of(rmse) << "}\n";
}

}  // namespace mc::checks
