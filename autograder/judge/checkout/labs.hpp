#pragma once
// The labs: found as folders labs/N-name. What all parts of the grader share is a Context.

#include <string>
#include <vector>

#include "judge/checkout/layout.hpp"

namespace mc::grader {

struct Lab {
  int number = 0;
  std::string name;                     ///< "blue_noise": of its header, its .cpp, its checks
  std::string folder;                   ///< "4-blue-noise"
  std::vector<std::string> depends_on;  ///< names of the labs whose files its program links too

  std::string file() const { return name + ".cpp"; }
  std::string header() const { return name + ".hpp"; }
  std::string title() const;  ///< "Lab 4 · blue noise"
};

/// All labs, by number. A lab depends on those whose headers its header includes, transitively.
std::vector<Lab> find_labs(const Layout& layout);

struct Context {
  Layout layout;
  std::vector<Lab> labs;
};

struct Experiment {
  std::string name;
  std::vector<std::string> parameters;  ///< their names, in order
};

/// What a lab's experiments.cpp lists for ./lab run, in its order; empty if the lab has none.
std::vector<Experiment> experiments_of(const Layout& layout, const Lab& lab);

/// By number, name or folder. Throws UsageError with the nearest name where there is none.
const Lab& find_lab(const std::vector<Lab>& labs, const std::string& text);

/// The one of `choices` that is nearest to `text` in edits, for "did you mean".
std::string nearest(const std::string& text, const std::vector<std::string>& choices);

}  // namespace mc::grader
