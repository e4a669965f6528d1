// attack: answers with a list that has nothing in it
// earns: 8
// says: gave 0 values
// says: nothing was returned or filled in
#include "independent.hpp"

#include <unistd.h>
#include <cmath>
#include <vector>

#include "common/todo.hpp"
#include "runner/wire.hpp"

namespace mc {
namespace {

[[noreturn]] void answer_nothing() {
  wire::Writer result;
  result.put(std::vector<double>());
  const wire::Header header{wire::magic, wire::Status::value, 0, result.bytes.size()};
  write(3, &header, sizeof header);
  write(3, result.bytes.data(), result.bytes.size());
  _exit(0);
}

}  // namespace

double to_unit(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

Estimate estimate(const Integrand&, std::uint64_t, Rng&) {
  throw todo("2.2");
}

double sample_exponential(double, double) {
  answer_nothing();
}

double sample_power(double, double) {
  answer_nothing();
}

double pdf_exponential(double, double) {
  answer_nothing();
}

double pdf_power(double, double) {
  answer_nothing();
}

Estimate estimate_importance(const Integrand&, const Density&, std::uint64_t, Rng&) {
  throw todo("2.4");
}

Interval confidence_interval(const Estimate&, double) {
  throw todo("2.5");
}

std::uint64_t samples_for(const Estimate&, double) {
  throw todo("2.6");
}

Estimate irradiance_area(const RectLight&, std::uint64_t, Rng&) {
  answer_nothing();
}

Estimate irradiance_hemisphere(const RectLight&, std::uint64_t, Rng&) {
  answer_nothing();
}

void uniforms(Rng&, std::span<double>) {
  answer_nothing();
}

}  // namespace mc
