// Attacks on all tasks of the lab. Sections: see CONTRIBUTING.md.

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
