#pragma once
// The commands, in the order in which ./lab --help lists them. The program `course` has all of
// them, `grader` only those that students need at once.

#include <string_view>

namespace mc::grader {

struct CommandEntry {
  std::string_view name, description;
  bool for_instructors = false;  ///< hidden if there are no solutions: in a handout
  std::string_view about = "";   ///< the path it works on: without that, the command is absent
};

inline constexpr CommandEntry command_list[] = {
    {"", "where you stand: labs, points, what to do next"},
    {"setup", "install what is missing and build everything"},
    {"check", "judge one lab of starter/ (or DIR)"},
    {"run", "run one experiment by hand and print its numbers"},
    {"hint", "a step towards a task that you are stuck in"},
    {"plot", "draw the lab's plots, several submissions side by side"},
    {"render", "draw lab 6's pictures by every sampler, and their errors", false, "labs/6-sampler"},
    {"demo", "a page with an interactive figure per lab, fed with your own points", false,
     "autograder/grader/pictures/demo.html"},
    {"report", "your work on a lab as a page"},
    {"reset", "the starter of a lab again (your file is kept as a backup)"},
    {"submit", "write the zip to hand in"},
    {"update", "get the course's latest version", false, "autograder/handout.txt"},
    {"completion", "a script for your shell that completes commands on TAB"},
    {"grade", "judge whole submissions", true},
    {"merge", "make one table of the tables of several shards", true},
    {"stats", "what a table of grades says of the class and of the checks", true},
    {"feedback", "a page and a text for each student, and tables to upload", true},
    {"export", "lay a class's files out for JPlag, which finds similar ones", true},
    {"handout", "write the repository that students get", true, "docs/handout"},
    {"release", "add a lab's solution and answers to a handout", true, "docs/answers"},
    {"gradescope", "write the zip that Gradescope's autograder is made of", true,
     "autograder/gradescope"},
    {"bench", "speed against error: the solutions, any submission, libraries", true,
     "autograder/bench"},
    {"new-lab", "write the skeleton of a lab, which works", true, "autograder/new-lab.txt"},
    {"test", "the repository's own tests", true, "autograder/tests"},
};

}  // namespace mc::grader
