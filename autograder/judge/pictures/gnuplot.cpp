#include "judge/pictures/gnuplot.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "judge/base/replace.hpp"
#include "judge/base/text_file.hpp"
#include "sandbox/printable.hpp"
#include "sandbox/programs.hpp"

namespace mc::grader {
namespace fs = std::filesystem;

bool gnuplot_is_there() {
  return sandbox::run_process({"gnuplot", "--version"}).exit_code == 0;
}

std::string gnuplot_string(std::string_view text) {
  // Only double quotes know \n.
  return '\'' + with_replacements(text, {{"'", "''"}, {"\n", "'.\"\\n\".'"}}) + '\'';
}

std::string gnuplot_array(const std::string& name, const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "" : ", ") + gnuplot_string(text);
  if (texts.empty()) list = "''";  // gnuplot has no empty arrays
  return fmt::format("array {}[{}] = [{}]\n", name, std::max<std::size_t>(texts.size(), 1), list);
}

std::string run_gnuplot(const fs::path& script, const std::string& text) {
  write_text(script, "set encoding utf8\nset termoption noenhanced\n" + text);
  const sandbox::ProcessResult drawn = sandbox::run_gnuplot(script);
  return drawn.succeeded() ? "" : "gnuplot failed: " + sandbox::printable(drawn.errors);
}

std::string script_beginning(const Layout& layout, const fs::path& out,
                             const std::string& extension) {
  return fmt::format("out = {}\next = {}\ndraw = {}\n", gnuplot_string(out.string()),
                     gnuplot_string(extension),
                     gnuplot_string((layout.labs() / "common" / "draw.gp").string()));
}

bool can_draw(Plots& plots) {
  if (gnuplot_is_there()) return true;
  plots.remarks.push_back("no plots: gnuplot is not installed (./lab setup)");
  return false;
}

void collect(Plots& plots, const fs::path& place, const std::string& start) {
  for (const auto& entry : fs::directory_iterator(place)) {
    if (entry.path().filename().string().starts_with(start)) plots.pictures.push_back(entry.path());
  }
  std::ranges::sort(plots.pictures);
}

}  // namespace mc::grader
