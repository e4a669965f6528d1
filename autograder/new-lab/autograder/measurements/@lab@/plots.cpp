// The data of lab @number@'s plots.

#include "@folder@/experiments.hpp"
#include "checks/support/catch.hpp"
#include "measurements/support/plot_data.hpp"

namespace mc::measurements {
namespace {

TEST_CASE("plot squares", "[.plot]") {
  Values xs;
  for (int i = -10; i <= 10; ++i) xs.push_back(i);
  const Values found = values_of(TRY_MEASURE(squares, xs), xs.size(), any_number);
  plot_table("squares.tsv", {"x", xs}, {"square"}, [&](double x, std::size_t) {
    return found.empty() ? missing : found[static_cast<std::size_t>(x + 10)];
  });
}

}  // namespace
}  // namespace mc::measurements
