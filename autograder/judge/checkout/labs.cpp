#include "judge/checkout/labs.hpp"

#include <algorithm>
#include <fstream>
#include <numeric>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "judge/base/errors.hpp"
#include "judge/base/text_file.hpp"
#include "runner/text.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

/// Levenshtein's distance.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t above = row[j + 1];
      row[j + 1] = std::min({above + 1, row[j] + 1, diagonal + (a[i] == b[j] ? 0 : 1)});
      diagonal = above;
    }
  }
  return row.back();
}

/// The names X in a header's lines #include "X.hpp".
std::vector<std::string> included_by(const fs::path& header) {
  const std::string start = "#include \"", end = ".hpp\"";
  std::vector<std::string> names;
  std::ifstream file(header);
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(start) && line.ends_with(end)) {
      names.push_back(line.substr(start.size(), line.size() - start.size() - end.size()));
    }
  }
  return names;
}

void add_dependencies(std::vector<Lab>& labs, const Layout& layout) {
  for (Lab& lab : labs) {  // in order: the labs it depends on have lower numbers and are done
    std::set<std::string> names;
    for (const std::string& name : included_by(layout.labs() / lab.folder / lab.header())) {
      for (const Lab& other : labs) {
        if (other.name != name || other.number >= lab.number) continue;
        names.insert(other.depends_on.begin(), other.depends_on.end());
        names.insert(other.name);
      }
    }
    lab.depends_on = {names.begin(), names.end()};
  }
}

}  // namespace

std::string Lab::title() const {
  std::string words = name;
  std::ranges::replace(words, '_', ' ');
  return fmt::format("Lab {} · {}", number, words);
}

std::vector<Lab> find_labs(const Layout& layout) {
  std::vector<Lab> labs;
  for (const auto& entry : fs::directory_iterator(layout.labs())) {
    const std::string folder = entry.path().filename().string();
    const auto dash = folder.find('-');
    if (!entry.is_directory() || dash == std::string::npos || dash == 0 ||
        folder.find_first_not_of("0123456789") != dash) {
      continue;
    }
    std::string name = folder.substr(dash + 1);
    std::ranges::replace(name, '-', '_');
    labs.push_back({std::stoi(folder.substr(0, dash)), name, folder, {}});
  }
  std::ranges::sort(labs, [](auto& a, auto& b) { return a.number < b.number; });
  add_dependencies(labs, layout);
  return labs;
}

const Lab& find_lab(const std::vector<Lab>& labs, const std::string& word) {
  std::string text = word;  // "labs/1-variance/" is what a shell completes
  if (text.starts_with("labs/")) text.erase(0, 5);
  while (text.ends_with('/')) text.pop_back();
  std::vector<std::string> names;
  for (const Lab& lab : labs) {
    if (text == lab.name || text == lab.folder || text == std::to_string(lab.number)) return lab;
    names.push_back(lab.name);
  }
  const std::string shown = sandbox::printable_line(word);
  if (!text.empty() && text.find_first_not_of("0123456789") == std::string::npos) {
    throw UsageError(fmt::format("no lab '{}'; there are 1 to {}", shown, labs.size()));
  }
  throw UsageError(fmt::format("no lab '{}'; did you mean '{}'? There are: {}", shown,
                               nearest(text, names), fmt::join(names, ", ")));
}

std::string nearest(const std::string& text, const std::vector<std::string>& choices) {
  return *std::ranges::min_element(
      choices, [&](auto& a, auto& b) { return distance(text, a) < distance(text, b); });
}

std::vector<Experiment> experiments_of(const Layout& layout, const Lab& lab) {
  const std::string start = "MC_EXPERIMENT(";  // MC_EXPERIMENT(name, "x y", "what it does")
  const std::string text = read_text(layout.labs() / lab.folder / "experiments.cpp");
  std::vector<Experiment> all;
  for (auto at = text.find(start); at != std::string::npos; at = text.find(start, at + 1)) {
    const auto from = at + start.size(), comma = text.find(',', from);
    const auto open = text.find('"', from), close = text.find('"', open + 1);
    if (close == std::string::npos) break;
    all.push_back(
        {text.substr(from, comma - from), text::words_of(text.substr(open + 1, close - open - 1))});
  }
  return all;
}

}  // namespace mc::grader
