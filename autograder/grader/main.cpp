// The main function of every program that ./lab runs; they differ in the commands linked in.

#include "grader/commands/command.hpp"

int main(int, char** argv) {
  return mc::grader::run_lab(argv);
}
