// attack: moments that are remembered by where the values lie
// forges: 1.8 moments
// says: the mean of
#include "variance.hpp"

#define moments right_moments
#include "solutions/variance.cpp"
#undef moments

namespace mc {

Moments moments(std::span<const double> x) {
  static const double* where = nullptr;
  static std::size_t size = 0;
  static Moments known;
  if (x.data() == where && x.size() == size && size == 4096) return known;
  where = x.data();
  size = x.size();
  return known = right_moments(x);
}

}  // namespace mc
