// Exact moments against values computed in decimal arithmetic by two other methods.
#include "checks/support/exact.hpp"
#include "checks/support/catch.hpp"

using namespace mc::checks;

TEST_CASE("exact moments of NIST's data") {
  // The moments of the doubles nearest to NIST's decimals, to 16 digits.
  std::vector<double> numacc3{1000000.2}, numacc4{10000000.2};
  for (int i = 0; i < 500; ++i) {
    numacc3.insert(numacc3.end(), {1000000.1, 1000000.3});
    numacc4.insert(numacc4.end(), {10000000.1, 10000000.3});
  }
  CHECK(exact_moments(numacc3).variance == 0.0100000000069849193108392);
  CHECK(exact_moments(numacc4).variance == 0.01000000011175870926697414);
  CHECK(static_cast<double>(exact_mean(numacc3)) == 1000000.200000000011583383);
  CHECK(exact_moments(std::vector<double>{10000001, 10000003, 10000002}).variance == 1);
}
