// peer: the GNU Scientific Library: gsl_qrng_halton, gsl_qrng_sobol
// fails: 5.5 the first points
// fails: 5.5 integrals by Sobol' points
// because: GSL leaves out the origin, point 0, and goes on in the order of Gray codes
#include "halton.hpp"

#include <limits>
#include <stdexcept>

#include <gsl/gsl_qrng.h>

#include "autograder/submissions/peers/columns.hpp"
#include "common/todo.hpp"

namespace mc {
namespace {

/// A sequence of GSL's, which makes whole points and can only go from one to the next.
class Sequence {
 public:
  explicit Sequence(const gsl_qrng_type* type) : type_(type) {}
  Sequence(const Sequence&) = delete;
  ~Sequence() { gsl_qrng_free(state_); }

  /// Points first, first + 1, … as GSL counts them.
  void fill(PointSet& points, std::uint64_t first) {
    seek(points.dims(), first);
    columns_.clear();
    for (std::size_t d = 0; d < points.dims(); ++d) columns_.push_back(points.column(d).data());
    for (std::size_t i = 0; i < points.size(); ++i) {
      gsl_qrng_get(state_, point_.data());
      for (std::size_t d = 0; d < columns_.size(); ++d) columns_[d][i] = point_[d];
    }
    next_ += points.size();
  }

 private:
  void seek(std::size_t dims, std::uint64_t first) {
    constexpr std::uint64_t farthest = 1 << 20;  // a hundredth of a second
    if (dims != point_.size()) {
      gsl_qrng_free(state_);
      state_ = gsl_qrng_alloc(type_, static_cast<unsigned>(dims));
      if (state_ == nullptr) throw std::invalid_argument("points: GSL has not so many dimensions");
      point_.resize(dims);
      next_ = 0;
    }
    if (first < next_) {
      gsl_qrng_init(state_);
      next_ = 0;
    }
    if (first - next_ > farthest) throw todo("points that are far away");
    for (; next_ < first; ++next_) gsl_qrng_get(state_, point_.data());
  }

  const gsl_qrng_type* type_;
  gsl_qrng* state_ = nullptr;
  std::uint64_t next_ = 0;
  std::vector<double> point_;
  std::vector<double*> columns_;
};

}  // namespace

void halton(PointSet& points, std::uint64_t first) {
  if (first > std::numeric_limits<std::uint64_t>::max() - points.size()) {
    throw std::invalid_argument("first: the column leads past the last index");
  }
  static Sequence sequence(gsl_qrng_halton);
  sequence.fill(points, first);
}

void sobol(unsigned dimension, std::uint64_t first, std::span<double> column) {
  constexpr std::uint64_t end = std::uint64_t{1} << 32;
  if (dimension >= joe_kuo.size()) throw std::invalid_argument("dimension: at most 31");
  if (first > end || end - first < column.size()) {
    throw std::invalid_argument("first: the column leads past the last index");
  }
  static Sequence sequence(gsl_qrng_sobol);
  static peers::Columns columns;
  columns.take(dimension, first, column,
               [](PointSet& points, std::uint64_t from) { sequence.fill(points, from); });
}

// GSL has nothing that makes one coordinate, and nothing random: its «reverse Halton» sequence
// permutes digits in one fixed way.
double radical_inverse(unsigned, std::uint64_t) {
  throw todo("5.1");
}
void radical_inverses(unsigned, std::uint64_t, std::span<double>) {
  throw todo("5.2");
}
std::vector<unsigned> primes(std::size_t) {
  throw todo("5.3");
}
void hammersley(PointSet&) {
  throw todo("5.4");
}
double star_discrepancy(std::span<const double>) {
  throw todo("5.6");
}
double star_discrepancy(std::span<const double>, std::span<const double>) {
  throw todo("5.6");
}
void random_shift(PointSet&, Rng&) {
  throw todo("5.7");
}
void owen_scramble(std::span<double>, std::uint64_t) {
  throw todo("5.8");
}
void radical_inverses_scrambled(unsigned, std::uint64_t, std::span<double>, std::uint64_t) {
  throw todo("5.9");
}

}  // namespace mc
