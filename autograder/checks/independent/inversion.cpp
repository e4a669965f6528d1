// 2.3: sampling by inversion, and the densities of the samples.

#include "checks/independent/functions.hpp"

namespace mc::checks {
namespace {

using Function1 = std::function<double(double)>;

/// A function of one argument, and a well-known mistake in it.
struct FunctionCase {
  Function1 exact, tolerance;
  std::string because;
  std::vector<std::pair<Function1, Likely>> mistakes;
  std::string rule;
};

void judge_values(const std::string& call, const Values& got, const char* argument, const Values& x,
                  const FunctionCase& of);
std::vector<Values> arguments(Rng& rng);

CHECK_CASE("2.3 exponential samples by inversion", "[2.3][points:5][main]") {
  for (const double rate :
       {uniform(rng, 1.5, 1000), uniform(rng, 0.001, 0.7), 1.0, 1e-300, 1e290, 1e-310}) {
    const auto exact = [=](double at) { return -std::log1p(-at) / rate; };
    for (Values u : arguments(rng)) {
      std::erase_if(u, [&](double at) { return !std::isfinite(exact(at)); });
      if (u.empty()) continue;
      const auto got = MEASURE(sample_exponential, u, rate);
      judge_values(got.call, got.exactly(u.size(), any_number), "u", u,
                   {exact,
                    [&](double at) { return 4 * eps * exact(at) + denormal; },
                    "P(x) = 1 - exp(-rate x) = u, to 4 ulp",
                    {{[=](double at) { return -std::log(at) / rate; },
                      "this is -log(u) / rate: it decreases in u, and is infinite at u = 0"_likely},
                     {[=](double at) { return -std::log(1 - at) / rate; },
                      "1 - u loses the last digits of a small u: use log1p(-u)"_likely},
                     {[=](double at) { return -std::log1p(-at) * rate; },
                      "divide by the rate: a high rate means short times"_likely}},
                    "solve 1 - exp(-rate x) = u for x, for every u in [0, 1): clamp none"});
    }
  }
}

CHECK_CASE("2.3 power samples by inversion", "[2.3][points:4]") {
  for (const double a : {uniform(rng, 1.5, 9), uniform(rng, -0.9, -0.1), 1.0, -0.5, -0.75, -0.99,
                         0.0, 1e6, -1e-4, 1e-9}) {
    const auto exact = [=](double at) {
      return static_cast<double>(std::pow(static_cast<long double>(at), 1 / (a + 1.0L)));
    };
    const auto tolerance = [=](double at) {  // the exponent or a logarithm is rounded
      const double magnified = at > 0 ? std::abs(std::log(at)) / (a + 1) : 0;
      return 4 * eps * (1 + magnified) * exact(at) + 2 * denormal;
    };
    for (const Values& u : arguments(rng)) {
      const auto got = MEASURE(sample_power, u, a);
      judge_values(got.call, got.exactly(u.size(), any_number), "u", u,
                   {exact,
                    tolerance,
                    "P(x) = x^(a+1) = u, to 4 ulp plus a rounded exponent or logarithm",
                    {{[=](double at) { return a == 0 ? nan : std::pow(at, 1 / a); },
                      "integrating x^a raises the exponent: use 1 / (a + 1)"_likely}},
                    "solve x^(a+1) = u for x"});
      got.exactly(u.size(), closed_unit);
    }
  }
}

CHECK_CASE("2.3 the densities of the samples", "[2.3][points:4]") {
  for (const double rate :
       {uniform(rng, 1.5, 1000), uniform(rng, 0.001, 0.7), 1.0, 1e-300, 1e300}) {
    Values x;
    for (int i = 0; i < 100; ++i) x.push_back(uniform(rng, -1, 9) / rate);
    for (const double far : {-1e9, 1.0, 40.0, 300.0, 700.0}) x.push_back(far / rate);
    x.insert(x.end(), {-1, -1e-300, 0, infinity, -infinity});
    const auto exact = [=](double at) { return at < 0 ? 0 : rate * std::exp(-rate * at); };
    const auto tolerance = [=](double at) {
      return exact(at) > 0 ? 4 * eps * (1 + rate * std::abs(at)) * exact(at) : 0;
    };
    const auto got = MEASURE(pdf_exponential, x, rate);
    judge_values(got.call, got.exactly(x.size(), any_number), "x", x,
                 {exact,
                  tolerance,
                  "rate exp(-rate x) for x >= 0, and 0 below",
                  {{[=](double at) { return rate * std::exp(-rate * at); },
                    "the density is 0 for x < 0"_likely}},
                  "the derivative of P(x) = 1 - exp(-rate x); x = 0 belongs to the support"});
  }
  for (const double a : {uniform(rng, 1.5, 9), uniform(rng, -0.9, -0.1), 1.0, -0.5, 0.0, 1e-4}) {
    Values x;
    for (int i = 0; i < 100; ++i) x.push_back(uniform(rng, -0.5, 1.5));
    x.insert(x.end(),
             {-1, -1e-300, std::nextafter(1.0, 2.0), 2, infinity, -infinity, 1e-300, 0, 1});
    const auto exact = [=](double at) { return at < 0 || at > 1 ? 0 : (a + 1) * std::pow(at, a); };
    const auto tolerance = [=](double at) {
      const double magnified = at > 0 ? std::abs(a * std::log(at)) : 0;
      return std::isfinite(exact(at)) ? 8 * eps * (1 + magnified) * exact(at) + denormal : 0;
    };
    const auto got = MEASURE(pdf_power, x, a);
    judge_values(got.call, got.exactly(x.size(), any_number), "x", x,
                 {exact,
                  tolerance,
                  "(a + 1) x^a on [0, 1], including both ends, and 0 outside",
                  {{[=](double at) { return at < 0 || at > 1 ? 0 : std::pow(at, a); },
                    "a density integrates to 1: x^a alone gives 1 / (a + 1)"_likely}},
                  "the derivative of P(x) = x^(a+1), and 0 outside [0, 1]"});
  }
}

// What the cases above use ------------------------------------------------------------------------

void judge_values(const std::string& call, const Values& got, const char* argument, const Values& x,
                  const FunctionCase& of) {
  Comparison comparison{each(x, of.exact), each(x, of.tolerance), of.because};
  for (const auto& [value, hint] : of.mistakes) {
    comparison.suspects.push_back({each(x, value), hint});
  }
  comparison.rule = of.rule;
  comparison.separate_calls = true;
  comparison.name = [&](std::size_t i) {
    return fmt::format("{} at {} = {}", call, argument, x[i]);
  };
  expect_each({call, got}, comparison);
}

/// Ordinary numbers of [0, 1), which a guard does not change; then tiny ones, nearly 1, both ends.
std::vector<Values> arguments(Rng& rng) {
  Values ordinary, others{0, denormal, 1e-300, 0x1p-53, 0.5, 1 - 0x1p-53};
  for (int i = 0; i < 500; ++i) {
    ordinary.push_back(uniform(rng, 1e-3, 1));
    others.push_back(std::nextafter(ordinary.back(), 0.0));
    others.push_back(std::pow(10, -uniform(rng, 0, 30)));
    others.push_back(1 - std::ldexp(1.0, -1 - static_cast<int>(rng() % 53)));
  }
  return {ordinary, others};
}

}  // namespace
}  // namespace mc::checks
