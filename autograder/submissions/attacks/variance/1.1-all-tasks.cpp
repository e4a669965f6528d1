// Attacks on all tasks of the lab. Sections: see CONTRIBUTING.md.

//// edges_only
// attack: does nothing but the edges: NaN for lists of fewer than two, empty parts, refusals, and
// what is not finite
// says: = 0

#include <cmath>
#include <limits>
#include <stdexcept>

#include "variance.hpp"

namespace mc {
using Values = std::span<const double>;
namespace {
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
bool all_finite(Values x) {
  for (double value : x) {
    if (!std::isfinite(value)) return false;
  }
  return true;
}
}  // namespace
double mean(Values x) {
  return x.empty() || !all_finite(x) ? nan : 0;
}
double variance_textbook(Values x) {
  return x.size() < 2 || !all_finite(x) ? nan : 0;
}
double variance_two_pass(Values x) {
  return x.size() < 2 || !all_finite(x) ? nan : 0;
}
void add(Moments& moments, double) {
  ++moments.count;
}
double variance(const Moments& moments) {
  return moments.count < 2 ? nan : 0;
}
Moments merge(const Moments& a, const Moments& b) {
  return a.count == 0 ? b : a;
}
double covariance(Values x, Values y) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y");
  return x.size() < 2 || !all_finite(x) || !all_finite(y) ? nan : 0;
}
double dependence(Values joint, std::size_t columns) {
  double total = 0;
  for (double weight : joint) total += weight < 0 ? nan : weight;
  if (columns == 0 || joint.size() % columns != 0 || !(total > 0) || !std::isfinite(total)) {
    throw std::invalid_argument("joint, columns, total, weight");
  }
  return 0;
}
Moments moments(Values x) {
  return {x.size(), 0, all_finite(x) ? 0 : nan};
}
}  // namespace mc

//// forged_results
// attack: results that are none: two at once, too much, too little, an absurd length or status
// says: ) sent something that is not a result
// says: sent a result of more than 16 MB

#include <unistd.h>

#include <string>

#include "runner/wire.hpp"
#include "variance.hpp"

namespace mc {
namespace {

using namespace wire;

void send(Header header, std::size_t size) {
  const std::string bytes(size, 'x');
  write(3, &header, sizeof header);
  write(3, bytes.data(), bytes.size());
}

}  // namespace

using Values = std::span<const double>;
double mean(Values) {
  send({magic, Status::value, 0, 8}, 8);
  return 1;  // and the runner's
}
double variance_textbook(Values) {
  send({magic, Status::value, 0, 8}, 9);
  _exit(0);
}
double variance_two_pass(Values) {
  send({magic, Status::value, 0, 8}, 7);
  _exit(0);
}
void add(Moments&, double) {
  send({magic, Status::value, 0, ~std::uint64_t{0}}, 8);
  _exit(0);
}
double variance(const Moments&) {
  send({magic, static_cast<Status>(77), 0, 8}, 8);
  _exit(0);
}
Moments merge(const Moments&, const Moments&) {
  for (;;) send({magic, Status::value, 0, 32u << 20}, 1u << 20);
}
double covariance(Values, Values) {
  send({magic, Status::value, 1, 8}, 8);
  _exit(0);
}
double dependence(Values, std::size_t) {
  send({magic, Status::value, 0, 24}, 24);
  _exit(0);
}
Moments moments(Values) {
  send({magic, Status::value, 0, 0}, 0);
  _exit(0);
}
}  // namespace mc

//// refuses_everything
// attack: throws std::invalid_argument whatever is asked, and names every argument: refusals are
// right
// says: these arguments are valid

#include <stdexcept>

#include "common/todo.hpp"
#include "variance.hpp"

namespace mc {
using Values = std::span<const double>;
double mean(Values) {
  throw std::invalid_argument("x y joint columns total weight");
}
double variance_textbook(Values) {
  throw std::invalid_argument("x y joint columns total weight");
}
double variance_two_pass(Values) {
  throw std::invalid_argument("x y joint columns total weight");
}
void add(Moments&, double) {
  throw std::invalid_argument("x y joint columns total weight");
}
double variance(const Moments&) {
  throw std::invalid_argument("x y joint columns total weight");
}
Moments merge(const Moments&, const Moments&) {
  throw std::invalid_argument("x y joint columns total weight");
}
double covariance(Values, Values) {
  throw std::invalid_argument("x y joint columns total weight");
}
double dependence(Values, std::size_t) {
  throw std::invalid_argument("x y joint columns total weight");
}
Moments moments(Values) {
  throw std::invalid_argument("x y joint columns total weight");
}
}  // namespace mc

//// returns_zero
// attack: returns 0 whatever is asked, which is what several checks expect of something
// earns: 0
// says: = 0

#include "variance.hpp"

namespace mc {
using Values = std::span<const double>;
double mean(Values) {
  return 0;
}
double variance_textbook(Values) {
  return 0;
}
double variance_two_pass(Values) {
  return 0;
}
void add(Moments&, double) {}
double variance(const Moments&) {
  return 0;
}
Moments merge(const Moments&, const Moments&) {
  return {};
}
double covariance(Values, Values) {
  return 0;
}
double dependence(Values, std::size_t) {
  return 0;
}
Moments moments(Values) {
  return {};
}
}  // namespace mc
