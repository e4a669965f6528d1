#pragma once

#include <array>
#include <cstdint>

namespace mc {

/// A generating vector of rank-1 lattices in 16 dimensions, for N = 4, 8, 16, … 65,536 points; the
/// first dimensions are usable alone. Found component by component, as Sloan and Reztsov 2002 do
/// ("Component-by-component construction of good lattice rules", Math. Comp. 71): the first is 1,
/// and each of the others is the prime between 60,000 and 65,536 that makes the geometric mean of
/// the squared worst-case errors for these N smallest. The error is that in the Korobov space of
/// smoothness 2, all weights 1/20:
///
///     e^2 = -1 + 1/N sum_i prod_d (1 + w(x_id) / 20),   w(x) = 2 pi^2 (x^2 - x + 1/6).
///
/// A larger prime has no divisor in common with N: each axis has all multiples of 1/N. The search
/// takes half a second, for so few candidates (Nuyens and Cools 2006 search among all numbers by
/// the fast Fourier transform); `./lab bench halton --tables` repeats it.
inline constexpr std::array<std::uint64_t, 16> lattice_vector{
    1,     60259, 61211, 63059, 64151, 60703, 61751, 64817,
    61291, 64601, 60611, 64879, 62861, 60763, 64007, 63907};

}  // namespace mc
