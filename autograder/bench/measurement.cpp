// The cost of one measurement: fork, jail, exec, result. Prints the median of 501 for a program.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "runner/wire.hpp"
#include "sandbox/jail.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::printf(
        "usage: bench_measurement PROGRAM (a program of lab 1, build/programs/*/*.program)\n");
    return 2;
  }
  const auto program = mc::sandbox::open_program(argv[1]);
  mc::wire::Writer request;
  request.put(std::string("mean"));
  request.put(std::vector<double>{1, 2, 6});
  std::vector<double> milliseconds;
  for (int i = 0; i < 501; ++i) {
    const auto start = std::chrono::steady_clock::now();
    if (!mc::sandbox::run_jailed(program, request.bytes).answered) return 1;
    milliseconds.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
            .count());
  }
  std::sort(milliseconds.begin(), milliseconds.end());
  std::printf("  one measurement: median %.2f ms, 90 %% below %.2f ms\n", milliseconds[250],
              milliseconds[450]);
}
