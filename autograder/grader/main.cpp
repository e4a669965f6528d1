// ./lab, behind its door: finds the verb, runs it, and turns errors into a line and a status.

#include <cstdio>
#include <exception>
#include <system_error>

#include <fmt/format.h>

#include "grader/errors.hpp"
#include "grader/verbs.hpp"

namespace mc::grader {
namespace {

const std::vector<Verb>& verbs() {
  static const std::vector<Verb> all{
      {"", "", "where you stand: labs, points, what to do next", {}, "", standing},
      {"setup",
       "setup",
       "install what is missing and build everything",
       {},
       "With apt, dnf or brew; it says what it runs. At a terminal it asks first, without one or "
       "with\n"
       "CI=true it does not. Where nothing is missing, nothing is touched.\n",
       nullptr},
      {"check",
       "check LAB [DIR] [--only TASK] [--seed S] [--json FILE]",
       "judge one lab of starter/ (or DIR)",
       {"only=", "seed=", "json="},
       "LAB is a number, a name or a folder: 1, variance, 1-variance.\n"
       "  --only TASK   the checks of one task: --only 1.3\n"
       "  --seed S      the run with that seed again; every report names its own\n"
       "  --json FILE   Gradescope's results.json as well\n"
       "Exit status: 0 all points, 1 points are missing, 2 bad usage, 3 the machine lacks "
       "something.\n",
       check},
      {"run",
       "run LAB [--dir DIR] [EXPERIMENT ARGUMENT...]",
       "run one experiment by hand and print its numbers",
       {"dir="},
       "Without EXPERIMENT: the experiments of the lab. Numbers are written 0.5, lists 1,2,4, "
       "structs\n"
       "3:0.5:2. Nothing is jailed here: it is your own program, on your own machine.\n"
       "  ./lab run variance mean 1,2,4\n",
       run},
      {"grade",
       "grade DIR... [--json FILE] [--csv FILE] [--seed S] [-j N] [--no-plots]",
       "judge whole submissions",
       {"json=", "csv=", "seed=", "jobs=j", "no-plots"},
       "Every lab that DIR has a file of. One DIR is reported check by check and its plots are "
       "drawn;\n"
       "of several, a line each.\n"
       "  --json FILE   Gradescope's results.json (one DIR)\n"
       "  --csv FILE    a row for each DIR\n"
       "  --seed S      the same seed again\n"
       "  -j N          so many checks at the same time (2)\n"
       "  --no-plots    no plots\n",
       grade},
      {"plot",
       "plot LAB [DIR...]",
       "draw the lab's plots, several submissions side by side",
       {},
       "starter/ without DIR; beside it the solutions, where the checkout has them.\n",
       plot},
      {"render",
       "render [PICTURE] [--sampler KIND] [--spp N] [DIR...]",
       "draw lab 6's pictures by every sampler, and their errors",
       {"sampler=", "spp="},
       "PICTURE is edge, penumbra, defocus, motion or stripes; all of them without it. Two sheets "
       "each,\n"
       "in build/render: with N samples a pixel (16), and with as many as a sampler makes in the "
       "time of N\n"
       "independent ones. DIR as in plot.\n"
       "  --sampler KIND   only one of independent, stratified, blue_noise, halton, sobol\n",
       render},
      {"bench",
       "bench [LAB...] [DIR...] [--rounds N] [--page FILE]",
       "speed against error: the solutions, any submission, libraries",
       {"rounds=", "page="},
       "Every lab, unless some are named; the solutions and the libraries that are installed, and "
       "each\n"
       "DIR. Minutes, on an idle machine; what it has is kept if it is interrupted. Numbers and "
       "pictures\n"
       "go to build/bench/.\n"
       "  --rounds N    time everything so often, in turn (5)\n"
       "  --page FILE   write the page as well: docs/speed-against-error.md\n",
       bench},
      {"reset",
       "reset LAB",
       "the starter of a lab again (your file is kept as a backup)",
       {},
       "The newest version in git's history in which no task was begun.\n",
       reset},
      {"submit",
       "submit LAB",
       "write the zip to hand in",
       {},
       "submission.zip, here: your file of that lab and of the labs it stands on.\n",
       submit},
      {"test",
       "test [--full]",
       "the repository's own tests",
       {"full"},
       "Every submission of the repository is judged: the starter, the solutions, the mistakes, "
       "the\n"
       "alternatives, the attacks. With --full, right ones with 1,000 seeds: hours, but it goes on "
       "where\n"
       "it was interrupted.\n",
       test},
  };
  return all;
}

void print_overview() {
  fmt::print("usage: ./lab VERB ...   (./lab VERB --help says more)\n\n");
  for (const Verb& verb : verbs()) {
    fmt::print("  ./lab {:<10} {}\n", verb.name, verb.description);
  }
}

const Verb& find_verb(const std::string& name) {
  std::vector<std::string> names;
  for (const Verb& verb : verbs()) {
    if (verb.name == name) return verb;
    if (!verb.name.empty()) names.push_back(verb.name);
  }
  throw UsageError(fmt::format("no verb '{}'; did you mean '{}'? ./lab --help lists them", name,
                               nearest(name, names)));
}

int dispatch(const std::vector<std::string>& words) {
  if (!words.empty() && (words[0] == "--help" || words[0] == "-h" || words[0] == "help")) {
    print_overview();
    return 0;
  }
  const Verb& verb = find_verb(words.empty() ? "" : words[0]);
  const std::vector<std::string> rest(words.begin() + (words.empty() ? 0 : 1), words.end());
  if (!rest.empty() && (rest[0] == "--help" || rest[0] == "-h")) {
    fmt::print("usage: ./lab {}\n\n{}.\n{}", verb.usage, verb.description, verb.details);
    return 0;
  }
  const Arguments arguments = parse_arguments(rest, verb.options, verb.name == "run");
  if (verb.run == nullptr) {
    if (!rest.empty()) throw UsageError(fmt::format("usage: ./lab {}", verb.usage));
    fmt::print("Everything is here and built.\n");
    return 0;
  }
  House house{read_layout(), {}};
  house.labs = find_labs(house.layout);
  return verb.run(house, arguments);
}

}  // namespace
}  // namespace mc::grader

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  try {
    return mc::grader::dispatch({argv + 1, argv + argc});
  } catch (const mc::grader::UsageError& error) {
    fmt::print(stderr, "lab: {}\n", error.what());
    return 2;
  } catch (const mc::grader::MachineError& error) {
    fmt::print(stderr, "lab: {}\n", error.what());
    return 3;
  } catch (const std::exception& error) {  // a full disk, no right to write, no more processes
    fmt::print(stderr, "lab: {}\n", error.what());
    return 3;
  }
}
