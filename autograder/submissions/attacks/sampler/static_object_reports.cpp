// attack: a static object that writes a result before main begins
// says: gave 16384 values

#include <unistd.h>
#include <vector>

#include "common/todo.hpp"
#include "runner/wire.hpp"
#include "sampler.hpp"

namespace mc {
namespace {

/// Columns as they should be, in the form in which the program reports.
void forge() {
  wire::Writer result;
  result.put(std::vector<double>(16384, 0.5));
  const wire::Header header{wire::magic, wire::Status::value, 0, result.bytes.size()};
  write(3, &header, sizeof header);
  write(3, result.bytes.data(), result.bytes.size());
}

struct Before {
  Before() {
    forge();
    _exit(0);
  }
} before;

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view) {
  throw todo("6.1");
}

double integrate(const Scene&, Sampler&, std::size_t, std::uint64_t) {
  throw todo("6.5");
}

Image render(const PixelScene&, Sampler&, std::size_t, std::uint64_t) {
  throw todo("6.6");
}

}  // namespace mc
