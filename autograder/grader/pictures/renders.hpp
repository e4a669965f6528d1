#pragma once
// Pictures by every kind of sampler and their errors, with equal samples and in equal time:
// measured
// by a hidden case of lab 6's checks, drawn by gnuplot.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "grader/checkout/labs.hpp"
#include "grader/checkout/layout.hpp"
#include "grader/submission/submission.hpp"
#include "protocol/render.hpp"

namespace mc::grader {

inline constexpr std::uint64_t most_spp = 4096;

/// The lab that has pictures: the one with a script that draws them. Throws MachineError.
const Lab& lab_with_pictures(const Layout& layout, const std::vector<Lab>& labs);

/// Its pictures and kinds of samplers, as it says itself. Throws MachineError where it does not.
protocol::RenderList render_list(const Layout& layout, const Lab& lab);

struct RenderOptions {
  std::vector<std::string> pictures, kinds;
  std::string reference;  ///< the kind whose time the others may take
  std::uint64_t spp = 16;
};

/// One picture by one kind of sampler of one submission.
struct RenderResult {
  std::string submission, picture, kind;
  std::string failure = {};              ///< why there is nothing, in one line
  protocol::RenderFigures samples = {};  ///< with as many as were asked for
  protocol::RenderFigures time = {};     ///< with as many as fit into the reference's time
  bool timed = false;                    ///< is there such a time?
};

struct Renders {
  std::vector<RenderResult> table;
  std::vector<std::filesystem::path> sheets;
  std::vector<std::string> remarks;
};

/// Renders everything, and draws two sheets per picture into build/render. Calls `step` before each
/// step with the number of finished steps, the number of all steps, and the name of the next.
Renders draw_renders(
    const Layout& layout, const Lab& lab, const std::vector<Submission>& submissions,
    const RenderOptions& options,
    const std::function<void(std::size_t done, std::size_t all, const std::string& what)>& step);

}  // namespace mc::grader
