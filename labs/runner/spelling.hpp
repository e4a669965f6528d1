#pragma once
// Where a call of an experiment reads badly, its lab says how a report spells it: in the terms of
// what the student wrote. Found by argument-dependent lookup in mc::experiments, if there:
//
//   std::string spelled(const Function&)                       of an argument: "2 * exp(x) + 1"
//   std::string spelled_call(Spelling, name, arguments...)     of a whole call

#include <cstddef>
#include <string>
#include <vector>

namespace mc::experiments {
struct Spelling {};
}  // namespace mc::experiments

namespace mc::text {

/// Items, separated so; of many the first `most`, and how many more there are.
inline std::string joined(const std::vector<std::string>& items, const std::string& separator,
                          std::size_t most, const std::string& what) {
  if (items.size() == most + 1) ++most;  // "1 more" is as long
  std::string all;
  for (std::size_t i = 0; i < items.size() && i < most; ++i) {
    all += (i > 0 ? separator : "") + items[i];
  }
  if (items.size() <= most) return all;
  return all + separator + "… " + std::to_string(items.size() - most) + " more " + what;
}

}  // namespace mc::text
