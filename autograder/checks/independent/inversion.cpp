// Task 2.3: sampling by inversion, and the densities of what is sampled.

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "checks/independent/functions.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/expect.hpp"
#include "checks/support/measure.hpp"

namespace mc::checks {
namespace {

using Curve = std::function<double(double)>;

/// What a mistake makes of an argument, and what to say then.
struct Rule {
  Curve value;
  std::string hint;
  double from = -HUGE_VAL;  ///< arguments below this say nothing: a guard may stand there
};

/// A rule fits where it gives what was measured for nine out of ten of the values that are wrong (a
/// few may round in another way).
bool fits(const Rule& rule, const Values& x, const Values& got, const std::vector<bool>& wrong) {
  std::size_t all = 0, same = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!wrong[i] || x[i] < rule.from) continue;
    const double value = rule.value(x[i]);
    ++all;
    same += got[i] == value || std::abs(got[i] - value) <= 1e-13 * std::abs(value) ? 1 : 0;
  }
  return all > 0 && same * 10 >= all * 9;
}

/// `got[i]` is `exact(x[i])` within `tolerance(x[i])`. `name` is that of the argument.
void expect_each(const std::string& call, const std::string& name, const Values& x,
                 const Values& got, const Curve& exact, const Curve& tolerance,
                 const std::string& because, const std::vector<Rule>& rules,
                 const std::string& otherwise) {
  std::vector<bool> wrong(x.size());
  std::size_t first = x.size();
  for (std::size_t i = x.size(); i-- > 0;) {
    const double right = exact(x[i]);
    wrong[i] = !(got[i] == right || std::abs(got[i] - right) <= tolerance(x[i]));
    if (wrong[i]) first = i;
  }
  if (first == x.size()) return pass();
  std::string hint = otherwise;
  for (const Rule& rule : rules) {
    if (!fits(rule, x, got, wrong)) continue;
    hint = rule.hint;
    break;
  }
  expect_that(false, fmt::format("{} at {} = {}: {}", call, name, x[first], got[first]),
              fmt::format("{}, give or take {:.2g}", exact(x[first]), tolerance(x[first])), because,
              hint);
}

/// Numbers of [0, 1): ordinary ones first, then tiny ones, and those that are nearly 1.
Values shares(Rng& rng) {
  Values u;
  for (int i = 0; i < 500; ++i) u.push_back(uniform(rng));
  for (int i = 0; i < 500; ++i) {
    u.push_back(std::nextafter(u[static_cast<std::size_t>(i)], 1.0));
    u.push_back(std::pow(10, -uniform(rng, 0, 30)));
    u.push_back(1 - std::ldexp(1.0, -1 - static_cast<int>(rng() % 53)));
  }
  u.insert(u.end(), {0, denormal, 1e-300, 0x1p-53, 0.5, 1 - 0x1p-53});
  std::erase_if(u, [](double value) { return !(value < 1); });
  return u;
}

/// What was measured at each u stays in the support, and does not fall when u rises.
void expect_inversion(const std::string& call, const Values& u, const Values& x, double last) {
  std::vector<std::size_t> order(u.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return u[a] < u[b]; });
  double before = 0, before_u = 0;
  for (const std::size_t i : order) {
    expect_that(x[i] >= 0 && x[i] <= last && std::isfinite(x[i]),
                fmt::format("{} at u = {}: {}", call, u[i], x[i]),
                last == 1 ? "a number in [0, 1]" : "a finite number, not negative",
                "every u in [0, 1) has its x in the support", "which u makes this so?");
    // Two neighbouring u may be rounded past each other, by the 4 ulp that each may be off.
    expect_that(
        x[i] >= before * (1 - 8 * eps),
        fmt::format("{}: {} at u = {}, but {} at u = {}", call, before, before_u, x[i], u[i]),
        "x that does not fall when u rises",
        "x is where the distribution reaches u: inversion keeps the order",
        "1 - u is as uniform as u, but with it x falls when u rises");
    before = x[i], before_u = u[i];
  }
}

