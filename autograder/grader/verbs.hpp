#pragma once
// What ./lab can do. Each verb takes the words behind its name, writes to standard output and gives
// back its exit status: 0, or 1 where `check` finds points missing. Bad usage and a lacking machine
// are thrown (errors.hpp).

#include <string>
#include <vector>

#include "grader/arguments.hpp"
#include "grader/labs.hpp"
#include "grader/layout.hpp"
#include "grader/submission.hpp"

namespace mc::grader {

/// What every verb knows.
struct House {
  Layout layout;
  std::vector<Lab> labs;
};

struct Verb {
  std::string name;
  std::string usage;                 ///< "check LAB [DIR] [--seed S]"
  std::string description;           ///< one line
  std::vector<std::string> options;  ///< as arguments.hpp has them
  std::string details;               ///< the rest of its --help
  int (*run)(const House& house, const Arguments& arguments);
};

int bench(const House& house, const Arguments& arguments);
int check(const House& house, const Arguments& arguments);
int grade(const House& house, const Arguments& arguments);
int plot(const House& house, const Arguments& arguments);
int render(const House& house, const Arguments& arguments);
int reset(const House& house, const Arguments& arguments);
int run(const House& house, const Arguments& arguments);
int standing(const House& house, const Arguments& arguments);
int submit(const House& house, const Arguments& arguments);
int test(const House& house, const Arguments& arguments);

/// What is drawn side by side: these directories (the starter, where there are none), and the
/// solutions, where the checkout has this lab's.
std::vector<Submission> submissions_beside(const House& house, const Lab& lab,
                                           const std::vector<std::string>& directories);

}  // namespace mc::grader
