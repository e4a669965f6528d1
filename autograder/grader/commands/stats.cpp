// stats: statistics of a table of grades.

#include <fmt/format.h>

#include "grader/base/errors.hpp"
#include "grader/base/text_file.hpp"
#include "grader/commands/command.hpp"
#include "grader/commands/judging_options.hpp"
#include "grader/gradebook/class_page.hpp"
#include "grader/gradebook/corrections.hpp"
#include "grader/gradebook/statistics.hpp"
#include "grader/gradebook/table.hpp"

namespace mc::grader {
namespace {

int stats(const Context& context, const Arguments& arguments) {
  if (arguments.words.size() != 1) throw UsageError("usage: ./lab stats grades.csv [--html F]");
  const auto html = arguments.get("html");
  require_writable(html);
  const Table table = read_corrected_table(arguments.words[0], context.labs);
  const auto statistics = statistics_of(table, read_verdicts(table), context.labs);
  fmt::print("{}", report_statistics(statistics));
  if (html) write_text(*html, statistics_page(statistics));
  return 0;
}

const RegisterCommand stats_command{
    {"stats",
     "stats grades.csv [--html F]",
     {"html="},
     "Statistics of a table from ./lab grade --csv: a histogram of the points of each lab; how\n"
     "many passed each check, failed it, did not write its task, or were not judged; its\n"
     "discrimination, the point-biserial correlation of passing it with the points of the lab's\n"
     "other checks; the hours that students report; and the most frequent hints. Unwritten tasks\n"
     "and hints are read from the verdicts next to the table.\n"
     "  --html F      write the same as a page, without names\n",
     stats}};

}  // namespace
}  // namespace mc::grader
