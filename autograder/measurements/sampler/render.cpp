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
using protocol::RenderErrors;

std::string request() {
  const char* text = std::getenv(protocol::render_variable);
  if (text == nullptr) throw std::runtime_error("MC_RENDER is not set");
  return text;
}

/// CPU time of one picture with so many samples a pixel, without the program's start: a picture so
/// many times larger both ways that 20 ms pass, less one of a single pixel; of both the least of
/// five, since noise only adds.
double seconds_of(const Wanted& what, Count spp) {
  const auto cpu = [&](std::size_t w, std::size_t h) {
    return MEASURE_WITH(patient, render, what.kind, what.picture, w, h, spp, 1).cpu_seconds;
  };
  const auto scaled = [&](std::size_t scale) {
    return cpu(scale * image_width, scale * image_height);
  };
  std::size_t scale = 1;
  double start = cpu(1, 1), least = scaled(scale);
  while (least < 0.02 && scale < 8) least = scaled(scale *= 2);
  for (int i = 0; i < 4; ++i) {
    start = std::min(start, cpu(1, 1));
    least = std::min(least, scaled(scale));
  }
  return std::max(least - start, 1e-6) / static_cast<double>(scale * scale);
}

/// The most samples a pixel that take no longer than `seconds` (2% are noise), by bisection to
/// within 1/64. One sample is made however long it takes.
RenderErrors samples_in(const Wanted& what, double seconds, RenderErrors one) {
  Count low = 1, high = 16 * what.spp + 1;  // the answer is low, or between them
  RenderErrors best;
  while (true) {
    const bool fits = one.seconds <= 1.02 * seconds;
    (fits ? low : high) = one.spp;
    if (fits) best = one;
    if (high <= low + 1 + high / 64) break;
    one.spp = std::max(low + 1, static_cast<Count>(std::sqrt(static_cast<double>(low * high))));
    one.seconds = seconds_of(what, one.spp);
  }
  if (best.spp == 0) best = {1, seconds_of(what, 1)};
  return best;
}

/// Draws it with as many samples, and fills in its errors.
void draw(const Wanted& what, RenderErrors& one, const Values& exact, const std::string& sheet) {
  const auto got =
      MEASURE_WITH(patient, render, what.kind, what.picture, image_width, image_height, one.spp, 1);
  const RenderErrors errors =
      write_with_error(what.kind + '-' + sheet, got.exactly(exact.size()).pixels, exact);
  one = {one.spp, one.seconds, errors.rmse, errors.large_error};
}

TEST_CASE("list what can be rendered", "[.render-list]") {
  protocol::RenderList list;
  for (const KnownPicture& picture : known_pictures) list.pictures.emplace_back(picture.name);
  list.kinds.assign(sampler_kinds.begin(), sampler_kinds.end());
  std::ofstream(request()) << list;
}

TEST_CASE("render one picture", "[.render]") {
  const Wanted what = protocol::render_request_in(request());
  const Values exact = exact_image(what.picture, image_width, image_height);
  plot_image("exact.tsv", exact, image_width);
  RenderErrors samples{what.spp, seconds_of(what, what.spp)};
  RenderErrors time = what.seconds > 0 ? samples_in(what, what.seconds, samples) : samples;
  draw(what, samples, exact, "samples");
  draw(what, time, exact, "time");
  plot_file(what.kind + ".txt") << samples << time;
}

}  // namespace
}  // namespace mc::measurements
