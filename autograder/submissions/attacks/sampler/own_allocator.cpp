// attack: replaces operator delete by one that ends with success
// says: called exit(0) instead of returning

#include <unistd.h>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string>

#include "common/todo.hpp"
#include "sampler.hpp"

namespace mc {

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  throw std::invalid_argument(std::string(kind) + " is no kind");
}

double integrate(const Scene&, Sampler&, std::size_t, std::uint64_t) {
  throw todo("6.5");
}

Image render(const PixelScene&, Sampler&, std::size_t, std::uint64_t) {
  throw todo("6.6");
}

}  // namespace mc

void operator delete(void*) noexcept {
  _exit(0);
}
void operator delete(void*, std::size_t) noexcept {
  _exit(0);
}
