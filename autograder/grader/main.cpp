// Each of the programs behind ./lab: they differ in the commands that are linked into them.

#include "grader/commands/dispatch.hpp"

int main(int, char** argv) {
  return mc::grader::run_lab(argv);
}
