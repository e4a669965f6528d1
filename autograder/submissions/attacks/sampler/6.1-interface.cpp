// What is called through the interface. Sections: see CONTRIBUTING.md.

#include <unistd.h>
#include <stdexcept>
#include <vector>

#include "runner/wire.hpp"
#include "sampler.hpp"

namespace mc {

/// Attacks override some of it.
class Half : public Sampler {
 public:
  void generate(std::size_t, std::uint64_t) override {}
  double next() override { return 0.5; }
  Point2 next2() override { return {0.5, 0.5}; }
  void advance() override {}
};

/// Columns as they should be, in the form in which the program reports.
[[maybe_unused]] static void forge() {
  wire::Writer result;
  result.put(std::vector<double>(16384, 0.5));
  const wire::Header header{wire::magic, wire::Status::value, 0, result.bytes.size()};
  write(3, &header, sizeof header);
  write(3, result.bytes.data(), result.bytes.size());
}

}  // namespace mc

//// a_picture_without_pixels
// attack: pictures of the right size that have no pixels, and some that have too many
// says: gave 0 values in

namespace mc {
Image render(const PixelScene& scene, Sampler&, std::size_t spp, std::uint64_t) {
  const std::size_t pixels = scene.width * scene.height;
  return {scene.width, scene.height, std::vector<double>(spp < 5 ? 0 : 2 * (pixels % 100'000))};
}
}  // namespace mc

//// advance_throws_a_number
// attack: throws what is no exception from advance()
// says: threw an exception that is not a std::exception

namespace mc {
class Attack final : public Half {
 public:
  void advance() override { throw 42; }
};

std::unique_ptr<Sampler> make_sampler(std::string_view) {
  return std::make_unique<Attack>();
}
}  // namespace mc

//// destructor_reports
// attack: a destructor that writes its own result, before the true one
// says: sent something that is not a result

namespace mc {
class Attack final : public Half {
 public:
  ~Attack() override { forge(); }
};

std::unique_ptr<Sampler> make_sampler(std::string_view) {
  return std::make_unique<Attack>();
}
}  // namespace mc

//// endless_next
// attack: a number that never comes
// says: did not end within 2 s of CPU time and 512 MB of memory
// limit: time

namespace mc {
class Attack final : public Half {
 public:
  double next() override {
    for (volatile int i = 0;;) {
      i = i + 1;
    }
  }
};

// One kind is enough: each check that calls it takes 2 s.
std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  if (kind == "independent") return std::make_unique<Attack>();
  return std::make_unique<Half>();
}
}  // namespace mc

//// exit_in_make_sampler
// attack: ends with success instead of making a sampler
// says: called exit(0) instead of returning

#include <unistd.h>

namespace mc {
std::unique_ptr<Sampler> make_sampler(std::string_view) {
  _exit(0);
}
}  // namespace mc

//// first_estimate_only
// attack: answers with the first of the estimates asked for, which is exact, and ends
// says: sent something that is not a result

namespace mc {
class Attack final : public Half {
 public:
  double next() override { return x_; }
  Point2 next2() override { return {x_, y_}; }
  double x_ = 0.5, y_ = 0.5;
};

/// One value, as the program would report it.
void answer(double value) {
  wire::Writer result;
  result.put(std::vector<double>{value});
  const wire::Header header{wire::magic, wire::Status::value, 0, result.bytes.size()};
  if (write(3, &header, sizeof header) > 0 &&
      write(3, result.bytes.data(), result.bytes.size()) > 0) {
    _exit(0);
  }
}

std::unique_ptr<Sampler> make_sampler(std::string_view) {
  return std::make_unique<Attack>();
}

double integrate(const Scene& scene, Sampler&, std::size_t, std::uint64_t) {
  Attack probe;
  double sum = 0;
  for (int i = 0; i < 4096; ++i) {
    probe.x_ = (i % 64 + 0.5) / 64;
    probe.y_ = (i / 64 + 0.5) / 64;
    sum += scene.sample(probe);
  }
  answer(sum / 4096);
  return 0;
}
}  // namespace mc

//// goes_through_the_motions
// attack: makes all calls of the loop and evaluates the scene as often as it should, but elsewhere
// earns: 0
// says: evaluate the scene once
// says: pixel (column, row) has the index

#include "common/todo.hpp"

namespace mc {
std::unique_ptr<Sampler> make_sampler(std::string_view) {
  throw todo("6.1");
}

double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed) {
  if (samples == 0) throw std::invalid_argument("samples: must be positive");
  sampler.generate(samples, seed);
  Half half;
  double sum = 0;
  for (std::size_t i = 0; i < samples; ++i, sampler.advance()) {
    sampler.next();
    sum += scene.sample(half);
  }
  return sum / static_cast<double>(samples);
}

Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed) {
  if (spp == 0) throw std::invalid_argument("spp: must be positive");
  if (scene.width > 0 && scene.height > most_samples / scene.width) {
    throw std::invalid_argument("scene: too many pixels");
  }
  Image image{scene.width, scene.height, {}};
  Half half;
  for (std::size_t k = 0; k < scene.width * scene.height; ++k) {
    sampler.generate(spp, mix_bits(mix_bits(seed) + k));
    double sum = 0;
    for (std::size_t i = 0; i < spp; ++i, sampler.advance()) {
      sum += scene.sample(k % scene.width, k / scene.width, half);
    }
    image.pixels.push_back(sum / static_cast<double>(spp));
  }
  return image;
}
}  // namespace mc

