#pragma once

#include <array>
#include <cstdint>

namespace mc {

/// A generating vector of rank-1 lattices with N = 4, 8, 16, … 65,536 points in up to 16
/// dimensions; a lattice in fewer dimensions uses the first components. It was found component by
/// component (Sloan, Reztsov 2002, "Component-by-component construction of good lattice rules",
/// Math. Comp. 71): the first component is 1, and each of the others is the prime between 60,000
/// and 65,536 that minimizes the geometric mean of the squared worst-case errors over these N. The
/// worst-case error is that of the Korobov space of smoothness 2, with all weights 1/20:
///
///     e^2 = -1 + 1/N sum_i prod_d (1 + w(x_id) / 20),   w(x) = 2 pi^2 (x^2 - x + 1/6).
///
/// The first pair that was found, 1 and 60,259, is the worst of the first four at N = 1,024: it
/// takes a wave for a constant whose frequency vector has length 14.8, and the others none below
/// 22.0. So it is the fourth here, not the one that a renderer's pixels get.
///
/// An odd prime has no divisor in common with N, so the coordinates along each axis are all
/// multiples of 1/N. With so few candidates the search takes half a second; it is in
/// autograder/tests/lattice_search.hpp. (Nuyens, Cools 2006 search all integers by means of the
/// fast Fourier transform.)
inline constexpr std::array<std::uint64_t, 16> lattice_vector{
    61211, 63059, 64151, 60703, 61751, 64817, 1,     60259,
    61291, 64601, 60611, 64879, 62861, 60763, 64007, 63907};

}  // namespace mc
