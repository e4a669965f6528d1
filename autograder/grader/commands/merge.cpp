// merge: joins the tables of a class that several machines graded.

#include <algorithm>
#include <cstdio>
#include <map>

#include "grader/commands/command.hpp"
#include "grader/gradebook/book.hpp"
#include "grader/gradebook/corrections.hpp"

namespace mc::grader {
namespace {

/// Copies the verdicts of the rows as well: stats reads hints from them.
void copy_verdicts(const MergeResult& merged, const fs::path& out) {
  std::map<fs::path, std::string> texts;  // all are read before any is written
  for (const auto& [id, table] : merged.from) {
    const fs::path verdict = verdict_file(table, id);
    if (fs::exists(verdict)) texts[verdict_file(out, id)] = read_whole_text(verdict);
  }
  if (!texts.empty()) fs::create_directories(verdict_directory(out));
  for (const auto& [file, text] : texts) write_text(file, text);
}

/// How the runs of these tables ended. Reports the runs that did not finish.
std::vector<BookState> states_of(const std::vector<Table>& tables) {
  std::vector<BookState> states;
  for (const Table& table : tables) {
    states.push_back(read_book_state(table.file));
    if (!states.back().exists || states.back().finished) continue;
    fmt::print(stderr, "{} is incomplete: its run did not finish; --resume continues it\n",
               sandbox::printable_line(table.file.string()));
  }
  return states;
}

/// One run, as far as a later ./lab grade --resume can see; nothing if their seeds differ.
void join_states(const std::vector<BookState>& states, const fs::path& out) {
  const auto all = [&](auto holds) { return std::ranges::all_of(states, holds); };
  const std::uint64_t seed = states[0].seed;
  if (!all([&](const BookState& one) { return one.exists && one.seed == seed; })) return;
  write_book_state(out, all([](const BookState& one) { return one.finished; }), seed);
}

int merge(const Context& context, const Arguments& arguments) {
  const auto out = arguments.output("out");
  std::vector<Table> tables;
  for (const std::string& word : arguments.words) tables.push_back(read_table(word));
  const MergeResult merged = merge_tables(tables, context.labs);
  for (const std::string& difference : merged.differences) {
    fmt::print(stderr, "{}\n", difference);
  }
  const std::vector<BookState> states = states_of(tables);
  if (!out) {
    fmt::print("{}", table_text(merged.table));
    return 0;
  }
  copy_verdicts(merged, *out);
  write_text(*out, table_text(merged.table));
  write_text(*out, table_text(read_corrected_table(*out, context.labs)));
  join_states(states, *out);
  fmt::print("{}: {} submissions of {} tables\n", sandbox::printable_line(*out),
             merged.table.rows.size(), tables.size());
  return 0;
}

const RegisterCommand merge_command{
    {.usage = "merge A.csv B.csv … [--out F]",
     .details =
         "Merges the tables of ./lab grade --shard into the one that an unsharded run writes: a "
         "row for each id, in the order of the ids, with the columns of all tables. Different rows "
         "for one id are an error; different versions and seeds are reported.",
     .options = {{"--out F",
                  "write the table to this file, and the verdicts to F-verdicts/ next to it; "
                  "without it, print the table only"}},
     .run = merge,
     .least_words = 1}};

}  // namespace
}  // namespace mc::grader
