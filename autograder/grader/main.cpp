// Each of the programs behind ./lab: they differ in the verbs that are linked into them.

#include "grader/verbs/dispatch.hpp"

int main(int, char** argv) {
  return mc::grader::run_lab(argv);
}
