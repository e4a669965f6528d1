// stats: statistics of a table of grades.

#include "grader/commands/command.hpp"
#include "grader/gradebook/class_page.hpp"
#include "grader/gradebook/corrections.hpp"
#include "grader/gradebook/statistics.hpp"

namespace mc::grader {
namespace {

int stats(const Context& context, const Arguments& arguments) {
  const auto html = arguments.output("html");
  const Table table = read_corrected_table(arguments.words[0], context.labs);
  const auto statistics = statistics_of(table, read_verdicts(table), context.labs);
  fmt::print("{}", report_statistics(statistics));
  if (html) write_text(*html, statistics_page(statistics));
  return 0;
}

const RegisterCommand stats_command{
    {.usage = "stats grades.csv [--html F]",
     .details =
         "Statistics of a table from ./lab grade --csv: a histogram of the points of each lab; how "
         "many passed each check, failed it, did not write its task, or were not judged; its "
         "discrimination, the point-biserial correlation of passing it with the points of the "
         "lab's other checks; the hours that students report; and the most frequent hints. "
         "Unwritten tasks and hints are read from the verdicts next to the table.",
     .options = {{"--html F", "write the same as a page, without names"}},
     .run = stats,
     .least_words = 1,
     .most_words = 1}};

}  // namespace
}  // namespace mc::grader
