#include <fmt/format.h>

#include "grader/bench.hpp"

namespace mc::grader {
std::string bench_page(const Bench&, const std::string&) { return ""; }
std::string bench_summary(const Bench&) { return ""; }
}
