#pragma once
// If a call of an experiment is hard to read, its lab defines how a report prints it: in terms of
// what the student wrote. Argument-dependent lookup finds these functions in mc::experiments:
//
//   std::string spelled(const Function&)                       an argument: "2 * exp(x) + 1"
//   std::string spelled_call(Spelling, name, arguments...)     a whole call

namespace mc::experiments {
struct Spelling {};
}  // namespace mc::experiments
