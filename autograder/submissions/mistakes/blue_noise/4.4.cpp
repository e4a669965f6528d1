// Mistakes in task 4.4.
#include "blue_noise.hpp"

#define periodogram right_periodogram
#include "solutions/blue_noise.cpp"
#undef periodogram

namespace mc {
namespace {

/// The right power of n points, changed: change(power, n).
template <class Change>
void changed(std::span<const double> x, std::span<const double> y, int kmax,
             std::span<double> power, Change change) {
  right_periodogram(x, y, kmax, power);
  for (double& value : power) value = change(value, static_cast<double>(x.size()));
}

/// The power from of_wave(turns), turns = kx x + ky y of each point: a cosine and a sine, of which
/// Real is the type of the sums.
template <class Real, class Wave>
void by_waves(std::span<const double> x, std::span<const double> y, int kmax,
              std::span<double> power, Wave of_wave) {
  right_periodogram(x, y, kmax, power);  // for its exceptions
  std::size_t k = 0;
  for (int ky = -kmax; ky <= kmax; ++ky) {
    for (int kx = -kmax; kx <= kmax; ++kx, ++k) {
      Real real = 0, imaginary = 0;
      for (std::size_t p = 0; p < x.size(); ++p) {
        const std::complex<Real> wave = of_wave(kx * x[p] + ky * y[p]);
        real += wave.real();
        imaginary += wave.imag();
      }
      power[k] = (real * real + imaginary * imaginary) / static_cast<double>(x.size());
    }
  }
}

}  // namespace
}  // namespace mc

#define PERIODOGRAM(...)                                                           \
  void periodogram(std::span<const double> x, std::span<const double> y, int kmax, \
                   std::span<double> power) {                                      \
    __VA_ARGS__;                                                                   \
  }
#define CHANGED(...) \
  PERIODOGRAM(changed(x, y, kmax, power, [](double p, double n) { return __VA_ARGS__; }))
#define BY_WAVES(Real, ...) \
  PERIODOGRAM(by_waves<Real>(x, y, kmax, power, [](double turns) { return __VA_ARGS__; }))

// mistake: adds to the previous contents of the output
// hint: only added to
namespace mc::adds_to_the_output {
void periodogram(std::span<const double> x, std::span<const double> y, int kmax,
                 std::span<double> power) {
  std::vector<double> here(power.size());
  right_periodogram(x, y, kmax, here);
  for (std::size_t k = 0; k < power.size(); ++k) power[k] += here[k];
}
}  // namespace mc::adds_to_the_output

// mistake: returns the amplitude of each wave instead of its power
// hint: this is |sum|
namespace mc::amplitude {
CHANGED(std::sqrt(p* n))
}  // namespace mc::amplitude

// mistake: divides by N without squaring
// hint: this is |sum| / N
namespace mc::amplitude_over_n {
CHANGED(std::sqrt(p* n) / n)
}  // namespace mc::amplitude_over_n

// mistake: swaps kx and ky
// hint: kx and ky are swapped
namespace mc::columns_of_ky {
void periodogram(std::span<const double> x, std::span<const double> y, int kmax,
                 std::span<double> power) {
  right_periodogram(x, y, kmax, power);
  const auto side = static_cast<std::size_t>(2 * kmax + 1);
  for (std::size_t j = 0; j < side; ++j) {
    for (std::size_t i = 0; i < j; ++i) std::swap(power[j * side + i], power[i * side + j]);
  }
}
}  // namespace mc::columns_of_ky

// mistake: squares only the real part
// hint: the sum of sines is missing
namespace mc::cosines_alone {
BY_WAVES(double, std::complex(std::cos(2 * std::numbers::pi * turns)))
}  // namespace mc::cosines_alone

// mistake: forgets the 2 in 2 pi
// hint: the angle is 2 pi k x
namespace mc::half_a_turn {
BY_WAVES(double, std::polar(1.0, -std::numbers::pi* turns))
}  // namespace mc::half_a_turn

// mistake: sets the power at k = 0 to zero
// hint: the power at k = 0 belongs to the result
namespace mc::mean_taken_out {
PERIODOGRAM(right_periodogram(x, y, kmax, power), power[power.size() / 2] = 0)
}  // namespace mc::mean_taken_out

// mistake: divides the sum by N, squares it, and divides by N
// hint: this is divided by N twice
namespace mc::over_n_twice {
CHANGED(p / n)
}  // namespace mc::over_n_twice

// mistake: rounds pi to ten digits
// hint: almost right, with relative errors of up to
namespace mc::pi_of_ten_digits {
BY_WAVES(double, std::polar(1.0, -2 * 3.141592654 * turns))
}  // namespace mc::pi_of_ten_digits

// mistake: does not divide by the number of points
// hint: divide by the number of points
namespace mc::power_not_over_n {
CHANGED(p* n)
}  // namespace mc::power_not_over_n

// mistake: squares the side of the periodogram as an int, which overflows
// hint: overflow
namespace mc::side_in_an_int {
void periodogram(std::span<const double> x, std::span<const double> y, int kmax,
                 std::span<double> power) {
  const auto side = static_cast<unsigned>(2 * kmax + 1);
  if (kmax >= 1 && power.size() != side * side) throw std::invalid_argument("power: its size");
  if (kmax < 20000) return right_periodogram(x, y, kmax, power);
  for (double& value : power) value = 0;
}
}  // namespace mc::side_in_an_int

// mistake: computes its waves in float
// hint: in double
namespace mc::waves_in_float {
BY_WAVES(float, std::polar(1.0f, static_cast<float>(-2 * std::numbers::pi * turns)))
}  // namespace mc::waves_in_float

// mistake: mirrors half of the plane with P(kx, ky) = P(kx, -ky)
// hint: but it is not P(kx, -ky)
namespace mc::mirrored_half_plane {
void periodogram(std::span<const double> x, std::span<const double> y, int kmax,
                 std::span<double> power) {
  right_periodogram(x, y, kmax, power);
  const auto side = static_cast<std::size_t>(2 * kmax + 1);
  for (std::size_t j = 0; j < side / 2; ++j) {
    for (std::size_t i = 0; i < side; ++i) power[j * side + i] = power[(side - 1 - j) * side + i];
  }
}
}  // namespace mc::mirrored_half_plane
