// The main function of every program that ./lab runs; they differ in the commands linked in.

#include "commands/command.hpp"
#include "sandbox/descriptor.hpp"

int main(int, char** argv) {
  mc::sandbox::open_standard_streams();
  return mc::grader::run_lab(argv);
}
