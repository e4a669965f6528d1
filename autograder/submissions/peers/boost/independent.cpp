// peer: Boost.Random: mt19937_64, uniform_real_distribution, uniform_01
// fails: 2.1 the upper 53 bits
// because: uniform_01 rounds 64 bits to 53, and numbers near 0 keep more than a shift leaves
// fails: 2.1 no word becomes one
// because: what rounds up to 1 is drawn again, which never ends on a generator of one word
// limit: time
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>
#include <boost/random/uniform_real_distribution.hpp>

namespace mc {
using Engine = boost::random::mt19937_64;
using Uniform = boost::random::uniform_real_distribution<double>;
}  // namespace mc

#include "autograder/submissions/peers/with_engine.hpp"

namespace mc {

double to_unit(std::uint64_t bits) {
  Word word{bits};
  return boost::random::uniform_01<double>()(word);
}

}  // namespace mc
