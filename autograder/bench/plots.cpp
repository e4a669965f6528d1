#include <fmt/format.h>

#include "bench/bench.hpp"
#include "judge/base/text_file.hpp"
#include "measurements/support/markdown.hpp"

namespace mc::grader {
namespace fs = std::filesystem;

Plots draw_bench(const Layout& layout, const Bench& bench, const fs::path& place) {
  Plots plots;
  if (!can_draw(plots)) return plots;
  // Blocks that gnuplot finds by their names: n, microseconds, RMSE.
  std::string data;
  std::vector<std::string> libraries, what;  // "jittered, std", and which method that is
  for (const Curve& curve : curves_of(bench.rows)) {
    const auto comma = curve.method.rfind(", ");
    if (curve.integrand == "smooth 2D" && comma != std::string::npos &&
        layout.peers.contains(curve.method.substr(comma + 2))) {
      libraries.push_back(curve.method);
      what.push_back(curve.method.substr(0, comma));
    }
    data += fmt::format("# {}|{}\n", curve.method, curve.integrand);
    for (const auto& point : curve.points) {
      data += fmt::format("{}\t{}\t{}\n", point.n, 1e6 * point.seconds(), point.rmse);
    }
    data += "\n\n";
  }
  write_text(place / "curves.tsv", data);
  const fs::path drawing = layout.root / "autograder" / "bench" / "plots.gp";
  const std::string failure =
      run_gnuplot(place / "plots.gp",
                  script_beginning(layout, place / "bench", "svg") +
                      fmt::format("data = {}\n{}{}load {}\n", gnuplot_string(place.string()),
                                  gnuplot_array("peer", libraries), gnuplot_array("peerwhat", what),
                                  gnuplot_string(drawing.string())));
  if (!failure.empty()) plots.remarks.push_back(failure);
  collect(plots, place, "bench-");
  return plots;
}

}  // namespace mc::grader
