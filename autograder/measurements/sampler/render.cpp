// The data of ./lab render: which pictures and kinds of samplers there are; and one picture by one
// kind, with a given number of samples per pixel and with as many as it makes in a given time.
// MC_RENDER has the request (protocol/render.hpp); with 0 seconds the time is this kind's own.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "6-sampler/experiments.hpp"
#include "checks/sampler/samplers.hpp"
#include "checks/support/catch.hpp"
#include "measurements/sampler/pictures.hpp"
#include "measurements/support/plot_data.hpp"
#include "protocol/environment.hpp"
#include "protocol/render.hpp"

namespace mc::measurements {
namespace {

// Of a picture by hand: the slowest sampler may take its time.
constexpr sandbox::Limits patient{.cpu_seconds = 20, .wall_seconds = 60};

using Wanted = protocol::RenderRequest;
Wanted wanted() {
  const char* text = std::getenv(protocol::render_variable);
  if (text == nullptr) throw std::runtime_error("MC_RENDER is not set");
  return protocol::render_request_in(text);
}

/// CPU time of one picture with so many samples a pixel, without the program's start: a picture so
/// many times larger both ways that 20 ms pass, less one of a single pixel; of both the least of
/// five, since noise only adds.
double seconds_of(const Wanted& what, std::uint64_t spp) {
  const auto cpu = [&](std::size_t w, std::size_t h) {
    return MEASURE_WITH(patient, render, what.kind, what.picture, w, h, spp, 1).cpu_seconds;
  };
  double start = cpu(1, 1);
  std::size_t scale = 1;
  double least = cpu(image_width, image_height);
  while (least < 0.02 && scale < 8) {
    scale *= 2;
    least = cpu(scale * image_width, scale * image_height);
  }
  for (int i = 0; i < 4; ++i) {
    start = std::min(start, cpu(1, 1));
    least = std::min(least, cpu(scale * image_width, scale * image_height));
  }
  return std::max(least - start, 1e-6) / static_cast<double>(scale * scale);
}

struct Timed {
  std::uint64_t spp = 0;
  double seconds = 0;
};

/// The most samples a pixel that take no longer than `seconds` (2% are noise): from one timing, by
/// proportion; then by the slope between the last two, in a plot with logarithmic axes. One sample
/// is made however long it takes.
Timed samples_in(const Wanted& what, double seconds, Timed one) {
  const auto fits = [&](Timed timed) { return timed.seconds <= 1.02 * seconds; };
  std::uint64_t low = 1, high = 16 * what.spp + 1;  // the answer is low, or between them
  double slope = 1;
  Timed best;
  for (int timings = 0;; ++timings) {
    (fits(one) ? low : high) = one.spp;
    if (fits(one)) best = one;
    if (high <= low + 1 + high / 64 || timings == 6) break;
    const double guess =
        static_cast<double>(one.spp) * std::pow(seconds / one.seconds, 1 / slope) + 0.1;
    const auto least = static_cast<double>(best.spp == low ? low + 1 : low);
    const auto inside = std::clamp(guess, least, static_cast<double>(high - 1));
    const auto spp = static_cast<std::uint64_t>(inside);
    const Timed next{spp, seconds_of(what, spp)};
    const double ratio = static_cast<double>(spp) / static_cast<double>(one.spp);
    if (ratio != 1)
      slope = std::clamp(std::log(next.seconds / one.seconds) / std::log(ratio), 0.5, 2.);
    one = next;
  }
  if (best.spp == 0) best = {1, seconds_of(what, 1)};
  return best;
}

Errors draw_one(const Wanted& what, std::uint64_t spp, const std::vector<double>& exact,
                const std::string& sheet) {
  const auto got =
      MEASURE_WITH(patient, render, what.kind, what.picture, image_width, image_height, spp, 1);
  return write_with_error(what.kind + '-' + sheet, got.exactly(exact.size()), exact);
}

TEST_CASE("list what can be rendered", "[.render-list]") {
  const char* file = std::getenv(protocol::render_variable);
  if (file == nullptr) throw std::runtime_error("MC_RENDER is not set");
  protocol::RenderList list;
  for (const KnownPicture& picture : known_pictures) list.pictures.emplace_back(picture.name);
  list.kinds.assign(sampler_kinds.begin(), sampler_kinds.end());
  std::ofstream(file) << list;
}

TEST_CASE("render one picture", "[.render]") {
  const Wanted what = wanted();
  const std::vector<double> exact = exact_image(what.picture, image_width, image_height);
  write_image("exact.tsv", exact);
  const Errors samples = draw_one(what, what.spp, exact, "samples");
  const Timed own{what.spp, seconds_of(what, what.spp)};
  const Timed timed = what.seconds > 0 ? samples_in(what, what.seconds, own) : own;
  const Errors time = draw_one(what, timed.spp, exact, "time");
  auto result = plot_file(what.kind + ".txt");
  for (const auto& [sheet, errors] : {std::pair(own, samples), std::pair(timed, time)}) {
    result << protocol::RenderErrors{sheet.spp, sheet.seconds, errors.rmse, errors.large};
  }
}

}  // namespace
}  // namespace mc::measurements
