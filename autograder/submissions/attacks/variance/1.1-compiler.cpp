// What is read, run or made while it is compiled and linked. Sections: see CONTRIBUTING.md.

//// assembler_include
// attack: has the assembler quote /etc/passwd in its errors
// says: The assembler rejects an asm statement
// never says: /nologin

asm(".include \"/etc/passwd\"");

static double attack() {
  return 0;
}

//// endless_constexpr
// attack: a compile-time loop without an end
// says: does not compile

constexpr int endless() {
  for (int i = 0;; i ^= 1) {
  }
}
constexpr int never = endless();

static double attack() {
  return never;
}

//// fault_of_machine
// attack: says in a message of the compiler that the machine killed it
// says: variance.cpp does not compile

static_assert(false, "\ng++: fatal error: Killed signal terminated program cc1plus");

//// incbin_solution
// attack: takes the solution in as data
// says: The assembler rejects an asm statement

#include <stdexcept>

asm(".data\nstolen: .incbin \"common/../../solutions/variance.cpp\"\n.byte 0\n.text");
extern const char stolen[];

static double attack() {
  throw std::runtime_error(stolen);
}

//// include_proc
// attack: reads a file by a name that means something else to every process
// says: /proc/self/environ: Permission denied
// never says: PATH=

#include "/proc/self/environ"

static double attack() {
  return 0;
}

//// include_solution
// attack: includes the solution, by a path from a directory of headers
// says: solutions/variance.cpp: Permission denied
// says: It may include its lab

#include "common/../../solutions/variance.cpp"

//// interpreter
// attack: names another program as its loader: the kernel opens that one by itself
// says: names its own loader

asm(".section .interp, \"a\"\n.asciz \"/bin/true\"\n.previous");

static double attack() {
  return 0;
}

//// large_template
// attack: a template with more arguments than fit in memory
// says: memory

#include <utility>

template <std::size_t... i>
constexpr double last(std::index_sequence<i...>) {
  return (0. + ... + i);
}

static double attack() {
  return last(std::make_index_sequence<200000000>());
}

//// large_zeros
// attack: a gigabyte of global zeros
// says: The global variables of variance.cpp take

char block[1u << 30];

static double attack() {
  return block[7] = 1;
}

//// link_time
// attack: looks like link-time optimization, for which a linker starts its own compiler
// says: mean({
// never says: linker

asm(".section .gnu.lto_.symtab.1, \"e\"\n.zero 64\n"
    ".section .gnu.lto_.opts, \"e\"\n.asciz \"'-fplugin=/etc/passwd'\"\n"
    ".section .gnu.lto_main.1, \"e\"\n.zero 64\n.previous");

static double attack() {
  return 1;
}

//// lines_of_others
// attack: names its places so that messages begin like a command to GitHub, or a line of a report
// says: | ::notice file=a
// says: | passed ##?error]
// never says: ##[

#line 1 "::notice file=a"
static_assert(false, "1.1");
#line 1 "passed ##[error]"
static_assert(false, "1.1");

//// own_library
// attack: brings its own write, in place of the C library's
// says: called exit(0) instead of returning

#include <unistd.h>

extern "C" ssize_t write(int, const void*, size_t size) {
  return static_cast<ssize_t>(size);
}

static double attack() {
  return 0;
}

//// own_main
// attack: brings its own main
// says: defines `main`, but the labs have their own

int main() {}

static double attack() {
  return 0;
}