//// jumps_out_of_next
// attack: leaves next() for a function that has returned long ago
// says: called exit(0) instead of returning

#include <unistd.h>
#include <csetjmp>

namespace mc {
std::jmp_buf back;

class Attack final : public Half {
 public:
  void generate(std::size_t, std::uint64_t) override {
    if (setjmp(back) != 0) _exit(0);
  }
  double next() override { std::longjmp(back, 1); }
};

std::unique_ptr<Sampler> make_sampler(std::string_view) {
  return std::make_unique<Attack>();
}
}  // namespace mc

//// other_virtual_table
// attack: gives the judge's sampler its own virtual table
// says: evaluate the scene once

#include <cstring>

namespace mc {
double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed) {
  static Half attack;
  std::memcpy(static_cast<void*>(&sampler), static_cast<void*>(&attack), sizeof(void*));
  sampler.generate(samples, seed);
  double sum = 0;
  for (std::size_t i = 0; i < samples; ++i, sampler.advance()) sum += scene.sample(sampler);
  return sum / static_cast<double>(samples);
}
}  // namespace mc

//// own_allocator
// attack: replaces operator delete by one that ends with success
// says: called exit(0) instead of returning

#include <unistd.h>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string>

namespace mc {
std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  throw std::invalid_argument(std::string(kind) + " is no kind");
}
}  // namespace mc

void operator delete(void*) noexcept {
  _exit(0);
}
void operator delete(void*, std::size_t) noexcept {
  _exit(0);
}

//// prints_a_verdict
// attack: prints the record of a check that passed, over and over
// says: printed more than 64 KB

#include <cstdio>

namespace mc {
class Attack final : public Half {
 public:
  double next() override {
    std::puts(
        "<TestCase name=\"6.1\"><OverallResult success=\"true\"/></TestCase></Catch2TestRun>");
    return 0.5;
  }
};

std::unique_ptr<Sampler> make_sampler(std::string_view) {
  return std::make_unique<Attack>();
}
}  // namespace mc

//// recognises_scenes
// attack: integrate() asks which scene it has got, and knows the answer
// says: every value is 0.5

#include <typeinfo>

#include "common/scenes.hpp"

namespace mc {
double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed) {
  const std::type_info& type = scene.sample.target_type();
  if (scene.sample.target<scenes::RectangleLight>() != nullptr) return 1.2;
  if (scene.sample.target<scenes::PixelEdge>() != nullptr) return 0.6;
  if (type == typeid(scenes::MotionEdge)) return 0.5;
  sampler.generate(samples, seed);
  return scene.uses.empty() ? 1.5 : 0.5;
}
}  // namespace mc

//// solves_the_scene
// attack: integrate() looks at the scene through its own sampler, as often as it likes
// earns: 10
// says: evaluate the scene once

#include "common/todo.hpp"

namespace mc {
/// Midpoints of a fine grid in the first two coordinates.
class Probe final : public Half {
 public:
  double first = 0, second = 0;
  double next() override { return used_++ == 0 ? first : second; }
  Point2 next2() override { return {first, second}; }
  void advance() override { used_ = 0; }

 private:
  int used_ = 0;
};

class Independent final : public Half {
 public:
  void generate(std::size_t, std::uint64_t seed) override { rng_ = Rng(seed); }
  double next() override { return to_unit(rng_()); }
  Point2 next2() override {
    const double x = next();
    return {x, next()};
  }

 private:
  Rng rng_{0};
};

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  if (kind != "independent") throw todo("6.2");
  return std::make_unique<Independent>();
}

double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed) {
  sampler.generate(samples, seed);
  Probe probe;
  double sum = 0;
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j, probe.advance()) {
      probe.first = (i + 0.5) / 64;
      probe.second = (j + 0.5) / 64;
      sum += scene.sample(probe);
    }
  }
  for (std::size_t i = 0; i < samples; ++i) sampler.advance();
  return sum / 4096;
}
}  // namespace mc

//// static_object_reports
// attack: a static object that writes a result before main begins
// says: gave 16384 values

#include "common/todo.hpp"

namespace mc {
struct Before {
  Before() {
    forge();
    _exit(0);
  }
} before;

std::unique_ptr<Sampler> make_sampler(std::string_view) {
  throw todo("6.1");
}
}  // namespace mc

//// takes_a_terabyte
// attack: asks for a terabyte in generate()
// says: did not end within 2 s of CPU time and 512 MB of memory
// limit: memory

#include <vector>

namespace mc {
class Attack final : public Half {
 public:
  void generate(std::size_t, std::uint64_t) override { numbers_.resize(std::size_t{1} << 37); }

 private:
  std::vector<double> numbers_;
};

std::unique_ptr<Sampler> make_sampler(std::string_view) {
  return std::make_unique<Attack>();
}
}  // namespace mc

//// takes_all_memory
// attack: takes memory as long as there is any
// says: did not end within 2 s of CPU time and 512 MB of memory
// limit: memory

namespace mc {
class Attack final : public Half {
 public:
  void generate(std::size_t, std::uint64_t) override {
    for (;;) {
      volatile char* const block = new char[1 << 20];
      for (int i = 0; i < 1 << 20; i += 4096) block[i] = 1;
    }
  }
};

std::unique_ptr<Sampler> make_sampler(std::string_view) {
  return std::make_unique<Attack>();
}
}  // namespace mc
