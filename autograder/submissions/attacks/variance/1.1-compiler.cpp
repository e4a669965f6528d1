// What is read, run or made while it is compiled and linked. Sections: see CONTRIBUTING.md.

//// assembler_include
// attack: has the assembler quote /etc/passwd in its errors
// says: The assembler rejects an asm statement
// never says: /nologin

asm(".include \"/etc/passwd\"");

static double attack() {
  return 0;
}

//// compiler_options
// attack: gives the compiler its own options
// says: mean({

#pragma GCC optimize("-fplugin=/etc/passwd", "-fprofile-use=/etc/passwd", "-fdump-tree-all=/tmp/x")
#include <vector>
#pragma GCC poison exit list

static double attack() {
  return 1;
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

//// endless_template
// attack: a template without an end
// says: depth

template <int n>
struct Down {
  static constexpr int value = Down<n + 1>::value;
};

static double attack() {
  return Down<0>::value;
}

//// incbin_passwd
// attack: includes a file as data, unseen by the preprocessor
// says: variance.cpp reads /etc/passwd.
// never says: root:

#include <stdexcept>

asm(".data\nstolen: .incbin \"/etc/passwd\"\n.byte 0\n.text");
extern const char stolen[];

static double attack() {
  throw std::runtime_error(stolen);
}

//// incbin_solution
// attack: takes the solution in as data
// says: variance.cpp reads
// says: /solutions/variance.cpp

#include <stdexcept>

asm(".data\nstolen: .incbin \"common/../../solutions/variance.cpp\"\n.byte 0\n.text");
extern const char stolen[];

static double attack() {
  throw std::runtime_error(stolen);
}

//// include_detour
// attack: leaves a directory of the system by ..
// says: etc/passwd
// says: which is not a header of a lab
// never says: root:

#include <linux/../../../etc/passwd>

static double attack() {
  return 0;
}

//// include_guess
// attack: looks for the solution by __has_include, in case it is somewhere else
// says: solutions/variance.cpp
// says: It may include its lab

#if __has_include("../solutions/variance.cpp")
#include "../solutions/variance.cpp"
#elif __has_include("common/../../solutions/variance.cpp")
#include "common/../../solutions/variance.cpp"
#else
#include "/autograder/source/solutions/variance.cpp"
#endif

//// include_in_call
// attack: makes a file the argument of a macro, which turns it into a message
// says: /etc/passwd
// never says: root:

#define TEXT(...) #__VA_ARGS__
#define SAY(text) _Pragma(TEXT(GCC error text))
#define SHOW(...) SAY(TEXT(__VA_ARGS__))
#define QUOTE(...) SHOW(__VA_ARGS__)
QUOTE(
#include "/etc/passwd"
)

//// include_macro
// attack: includes the solution by a name that macros put together
// says: solutions/variance.cpp
// says: It may include its lab

#define SOLUTION "common/../../solutions/variance.cpp"
#define CHOSEN(name) name
#include CHOSEN(SOLUTION)

//// include_passwd
// attack: has the compiler quote /etc/passwd in its errors
// says: its compilation reads /etc/passwd
// never says: root:

#include "/etc/passwd"

static double attack() {
  return 0;
}

//// include_proc
// attack: reads a file by a name that means something else to every process
// says: variance.cpp reads /proc/self/
// never says: PATH=

#include "/proc/self/environ"

static double attack() {
  return 0;
}

//// include_relative
// attack: includes the solution, by a path from where the compiler runs
// says: ../../../solutions/variance.cpp

#include "../../../solutions/variance.cpp"

//// include_solution
// attack: includes the solution, by a path from a directory of headers
// says: variance.cpp reads
// says: It may include its lab

#include "common/../../solutions/variance.cpp"

//// include_unlisted
// attack: includes the solution only where a precompiled header stands before the first line
// says: variance.cpp reads
// says: /solutions/variance.cpp

// A run of the compiler that only lists what is included has no such header, and would list
// nothing.
#ifdef _GLIBCXX_VECTOR
#include "common/../../solutions/variance.cpp"
#else
#include "common/../../solutions/variance.cpp"  // no precompiled header: the plain way
#endif

//// include_zero
// attack: includes a file without an end
// says: variance.cpp
// never says: internal error

#include "/dev/zero"

static double attack() {
  return 0;
}

//// interpreter
// attack: names another program as its loader: the kernel opens that one by itself
// says: names its own loader

asm(".section .interp, \"a\"\n.asciz \"/bin/true\"\n.previous");

static double attack() {
  return 0;
}

//// large_array
// attack: three gigabytes of initialized data
// says: The compiler crashed on variance.cpp

char block[3000000000] = {1};

static double attack() {
  return block[7];
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

//// large_thread_local
// attack: a gigabyte of zeros for each thread
// says: The global variables of variance.cpp take

thread_local char block[1u << 30];

static double attack() {
  return block[7] = 1;
}

//// large_zeros
// attack: a gigabyte of global zeros
// says: The global variables of variance.cpp take

char block[1u << 30];

static double attack() {
  return block[7] = 1;
}

//// line_directive
// attack: has the compiler quote a file that it never read, as the place of an error
// says: does not compile
// never says: reference solution

#line 1 "../../../solutions/variance.cpp"
int 1a;

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

//// linker_words
// attack: speaks to the linker: a library to add, words to print, a stack to execute
// says: mean({

asm(".section .deplibs, \"MS\", @progbits, 1\n.asciz \"../../../solutions\"\n"
    ".section .gnu.warning.write\n.asciz \"the lab is passed\"\n"
    ".section .note.GNU-stack, \"x\"\n.previous");

static double attack() {
  return 1;
}

//// own_experiments
// attack: brings its own experiments
// says: `mc::runner::experiments()` is defined twice

#include "runner/experiment.hpp"
std::span<const mc::runner::Experiment> mc::runner::experiments() {
  return {};
}

static double attack() {
  return 0;
}

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

//// own_resolver
// attack: a resolver that the loader calls before anything else
// says: made a system call

#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

extern "C" int early() {
  return 0;
}
extern "C" void* resolve() {
  syscall(SYS_kill, -1, SIGKILL);
  return reinterpret_cast<void*>(&early);
}
extern "C" int late() __attribute__((ifunc("resolve")));

static double attack() {
  return late();
}

//// own_start
// attack: brings its own start
// says: `_start` is defined twice
// says: `__libc_start_main` is defined twice

extern "C" void _start() {}
extern "C" int __libc_start_main() {
  return 0;
}

static double attack() {
  return 0;
}

//// table_of_experiments
// attack: makes the table of experiments writable and puts its own into it
// says: ) = 1.5

#include <sys/mman.h>

#include "runner/experiment.hpp"

std::string forged(mc::wire::Reader&) {
  return std::string("\0\0\0\0\0\0\xf8\x3f", 8);
}
const bool done = [] {
  const auto all = mc::runner::experiments();
  const auto page = reinterpret_cast<std::uintptr_t>(all.data()) & ~std::uintptr_t{4095};
  mprotect(reinterpret_cast<void*>(page), 8192, PROT_READ | PROT_WRITE);
  const_cast<mc::runner::Experiment&>(all[0]).from_wire = forged;
  return true;
}();

static double attack() {
  return 0;
}
