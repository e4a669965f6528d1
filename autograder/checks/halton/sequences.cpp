// 5.3 to 5.5: primes, Halton, Hammersley and Sobol' points.

#include "5-halton/experiments.hpp"
#include "checks/halton/exact_points.hpp"

namespace mc::checks {
namespace {

/// The columns from `from_axis` on are radical inverses in one prime per axis.
template <class Points>
void check_axes(const Points& got, std::uint64_t n, std::uint64_t dims, std::uint64_t first,
                std::size_t from_axis);
void check_hammersley(std::uint64_t n, std::uint64_t dims);
void check_sobol(unsigned dimension, std::uint64_t first, std::uint64_t count);

CHECK_CASE("5.3 the first primes", "[5.3][points:3]") {
  const auto primes = sieved_primes(66000);
  // The numbers of primes below a power of two, and one more: 18 below 64, 54 below 256, …
  std::vector<std::uint64_t> counts{10, 100 + rng() % 1900, 6542, 6543, 564, 565, 172, 173};
  append(counts, std::vector{54, 55, 31, 32, 18, 19, 11, 12, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0});
  for (const std::uint64_t count : counts) {
    const auto measured = MEASURE(primes, count);
    const auto& list = measured.exactly(count);
    const std::vector<double> got(list.begin(), list.end());
    std::vector<double> from_1{1};
    from_1.insert(from_1.end(), primes.begin(),
                  primes.begin() + static_cast<std::ptrdiff_t>(count));
    from_1.resize(count);
    expect_each(
        {measured.call, got},
        {.exact = {primes.begin(), primes.begin() + static_cast<std::ptrdiff_t>(count)},
         .because = "the primes in order: 2, 3, 5, 7, 11, …",
         .suspects = {{from_1, "1 is not prime"_likely}},
         .rule = "the only divisors of a prime are 1 and itself; list each once, in order"});
  }
}

CHECK_CASE("5.3 Halton points have one prime per axis", "[5.3][points:5][needs:5.1][main]") {
  for (const std::uint64_t dims : {2u, 3u, 12u, 40u, 1u}) {
    for (const std::uint64_t first : {std::uint64_t{0}, 1 + rng() % 1000}) {
      const std::uint64_t n = 30 + rng() % (dims < 20 ? 300 : 20);
      check_axes(MEASURE(halton, n, dims, first), n, dims, first, 0);
    }
  }
}

CHECK_CASE("5.3 many axes and late points", "[5.3][points:3][needs:5.1]") {
  for (const std::uint64_t first : {(std::uint64_t{1} << 32) + 1 + rng() % 1000, last_index - 99,
                                    rng() >> 8, std::uint64_t{1}}) {
    for (const std::uint64_t n : {100u, 1u})
      check_axes(MEASURE(halton, n, 9, first), n, 9, first, 0);
  }
  for (const std::uint64_t dims : {200u, 33u, 32u, 17u}) {
    check_axes(MEASURE(halton, 20, dims, dims), 20, dims, dims, 0);
  }
  for (const std::uint64_t n : {4097u, 1023u, 2u, 1u}) {
    check_axes(MEASURE(halton, n, 3, n), n, 3, n, 0);
  }
}

CHECK_CASE("5.4 Hammersley points", "[5.4][points:3][needs:5.3][main]") {
  for (const std::uint64_t dims : {2u, 3u, 9u}) {
    for (const std::uint64_t n : {std::uint64_t{256}, 2 + rng() % 1000}) check_hammersley(n, dims);
  }
}

CHECK_CASE("5.4 any number of points and axes", "[5.4][points:2][needs:5.3]") {
  for (const std::uint64_t dims : {33u, 17u, 60u, 201u, 1u}) check_hammersley(30 + dims, dims);
  for (const std::uint64_t n : domain::sizes(5000, rng)) check_hammersley(n, 1 + n % 3);
  check_hammersley(70001, 2);
}

CHECK_CASE("5.5 the first points of all 32 dimensions", "[5.5][points:7][main]") {
  for (unsigned d = 0; d < joe_kuo.size(); ++d) check_sobol(d, 0, 600);
}

CHECK_CASE("5.5 a column of Sobol' points may begin anywhere", "[5.5][points:5]") {
  const auto words = domain::words(sobol_end - 3001, rng);
  const auto any_dimension = [&] { return static_cast<unsigned>(rng() % joe_kuo.size()); };
  check_sobol(any_dimension(), 1 + rng() % 5000, 1500 + rng() % 1500);
  for (unsigned d = 0; d < joe_kuo.size(); ++d) {
    check_sobol(d, words[rng() % words.size()], 1 + rng() % 3000);
    check_sobol(d, sobol_end - 700, 700);
  }
  // A column that begins where one in another dimension ended; replayed in one process.
  for (const unsigned d : {7u, 2u, 7u}) check_sobol(d, d == 2 ? 1000 : 1300, 300);
}

CHECK_CASE("5.5 a column of Sobol' points has any size", "[5.5][points:2]") {
  for (const std::uint64_t count : domain::sizes(65537, rng)) {
    check_sobol(static_cast<unsigned>(count % joe_kuo.size()), rng() % 300, count);
  }
  check_sobol(3, 5, 0);
}

template <class Points>
void check_axes(const Points& got, std::uint64_t n, std::uint64_t dims, std::uint64_t first,
                std::size_t from_axis) {
  static const auto primes = sieved_primes(2000);
  const std::span<const double> columns = got.exactly(n * dims, any_number);
  for (std::size_t d = from_axis; d < dims; ++d) {
    expect_inverses({fmt::format("{}, coordinate {}", got.call, d), columns.subspan(d * n, n)},
                    {primes[d - from_axis], domain::in_a_row(first, n),
                     "column d holds the radical inverses in prime d"});
  }
}

void check_hammersley(std::uint64_t n, std::uint64_t dims) {
  const auto measured = MEASURE(hammersley, n, dims);
  const std::span<const double> got = measured.exactly(n * dims, any_number);
  Values centered = steps(n);
  for (double& x : centered) x += 0.5 / static_cast<double>(n);
  expect_each(
      {measured.call + ", coordinate 0", got.first(n)},
      {.exact = steps(n),
       .tolerance = {2 * half_ulp},
       .because = "coordinate 0 of point i is i / N",
       .suspects = {{centered, "this is the centered variant: coordinate 0 is i / N"_likely},
                    {std::vector<double>(n),
                     "i / N of two integers is 0: convert to double before the division"_likely}},
       .rule = "i / N in double division"});
  check_axes(measured, n, dims, 0, 1);
}

/// The hint from the first wrong direction number, in a column from index 0 on.
std::string direction_hint(std::uint64_t first_wrong, unsigned dimension) {
  const unsigned degree = joe_kuo[dimension].degree;
  const auto k = static_cast<unsigned>(std::bit_width(first_wrong));
  if (degree == 0 || k <= degree) return "m_1 to m_s are given in the table, s its degree";
  return fmt::format(
      "all values are correct up to m_{}, and m_{} is the first that the recurrence computes: m_k "
      "= 2 a_1 m_(k-1) ^ 4 a_2 m_(k-2) ^ … ^ 2^s m_(k-s) ^ m_(k-s), a_1 the highest bit of "
      "`coefficients`, s = {} here",
      k - 1, k, degree);
}

/// The hint for an index above a column's beginning: which direction number was wrong or left out.
std::string late_hint(double got, unsigned dimension, std::uint64_t index) {
  const std::string rule = "each of the 32 bits of an index selects a direction number";
  if (!(got >= 0 && got < 1)) return rule;
  const auto v = sobol_directions(dimension);
  const auto off = static_cast<std::uint32_t>(got * 0x1p32) ^ sobol_word(v, index);
  for (std::size_t k = 0; k < v.size(); ++k) {
    if (off == v[k]) {
      return fmt::format("{}: the result is off by v_{}, that of bit {}, which is {} here", rule, k,
                         k, index >> k & 1);
    }
  }
  return rule;
}

std::uint64_t gray_code(std::uint64_t i) {
  return i ^ i >> 1;
}

/// In dimension 1, direction numbers with m_k for m_(k+1) give the same values as Gray-code order.
bool is_gray_code_in_dimension_2() {
  const auto got = MEASURE(sobol, 2, 0, 64);
  const auto v = sobol_directions(2);
  const auto in_order = [&](std::uint64_t i) { return sobol_value(v, gray_code(i)); };
  return std::ranges::equal(got.exactly(64, any_number), each(domain::in_a_row(0, 64), in_order));
}

/// The values that well-known mistakes give.
std::vector<Curve> sobol_suspects(unsigned dimension, const std::vector<std::uint64_t>& indices) {
  std::vector<Curve> all;
  const auto suspect = [&](auto v, auto index, const Likely& hint) {
    all.push_back({each(indices, [&](std::uint64_t i) { return sobol_value(v, index(i)); }), hint});
  };
  const auto same = [](std::uint64_t i) { return i; };
  const auto exact = sobol_directions(dimension);
  auto halved = exact;
  for (std::size_t k = 1; k < halved.size(); ++k) halved[k] = exact[k - 1] >> 1;
  suspect(halved, same,
          "bit k of the index, from 0, selects v_k = m_(k+1) 2^-(k+1): m_k is used in place of "
          "m_(k+1)"_likely);
  all.push_back(
      {each(indices,
            [&](std::uint64_t i) {
              return static_cast<double>(static_cast<float>(sobol_value(exact, i)));
            }),
       "only about seven digits are correct, as in a float: use double everywhere"_likely});
  if (is_gray_code_in_dimension_2()) {
    suspect(exact, gray_code, "these are the points in Gray-code order: another order"_likely);
  }
  suspect(
      exact, [](std::uint64_t i) { return i + 1; },
      "this starts one index too late: point 0 is the origin"_likely);
  return all;
}

void check_sobol(unsigned dimension, std::uint64_t first, std::uint64_t count) {
  const auto measured = MEASURE(sobol, dimension, first, count);
  const std::span<const double> got = measured.exactly(count, any_number);
  const std::vector<std::uint64_t> indices = domain::in_a_row(first, count);
  Comparison comparison{sobol_points(dimension, first, count),
                        {0},
                        "the XOR of the direction numbers of the set bits of the index"};
  comparison.name = [&](std::size_t i) {
    return fmt::format("{}: value {}, of index {},", measured.call, i, indices[i]);
  };
  if (!difference({measured.call, got}, comparison)) return pass();
  comparison.suspects = sobol_suspects(dimension, indices);
  const auto wrong = static_cast<std::size_t>(
      std::mismatch(got.begin(), got.end(), comparison.exact.begin()).first - got.begin());
  comparison.rule = first == 0 ? direction_hint(wrong, dimension)
                               : late_hint(got[wrong], dimension, indices[wrong]);
  expect_each({measured.call, got}, comparison);
}

}  // namespace
}  // namespace mc::checks
