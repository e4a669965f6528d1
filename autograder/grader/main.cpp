// The main function of every program that ./lab runs; they differ in the commands linked in.

#include "grader/commands/dispatch.hpp"

int main(int, char** argv) {
  return mc::grader::run_lab(argv);
}
