// attack: a destructor that writes a result of its own, before the true one
// says: sent something that is not a result

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

class Attack final : public Sampler {
 public:
  void generate(std::size_t, std::uint64_t) override {}
  double next() override { return 0.5; }
  Point2 next2() override { return {0.5, 0.5}; }
  void advance() override {}
  ~Attack() override { forge(); }
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view) {
  return std::make_unique<Attack>();
}

double integrate(const Scene&, Sampler&, std::size_t, std::uint64_t) {
  throw todo("6.5");
}

Image render(const PixelScene&, Sampler&, std::size_t, std::uint64_t) {
  throw todo("6.6");
}

}  // namespace mc
