#pragma once
// The verbs there are, in the order in which ./lab --help lists them, and the program that each is
// part of: a check should not wait until what draws pictures is compiled.

#include <string_view>

namespace mc::grader {

struct VerbEntry {
  std::string_view name, description, program;
  bool for_instructors = false;  ///< not listed where there are no solutions: in a handout
  std::string_view about = "";   ///< what it is about: without that it is not there at all
};

/// Has all the grader has, and writes JSON.
inline constexpr std::string_view gradebook = "gradebook";

inline constexpr VerbEntry verb_list[] = {
    {"", "where you stand: labs, points, what to do next", "grader"},
    {"setup", "install what is missing and build everything", "desk"},
    {"check", "judge one lab of starter/ (or DIR)", "grader"},
    {"run", "run one experiment by hand and print its numbers", "desk"},
    {"plot", "draw the lab's plots, several submissions side by side", "pictures"},
    {"render", "draw lab 6's pictures by every sampler, and their errors", "pictures", false,
     "labs/6-sampler"},
    {"demo", "points, an estimate and its error as N grows: the lecture's page", "pictures", true},
    {"report", "your work on a lab as a page", "pictures"},
    {"reset", "the starter of a lab again (your file is kept as a backup)", "desk"},
    {"submit", "write the zip to hand in", "desk"},
    {"grade", "judge whole submissions", gradebook, true},
    {"merge", "make one table of the tables of several shards", gradebook, true},
    {"stats", "what a table of grades says of the class and of the checks", gradebook, true},
    {"export", "lay a class's files out for JPlag, which finds similar ones", gradebook, true},
    {"handout", "write the repository that students get", gradebook, true, "docs/handout"},
    {"gradescope", "write the zip that Gradescope's autograder is made of", gradebook, true,
     "autograder/gradescope"},
    {"bench", "speed against error: the solutions, any submission, libraries", "bench", true,
     "autograder/bench"},
    {"test", "the repository's own tests", "desk", true, "autograder/tests"},
};

}  // namespace mc::grader
