// Lab 5 against the GNU Scientific Library, which generates points of `dims` coordinates.

#ifdef MC_HAVE_GSL

#include <functional>
#include <string>
#include <vector>

#include <gsl/gsl_qrng.h>

#include "bench/ratios/compare.hpp"
#include "halton.hpp"

namespace mc::ratios {
namespace {

void sequences(unsigned dims, bool has_wishes) {
  const auto from = [&](const gsl_qrng_type* type) {
    gsl_qrng* const sequence = gsl_qrng_alloc(type, dims);
    return [=, point = std::vector<double>(dims)]() mutable {
      gsl_qrng_init(sequence);
      for (std::size_t i = 0; i < block; ++i) gsl_qrng_get(sequence, point.data());
      sink = point[0];
    };
  };
  const auto bases = primes(dims);
  std::vector<double> column(block);
  const auto time = [&](const char* what, const char* against, double wanted, auto make,
                        const gsl_qrng_type* type) {
    compare(
        {std::string(what) + ", " + std::to_string(dims) + "D", against, has_wishes ? wanted : 0,
         static_cast<double>(block) * dims},
        [&] {
          for (unsigned d = 0; d < dims; ++d) make(d);
          sink = column.back();
        },
        from(type));
  };
  time(
      "radical_inverses", "GSL's Halton points", 50,
      [&](unsigned d) { radical_inverses(bases[d], 0, column); }, gsl_qrng_halton);
  time(
      "sobol", "GSL's Sobol' points", 8, [&](unsigned d) { sobol(d, 0, column); }, gsl_qrng_sobol);
  time(
      "owen_scramble", "GSL's Sobol' points", 1,
      [&](unsigned d) {
        sobol(d, 0, column);
        owen_scramble(column, d);
      },
      gsl_qrng_sobol);
}

const Measurements here(7, [] {
  for (const unsigned dims : {2u, 4u, 8u}) sequences(dims, dims == 2);
});

}  // namespace
}  // namespace mc::ratios

#endif
