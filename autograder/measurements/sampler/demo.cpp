// Lab 6 in the demo: a picture by each kind of sampler.

#include <algorithm>
#include <string>

#include "checks/support/catch.hpp"
#include "measurements/sampler/methods.hpp"
#include "measurements/sampler/pictures.hpp"
#include "measurements/support/demo.hpp"

namespace mc::measurements {
namespace {

TEST_CASE("demo", "[.demo]") {
  begin_demo();
  constexpr std::size_t width = 96, height = 72;
  const Values exact = exact_image("penumbra", width, height);
  // White is a third above the brightest pixel; what noise makes brighter than that is cut off.
  const double white = 4. / 3 * *std::max_element(exact.begin(), exact.end());
  const auto text_of = [&](Values pixels) {
    for (double& pixel : pixels) pixel /= white;
    return encoded(pixels, 2);
  };
  for (std::size_t k = 0; k < methods.size(); ++k) {
    Values sizes;
    std::vector<std::string> images;
    for (std::uint64_t spp = 1; spp <= 64; spp *= 4) {
      const auto image =
          lists_of(TRY_MEASURE_WITH(large, render, kinds[k], "penumbra", width, height, spp, 1),
                   exact.size());
      if (!image) break;
      sizes.push_back(static_cast<double>(spp));
      images.push_back(text_of(image->pixels));
    }
    if (images.empty()) continue;
    write_demo(6, std::to_string(k),
               {{"name", methods[k].name},
                {"width", static_cast<double>(width)},
                {"sizes", sizes},
                {"images", images},
                {"exact", text_of(exact)}});
  }
}

}  // namespace
}  // namespace mc::measurements
