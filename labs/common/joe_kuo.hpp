#pragma once

#include <array>

namespace mc {

/// The parameters of one dimension of the Sobol' sequence: a primitive polynomial over GF(2),
///
///     x^degree + a_1 x^(degree-1) + ... + a_(degree-1) x + 1,
///
/// and the first `degree` initial numbers, m[k-1] for m_k, each odd and below 2^k.
struct JoeKuo {
  unsigned degree;            ///< s
  unsigned coefficients;      ///< a: the bits a_1 ... a_(s-1), a_1 the highest
  std::array<unsigned, 7> m;  ///< m_1 ... m_s, then zeros
};

/// The first 32 dimensions of new-joe-kuo-6 (S. Joe, F. Y. Kuo, "Constructing Sobol' sequences with
/// better two-dimensional projections", SIAM J. Sci. Comput. 30, 2008), counted from 0. Dimension 0
/// has no polynomial: it is the van der Corput sequence, for which every m_k is 1.
inline constexpr std::array<JoeKuo, 32> joe_kuo{{
    {0, 0, {}},
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
    {6, 19, {1, 1, 1, 15, 7, 5}},
    {6, 22, {1, 3, 1, 15, 13, 25}},
    {6, 25, {1, 1, 5, 5, 19, 61}},
    {7, 1, {1, 3, 7, 11, 23, 15, 103}},
    {7, 4, {1, 3, 7, 13, 13, 15, 69}},
    {7, 7, {1, 1, 3, 13, 7, 35, 63}},
    {7, 8, {1, 3, 5, 9, 1, 25, 53}},
    {7, 14, {1, 3, 1, 13, 9, 35, 107}},
    {7, 19, {1, 3, 1, 5, 27, 61, 31}},
    {7, 21, {1, 1, 5, 11, 19, 41, 61}},
    {7, 28, {1, 3, 5, 3, 3, 13, 69}},
    {7, 31, {1, 1, 7, 13, 1, 19, 1}},
    {7, 32, {1, 3, 7, 5, 13, 19, 59}},
    {7, 37, {1, 1, 3, 9, 25, 29, 41}},
    {7, 41, {1, 3, 5, 13, 23, 1, 55}},
    {7, 42, {1, 3, 7, 3, 13, 59, 17}},
}};

}  // namespace mc
