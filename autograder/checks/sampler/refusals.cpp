// What the functions of lab 6 refuse, one table per task: the "throws:" lines of the header.

#include "checks/sampler/samplers.hpp"

namespace mc::checks {
namespace {

std::vector<InvalidCall> unknown_kinds() {
  std::vector<InvalidCall> calls;
  const std::string longer("sobol\0x", 7);  // a string_view may contain a 0
  for (const std::string& kind :
       {std::string("random"), std::string(), std::string("Sobol"), std::string("sobol "),
        std::string("sobo"), std::string("blue noise"), longer}) {
    calls.push_back({MEASURE_OUTCOME(columns, kind, 2, {1}, {1}), "kind",
                     kind == longer
                         ? "the kind is all characters of the string_view, which need not "
                           "end in a 0"
                         : "there is no such kind of sampler"});
  }
  return calls;
}

CHECK_CASE("6.1 unknown kinds are refused", "[6.1][edge][points:1]") {
  expect_refused(unknown_kinds());
}

CHECK_CASE("6.1 the refusal names all kinds", "[6.1][edge][points:1]") {
  expect_argument_named(unknown_kinds());
  const Call refused = MEASURE_OUTCOME(columns, "random", 2, {1}, {1});
  for (const std::string& known : sampler_kinds) {
    expect_that(refused.outcome.bytes.find(known) != std::string::npos,
                fmt::format("{}: threw \"{}\"", refused.text, refused.outcome.bytes),
                fmt::format("a message that also names the kind {}", known),
                "a list of all kinds helps a user who mistypes one", "");
  }
}

std::vector<InvalidCall> impossible() {
  std::vector<InvalidCall> calls;
  for (const std::string& kind : sampler_kinds) {
    for (const std::uint64_t samples : {std::uint64_t{0}, std::uint64_t{most_samples} + 1,
                                        std::uint64_t{1} << 32, ~std::uint64_t{0}}) {
      calls.push_back({MEASURE_OUTCOME(columns, kind, samples, {1}, {}), "samples",
                       "there must be at least one sample, and at most most_samples"});
    }
  }
  return calls;
}

REFUSAL_CASES("6.4", "0 samples and too many are refused", "0.5", "a refusal names the argument",
              "0.5", impossible())

CHECK_CASE("6.5 0 samples are refused", "[6.5][edge][points:1]") {
  expect_refused_by_name({{MEASURE_OUTCOME(integrate_keyed, 1, 1, 2, 0, 1), "samples",
                           "there is no mean of 0 samples"}});
}

/// Pixels without samples; more pixels than most_samples, even if the product overflows.
std::vector<InvalidCall> impossible_pictures() {
  const std::string pixels = "more pixels than most_samples, even if width * height overflows";
  std::vector<InvalidCall> calls{
      {MEASURE_OUTCOME(render_keyed, 1, 2, 2, 0, 1), "spp", "a pixel is a mean of samples"},
      {MEASURE_OUTCOME(render_keyed, 1, 0, 0, 0, 1), "spp",
       "spp must not be 0, even without pixels"}};
  const std::uint64_t side = std::uint64_t{1} << 32;
  for (const auto& [width, height] : {std::pair{side >> 18, side >> 18},
                                      {side >> 5, std::uint64_t{2}},
                                      {std::uint64_t{2}, (side >> 6) + 1},
                                      {side, side},
                                      {2 * side, side / 2 + 1}}) {
    calls.push_back({MEASURE_OUTCOME(render_keyed, 1, width, height, 1, 1), "scene", pixels});
  }
  return calls;
}

REFUSAL_CASES("6.6", "impossible pictures are refused", "0.5", "a refusal names the argument", "1",
              impossible_pictures())

}  // namespace
}  // namespace mc::checks
