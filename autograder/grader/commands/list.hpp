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
    {"", "show your labs, your points and what to do next"},
    {"setup", "install what is missing and build everything"},
    {"check", "check one lab in starter/ (or DIR)"},
    {"run", "run one experiment by hand and print its numbers"},
    {"hint", "show a hint for a task"},
    {"plot", "draw the lab's plots, several submissions side by side"},
    {"render", "draw lab 6's pictures by every sampler, and their errors", false, "labs/6-sampler"},
    {"demo", "make a page with an interactive figure for each lab, from your own points", false,
     "autograder/grader/pictures/demo.html"},
    {"report", "make a page of your work on a lab"},
    {"reset", "restore the starter of a lab (your file is backed up)"},
    {"submit", "write the zip file to hand in"},
    {"update", "get the latest version of the course", false, "autograder/handout.txt"},
    {"completion", "print a script that completes commands in your shell"},
    {"grade", "grade whole submissions", true},
    {"merge", "merge the grade tables of several shards", true},
    {"stats", "show statistics of the class and the checks", true},
    {"feedback", "write a page and a text for each student, and tables to upload", true},
    {"export", "copy a class's files into the layout that JPlag reads", true},
    {"handout", "write the repository for students", true, "docs/handout"},
    {"release", "add a lab's solution and answers to a handout", true, "docs/answers"},
    {"gradescope", "write the zip file for Gradescope's autograder", true, "autograder/gradescope"},
    {"bench", "measure speed against error: solutions, submissions, libraries", true,
     "autograder/bench"},
    {"new-lab", "write the skeleton of a new lab", true, "autograder/new-lab.txt"},
    {"test", "run the repository's own tests", true, "autograder/tests"},
};

}  // namespace mc::grader
