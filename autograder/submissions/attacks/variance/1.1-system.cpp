// What it asks of the kernel, and how it ends. Sections: see CONTRIBUTING.md.

//// catches_signal
// attack: computes on after the signal that says its time is over
// says: did not end within 2 s of CPU time and 512 MB of memory
// limit: time

#include <csignal>
#include <ctime>

volatile std::sig_atomic_t over = 0;

static double attack() {
  std::signal(SIGXCPU, [](int) { over = 1; });
  while (!over) {
  }
  for (const auto start = std::clock(); std::clock() - start < CLOCKS_PER_SEC / 2;) {
  }
  return 1.5;
}

//// executes
// attack: becomes another program before main
// says: made a system call a lab never needs

#include <unistd.h>

const int other = [] {
  char* const words[] = {const_cast<char*>("/bin/true"), nullptr};
  return execve(words[0], words, nullptr);
}();

static double attack() {
  return other;
}

//// executes_again
// attack: starts itself again by the descriptor that it was started from
// says: made a system call a lab never needs

#include <sys/syscall.h>
#include <unistd.h>

const long again = [] {
  char* const words[] = {const_cast<char*>("submission"), nullptr};
  return syscall(SYS_execveat, 4, "", words, words + 1, 0x1000);
}();

static double attack() {
  return static_cast<double>(again);
}

//// exit_in_constructor
// attack: ends with success before main
// says: called exit(0) instead of returning

#include <cstdlib>

const int early = (std::exit(0), 0);

static double attack() {
  return 0;
}

//// fork_bomb
// attack: doubles itself without end
// says: made a system call a lab never needs

#include <sys/syscall.h>
#include <unistd.h>

static double attack() {
  for (;;) syscall(SYS_clone, 17, 0, 0, 0, 0);
}

//// memory_bomb
// attack: takes all memory
// says: did not end within 2 s of CPU time and 512 MB of memory
// limit: memory

static double attack() {
  for (;;) {
    volatile char* const block = new char[1 << 20];
    for (int i = 0; i < 1 << 20; i += 4096) block[i] = 1;
  }
}

//// opens_solution
// attack: opens the solution while it runs
// says: made a system call a lab never needs

#include <fstream>

static double attack() {
  std::ifstream solution("/autograder/source/solutions/variance.cpp");
  return solution.get();
}

//// other_abi
// attack: calls the kernel as a 32-bit program does, where 5 means open and not fstat
// says: mean(

#include <sys/syscall.h>
#include <unistd.h>

static double attack() {
#ifdef __x86_64__
  long result = 5;
  asm volatile("int $0x80" : "+a"(result) : "b"("/etc/passwd"), "c"(0) : "memory");
  return static_cast<double>(result);
#else
  return static_cast<double>(syscall(SYS_openat, -100, "/etc/passwd", 0));
#endif
}

//// other_descriptors
// attack: reads whatever else its parent may have left open
// says: made a system call a lab never needs

#include <sys/syscall.h>
#include <unistd.h>

static double attack() {
  double answer = 0;
  for (int descriptor = 4; descriptor < 1000; ++descriptor) {
    syscall(SYS_pread64, descriptor, &answer, sizeof answer, 0);
  }
  return answer;
}

//// stack_overflow
// attack: recursion without an end
// says: crashed: segmentation fault

int down(volatile int* above) {
  volatile int here[1000] = {*above};
  return down(here) + here[1];
}

static double attack() {
  int start = 1;
  return down(&start);
}

//// waits_on_futex
// attack: waits for a wake that never comes, by the call that call_once needs
// says: made a system call a lab never needs

#include <sys/syscall.h>
#include <unistd.h>

static double attack() {
  int word = 0;
  return static_cast<double>(syscall(SYS_futex, &word, 0, 0, nullptr));
}
