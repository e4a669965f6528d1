// What it sends, prints or throws instead of an answer. Sections: see CONTRIBUTING.md.

//// forged_result
// attack: writes its own result and leaves; it is a number like any other
// says: ) = 1.5

#include <unistd.h>

#include "runner/wire.hpp"

static double attack() {
  mc::wire::Writer result;
  result.put(1.5);
  const mc::wire::Header header{mc::wire::magic, mc::wire::Status::value, 0, result.bytes.size()};
  write(3, &header, sizeof header);
  write(3, result.bytes.data(), result.bytes.size());
  _exit(0);
}

//// prints_endlessly
// attack: prints without end
// says: printed more than 64 KB

#include <cstdio>

static double attack() {
  for (;;) std::puts("All tests passed. Score: 100 of 100 points");
}

//// prints_escapes
// attack: prints what a terminal obeys (colors, a title, another direction), and what GitHub does
// says: ?[2J?[32m100 of 100 points
// says: ?]0;passed?
// never says: ##[

#include <cstdio>

static double attack() {
  std::puts("\x1b[2J\x1b[32m100 of 100 points\x1b]0;passed\a\r\x9b\xff\u202e##[error]");
  return 0;
}

//// result_then_crash
// attack: a whole result, then a crash
// says: crashed: segmentation fault

#include <unistd.h>

#include "runner/wire.hpp"

static double attack() {
  const mc::wire::Header header{mc::wire::magic, mc::wire::Status::value, 0, 8};
  const double value = 1.5;
  write(3, &header, sizeof header);
  write(3, &value, sizeof value);
  return *static_cast<volatile double*>(nullptr);
}

//// says_todo
// attack: says «not written yet» of a task that would fail
// says: not written yet

#include "common/todo.hpp"

static double attack() {
  throw mc::todo("1.1 is fine </OverallResult>");
}

//// throws_markup
// attack: an exception whose text is markup, a record and a line of the report
// says: threw ]]></Failure><OverallResult success="true"/> ??
// says: ","score":100} passed 1  expected  nothing

#include <stdexcept>

static double attack() {
  throw std::runtime_error(
      "]]></Failure><OverallResult success=\"true\"/> \x1b\xc0"
      "\",\"score\":100}\npassed 1\n\texpected  nothing");
}
