#pragma once
// The solution with its sampler laid open: a mistake derives from it and does one thing wrong.

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "sampler.hpp"

#define make_sampler right_make_sampler
#define final
#define private protected
#include "solutions/sampler.cpp"
#undef private
#undef final
#undef make_sampler

namespace mc {
namespace {

/// A Wrong sampler, which derives from ColumnSampler, of one of the kinds of the solution.
template <class Wrong>
std::unique_ptr<Sampler> make_spoiled(std::string_view kind) {
  for (const Kind& known : kinds) {
    if (known.name == kind) return std::make_unique<Wrong>(known);
  }
  return right_make_sampler(kind);
}

/// The solution's sampler, but one kind of it fills columns by other functions.
template <auto one, auto two>
std::unique_ptr<Sampler> make_other_kind(std::string_view other, std::string_view kind) {
  static const Kind wrong{other, one, two};
  if (kind == other) return std::make_unique<ColumnSampler>(wrong);
  return right_make_sampler(kind);
}

}  // namespace
}  // namespace mc