CHECK_CASE("2.3 exponential samples by inversion", "[2.3][points:4][main]") {
  Rng rng = check_rng();
  for (const double rate : {uniform(rng, 1.5, 1000), uniform(rng, 0.001, 0.7), 1.0}) {
    const Values u = shares(rng);
    const auto measured = MEASURE(sample_exponential, u, rate);
    const Values& got = measured.exactly(u.size(), any_number);
    const auto exact = [=](double at) { return -std::log1p(-at) / rate; };
    expect_each(
        measured.call, "u", u, got, exact,
        [&](double at) { return 4 * eps * exact(at) + denormal; },
        "P(x) = 1 - exp(-rate x) = u, to 4 ulp",
        {{[=](double at) { return -std::log(at) / rate; },
          "this is -log(u) / rate, guarded or not: as good a distribution, but it falls when u "
          "rises, and at u = 0 it is infinite",
          1e-3},
         {[=](double at) { return -std::log(1 - at) / rate; },
          "1 - u forgets the last digits of a small u: log1p(-u) does not"},
         {[=](double at) { return -std::log1p(-at) * rate; },
          "divide by the rate: many events a second are short waits"},
         {[=](double at) { return std::log1p(-at) / rate; }, "the sign is wrong: log(1 - u) < 0"},
         {[=](double at) { return -std::log1p(-at); }, "where is the rate?"},
         {[=](double at) { return -std::log(at) * rate; },
          "this is -log(u) times the rate: divide by it, and 1 - u in place of u", 1e-3},
         {[=](double at) { return rate * std::exp(-rate * at); },
          "this is the density at u: inversion solves P(x) = u for x"},
         {[=](double at) { return -std::expm1(-rate * at); },
          "this is P(u): its inverse is asked for"}},
        "solve 1 - exp(-rate x) = u for x, with log1p");
    expect_inversion(measured.call, u, got, std::numeric_limits<double>::infinity());
  }
}

CHECK_CASE("2.3 power samples by inversion", "[2.3][points:4]") {
  Rng rng = check_rng();
  for (const double a :
       {uniform(rng, 1.5, 9), uniform(rng, -0.9, -0.1), 1.0, -0.5, -0.75, -0.99, 0.0}) {
    const Values u = shares(rng);
    const auto measured = MEASURE(sample_power, u, a);
    const Values& got = measured.exactly(u.size(), any_number);
    const auto exact = [=](double at) {
      return static_cast<double>(std::pow(static_cast<long double>(at), 1 / (a + 1.0L)));
    };
    expect_each(
        measured.call, "u", u, got, exact,
        [&](double at) {  // the exponent is rounded twice, and so is a logarithm on the way
          const double magnified = at > 0 ? std::abs(std::log(at)) / (a + 1) : 0;
          return 4 * eps * (1 + magnified) * exact(at) + 2 * denormal;
        },
        "P(x) = x^(a+1) = u, to 4 ulp and those of a rounded exponent",
        {{[=](double at) { return std::pow(at, a + 1); },
          "this is P(u): its inverse is u^(1/(a+1))"},
         {[=](double at) { return a == 0 ? nan : std::pow(at, 1 / a); },
          "integrating x^a raises the exponent: 1 / (a + 1)"},
         {[=](double at) { return std::pow(1 - at, 1 / (a + 1)); },
          "1 - u is as uniform as u, but with it x falls when u rises"},
         {[=](double at) { return (a + 1) * std::pow(at, a); },
          "this is the density at u: inversion solves P(x) = u for x"},
         {[=](double at) { return std::pow((a + 1) * at, 1 / (a + 1)); },
          "the integral of (a + 1) x^a is x^(a+1): a + 1 is gone"}},
        "solve x^(a+1) = u for x");
    expect_inversion(measured.call, u, got, 1);
  }
}

