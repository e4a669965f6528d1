#include "grader/labs.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <numeric>
#include <regex>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/errors.hpp"

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

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

void add_ancestors(std::vector<Lab>& labs, const Layout& layout) {
  static const std::regex include("#include \"(\\w+)\\.hpp\"");
  for (Lab& lab : labs) {  // in order: those it stands on have lower numbers and are done
    const std::string header = text_of(layout.labs() / lab.folder / lab.header());
    for (std::sregex_iterator found(header.begin(), header.end(), include), end; found != end;
         ++found) {
      for (const Lab& other : labs) {
        if (other.name != (*found)[1] || other.number >= lab.number) continue;
        lab.stands_on.insert(lab.stands_on.end(), other.stands_on.begin(), other.stands_on.end());
        lab.stands_on.push_back(other.name);
      }
    }
    std::sort(lab.stands_on.begin(), lab.stands_on.end());
    lab.stands_on.erase(std::unique(lab.stands_on.begin(), lab.stands_on.end()),
                        lab.stands_on.end());
  }
}

}  // namespace

std::string Lab::title() const {
  std::string words = name;
  std::replace(words.begin(), words.end(), '_', ' ');
  return fmt::format("Lab {} · {}", number, words);
}

std::vector<Lab> find_labs(const Layout& layout) {
  static const std::regex folder_name("([0-9]+)-([a-z0-9-]+)");
  std::vector<Lab> labs;
  for (const auto& entry : fs::directory_iterator(layout.labs())) {
    const std::string folder = entry.path().filename().string();
    std::smatch parts;
    if (!entry.is_directory() || !std::regex_match(folder, parts, folder_name)) continue;
    std::string name = parts[2];
    std::replace(name.begin(), name.end(), '-', '_');
    labs.push_back({std::stoi(parts[1]), name, folder, {}});
  }
  std::sort(labs.begin(), labs.end(), [](auto& a, auto& b) { return a.number < b.number; });
  add_ancestors(labs, layout);
  return labs;
}

const Lab& find_lab(const std::vector<Lab>& labs, const std::string& text) {
  std::vector<std::string> names;
  for (const Lab& lab : labs) {
    if (text == lab.name || text == lab.folder || text == std::to_string(lab.number)) return lab;
    names.push_back(lab.name);
  }
  throw UsageError(fmt::format("no lab '{}'; did you mean '{}'? There are: {}", text,
                               nearest(text, names), fmt::join(names, ", ")));
}

std::string nearest(const std::string& text, const std::vector<std::string>& choices) {
  return *std::min_element(choices.begin(), choices.end(), [&](auto& a, auto& b) {
    return distance(text, a) < distance(text, b);
  });
}

}  // namespace mc::grader
