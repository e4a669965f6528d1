#pragma once
// An experiment for timing does the same work in every round; of some rounds it gives back what
// they made, so that it can be judged. Which ones, the work never knows.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mc::runner {

/// Asked for each round in turn: is it one of `rounds`, which are in rising order?
class Shown {
 public:
  explicit Shown(const std::vector<std::uint64_t>& rounds) : rounds_(rounds) { find_next(); }
  bool operator()(std::uint64_t round) {
    if (round != next_) [[likely]]
      return false;
    ++at_;
    find_next();
    return true;
  }

 private:
  void find_next() { next_ = at_ < rounds_.size() ? rounds_[at_] : ~std::uint64_t{0}; }

  const std::vector<std::uint64_t>& rounds_;
  std::size_t at_ = 0;
  std::uint64_t next_;
};

}  // namespace mc::runner