CHECK_CASE("2.3 the densities of what is sampled", "[2.3][points:3]") {
  Rng rng = check_rng();
  for (const double rate : {uniform(rng, 1.5, 1000), uniform(rng, 0.001, 0.7), 1.0}) {
    Values x;
    for (int i = 0; i < 100; ++i) x.push_back(uniform(rng, -1, 9) / rate);
    x.insert(x.end(), {-1, -1e-300, 0, 1 / rate});
    const auto measured = MEASURE(pdf_exponential, x, rate);
    const auto exact = [=](double at) { return at < 0 ? 0 : rate * std::exp(-rate * at); };
    expect_each(
        measured.call, "x", x, measured.exactly(x.size(), any_number), exact,
        [&](double at) { return 4 * eps * (1 + rate * std::abs(at)) * exact(at); },
        "rate exp(-rate x) for x >= 0, and nothing below",
        {{[=](double at) { return at < 0 ? 0 : std::exp(-rate * at); },
          "a density integrates to 1: the factor rate is missing"},
         {[=](double at) { return rate * std::exp(-rate * at); },
          "the density is 0 where the distribution does not reach"},
         {[=](double at) { return at > 0 ? rate * std::exp(-rate * at) : 0; },
          "x = 0 belongs to the support"}},
        "the derivative of P(x) = 1 - exp(-rate x)");
  }
  for (const double a : {uniform(rng, 1.5, 9), uniform(rng, -0.9, -0.1), 1.0, -0.5, 0.0}) {
    Values x;
    for (int i = 0; i < 100; ++i) x.push_back(uniform(rng, -0.5, 1.5));
    x.insert(x.end(), {-1, -1e-300, 0, 1, std::nextafter(1.0, 2.0), 2});
    const auto measured = MEASURE(pdf_power, x, a);
    const auto exact = [=](double at) { return at < 0 || at > 1 ? 0 : (a + 1) * std::pow(at, a); };
    expect_each(
        measured.call, "x", x, measured.exactly(x.size(), any_number), exact,
        [&](double at) {
          const double magnified = at > 0 ? std::abs(a * std::log(at)) : 0;
          return 8 * eps * (1 + magnified) * exact(at);
        },
        "(a + 1) x^a on [0, 1], both ends included, and nothing outside",
        {{[=](double at) { return at < 0 || at > 1 ? 0 : std::pow(at, a); },
          "a density integrates to 1: x^a alone gives 1 / (a + 1)"},
         {[=](double at) { return at <= 0 || at >= 1 ? 0 : (a + 1) * std::pow(at, a); },
          "the ends belong to [0, 1]"},
         {[=](double at) { return at < 0 || at >= 1 ? 0 : (a + 1) * std::pow(at, a); },
          "the ends belong to [0, 1]: 1, too"},
         {[=](double at) { return at <= 0 || at > 1 ? 0 : (a + 1) * std::pow(at, a); },
          "the ends belong to [0, 1]: 0, too"},
         {[=](double at) { return (a + 1) * std::pow(at, a); }, "the density is 0 outside [0, 1]"}},
        "the derivative of P(x) = x^(a+1), and 0 outside [0, 1]");
  }
}

CHECK_CASE("2.3 parameters that make no density are refused", "[2.3][points:2][edge]") {
  for (const double rate : {-1.0, 0.0, nan}) {
    const std::string because = "a rate is positive";
    expect_invalid_argument(MEASURE_OUTCOME(sample_exponential, {0.5}, rate), "", because);
    expect_invalid_argument(MEASURE_OUTCOME(pdf_exponential, {0.5}, rate), "", because);
  }
  for (const double a : {-2.0, -1.0, nan}) {
    const std::string because = "x^a has a finite integral over [0, 1] only for a > -1";
    expect_invalid_argument(MEASURE_OUTCOME(sample_power, {0.5}, a), "", because);
    expect_invalid_argument(MEASURE_OUTCOME(pdf_power, {0.5}, a), "", because);
  }
}

}  // namespace
}  // namespace mc::checks
