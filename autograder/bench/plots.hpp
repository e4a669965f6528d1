#pragma once
// The pictures of the bench.

#include "bench/bench.hpp"
#include "grader/pictures/gnuplot.hpp"

namespace mc::grader {

/// Draws them into `place`.
Plots draw_bench(const Layout& layout, const Bench& bench, const std::filesystem::path& place);

}  // namespace mc::grader
