#include "grader/checkout/experiments.hpp"

#include "grader/base/text_file.hpp"
#include "runner/text.hpp"

namespace mc::grader {

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
