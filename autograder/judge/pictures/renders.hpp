#pragma once
// Pictures by every kind of sampler and their errors, with equal samples and in equal time. A
// hidden case of lab 6's checks measures them, gnuplot draws them.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "judge/checkout/labs.hpp"
#include "judge/checkout/layout.hpp"
#include "judge/submission/submission.hpp"
#include "protocol/render.hpp"

namespace mc::grader {

inline constexpr std::uint64_t most_spp = 4096;

/// The lab with pictures: the one that has a script to draw them. Throws MachineError.
const Lab& lab_with_pictures(const Layout& layout, const std::vector<Lab>& labs);

/// Its pictures and kinds of samplers, as its program lists them. Throws MachineError if it fails.
protocol::RenderList render_list(const Layout& layout, const Lab& lab);

struct RenderOptions {
  std::vector<std::string> pictures, kinds;
  std::string reference;  ///< the kind whose time limits the others
  std::uint64_t spp = 16;
};

/// One picture by one kind of sampler of one submission.
struct RenderResult {
  std::string submission, picture, kind;
  std::string failure = {};             ///< why there is no picture, in one line
  protocol::RenderErrors samples = {};  ///< with the requested number of samples
  protocol::RenderErrors time = {};     ///< with as many as fit into the reference's time
  bool timed = false;                   ///< is `time` valid?
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
