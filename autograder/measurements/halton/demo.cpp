// Lab 5 in the demo: columns of Halton and Sobol' points, without and with scrambling.

#include <fmt/format.h>

#include "checks/support/catch.hpp"
#include "measurements/halton/methods.hpp"
#include "measurements/support/demo.hpp"

namespace mc::measurements {
namespace {

/// A column, and `count` scrambled ones; to 30 bits, of which no elementary interval needs more.
template <class Scramble>
void write_columns(const std::string& key, const std::string& name, const Sets& plain,
                   unsigned number, Scramble scramble) {
  constexpr Count n = 1024, count = 16;
  if (plain.empty()) return;
  Seeds seeds(count);
  std::iota(seeds.begin(), seeds.end(), Count{number} << 20);
  const auto first = plain[0].column(0);
  std::vector<std::string> columns{encoded(first, 5)};
  for (const PointSet& one : sets_of(scramble({first.begin(), first.end()}, seeds), n, 1, count)) {
    columns.push_back(encoded(one.column(0), 5));
  }
  write_demo(5, key, {{"name", name}, {"columns", columns}});
}

/// As in lab 6: base 2 by 5.8, whose errors fall faster than those of 5.9, other bases by 5.9.
TEST_CASE("demo", "[.demo]") {
  begin_demo();
  constexpr Count n = 1024;
  const auto owen = [](const std::vector<double>& column, const Seeds& seeds) {
    return TRY_MEASURE(owen_scramble, column, seeds);
  };
  for (const unsigned base : {2u, 3u, 5u, 7u, 29u, 31u}) {
    const Sets plain = sets_of(TRY_MEASURE(radical_inverses, base, 0, n), n, 1, 1);
    const std::string key = fmt::format("base-{}", base), name = fmt::format("base {}", base);
    if (base == 2) {
      write_columns(key, name, plain, base, owen);
      continue;
    }
    write_columns(key, name, plain, base, [&](const std::vector<double>&, const Seeds& seeds) {
      return TRY_MEASURE(radical_inverses_scrambled, base, 0, n, seeds);
    });
  }
  write_columns("sobol", "Sobol' 1", sobol_sets(n, {1}), 1, owen);
}

}  // namespace
}  // namespace mc::measurements
