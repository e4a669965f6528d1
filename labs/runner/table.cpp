#include "runner/table.hpp"

#include <algorithm>
#include <cstdint>

namespace mc::runner {
namespace {

const Argument* find(const Given& given, std::string_view name) {
  const auto at = std::find_if(given.begin(), given.end(),
                               [=](const Argument& one) { return one.name == name; });
  return at == given.end() ? nullptr : &*at;
}

std::vector<std::string_view> values_of(const Given& given, std::string_view name) {
  const Argument* const argument = find(given, name);
  if (argument == nullptr || argument->text.empty()) return {};
  return text::split(argument->text, ',');
}

/// A number; of a list, how many values it has. 1 where there is no such argument.
std::uint64_t count_of(const Given& given, std::string_view name) {
  const Argument* const argument = find(given, name);
  if (argument == nullptr) return 1;
  if (argument->is_list) return values_of(given, name).size();
  std::uint64_t count = 0;
  text::parse(argument->text, count);
  return count;
}

/// "x", "y" and "z"; from four on "x0", "x1", …
std::vector<std::string> names_of(std::size_t columns, const Layout& layout,
                                  const std::string& otherwise) {
  std::vector<std::string> names;
  if (!layout.columns.empty()) {
    for (const std::string_view name : text::split(layout.columns, ' ')) names.emplace_back(name);
  }
  if (names.size() == columns) return names;
  names.clear();
  if (columns == 1) return {layout.dims.empty() ? otherwise : "x"};
  for (std::size_t d = 0; d < columns; ++d) {
    names.push_back(columns > 3 ? "x" + std::to_string(d) : std::string(1, "xyz"[d]));
  }
  return names;
}

/// How a list is cut: sets of so many points, each column by column.
struct Shape {
  std::size_t sets = 1, points = 0, columns = 1;
};

Shape shape_of(std::size_t values, const Layout& layout, const Given& given) {
  const std::uint64_t sets = count_of(given, layout.sets);
  if (sets == 0 || values % sets != 0) return {1, values, 1};
  const std::uint64_t of_a_set = values / sets;
  const std::uint64_t known = count_of(given, layout.points.empty() ? layout.dims : layout.points);
  if (known == 0 || of_a_set % known != 0) return {1, values, 1};
  if (!layout.points.empty()) return {sets, known, of_a_set / known};
  return {sets, of_a_set / known, known};
}

/// One column of values in that shape, cut into its columns.
void cut(Block& block, const Shape& shape, const Layout& layout) {
  const std::vector<std::string> values = std::move(block.columns[0]);
  block.columns.assign(shape.columns, {});
  auto next = values.begin();
  for (std::size_t set = 0; set < shape.sets; ++set) {
    for (auto& column : block.columns) {
      column.insert(column.end(), next, next + static_cast<std::ptrdiff_t>(shape.points));
      next += static_cast<std::ptrdiff_t>(shape.points);
    }
  }
  block.names = names_of(shape.columns, layout, block.names[0]);
}

/// Puts columns in front that say which line is which.
class Front {
 public:
  Front(Block& block, const Shape& shape) : block_(block), shape_(shape) {}

  /// The column whose line `i` of a set is named by `of`.
  template <class Of>
  void add(std::string_view name, Of of) {
    std::vector<std::string> column;
    for (std::size_t set = 0; set < shape_.sets; ++set) {
      for (std::size_t i = 0; i < shape_.points; ++i) column.push_back(of(set, i));
    }
    const auto at = static_cast<std::ptrdiff_t>(added_++);
    block_.names.emplace(block_.names.begin() + at, name);
    block_.columns.insert(block_.columns.begin() + at, std::move(column));
  }

 private:
  Block& block_;
  const Shape& shape_;
  std::size_t added_ = 0;
};

void add_front(Block& block, const Shape& shape, const Layout& layout, const Given& given) {
  Front front(block, shape);
  if (shape.sets > 1) {
    const Argument* const argument = find(given, layout.sets);
    const auto values = values_of(given, layout.sets);
    const bool is_list = argument != nullptr && argument->is_list;
    front.add(is_list ? layout.sets.substr(0, layout.sets.size() - 1) : "set",  // "seeds"
              [&](std::size_t set, std::size_t) {
                return is_list ? std::string(values[set]) : std::to_string(set);
              });
  }
  if (const std::uint64_t width = count_of(given, layout.width); !layout.width.empty() && width) {
    front.add("column", [=](std::size_t, std::size_t i) { return std::to_string(i % width); });
    front.add("row", [=](std::size_t, std::size_t i) { return std::to_string(i / width); });
  }
  if (!layout.kmax.empty()) {
    const auto kmax = static_cast<std::int64_t>(count_of(given, layout.kmax));
    const auto frequency = [=](std::size_t i) {
      return std::to_string(static_cast<std::int64_t>(i) - kmax);
    };
    const auto side = static_cast<std::size_t>(2 * kmax + 1);
    front.add("kx", [=](std::size_t, std::size_t i) { return frequency(i % side); });
    front.add("ky", [=](std::size_t, std::size_t i) { return frequency(i / side); });
  }
  const auto labels = values_of(given, layout.row_labels);
  if (!layout.row_labels.empty() && labels.size() == shape.points) {
    front.add(layout.index.empty() ? layout.row_labels : layout.index,
              [&](std::size_t, std::size_t i) { return std::string(labels[i]); });
  } else if (!layout.index.empty()) {
    const std::uint64_t from = layout.from.empty() ? 0 : count_of(given, layout.from);
    front.add(layout.index, [=](std::size_t, std::size_t i) { return std::to_string(from + i); });
  }
}

void lay_out(Block& block, const Layout& layout, const Given& given) {
  Shape shape = shape_of(block.columns[0].size(), layout, given);
  if (block.columns.size() == 1) {
    cut(block, shape, layout);
  } else {  // its columns stand side by side: they are cut into sets alone
    shape.points *= shape.columns;
    shape.columns = block.columns.size();
  }
  add_front(block, shape, layout, given);
}

std::string text_of(const Block& block) {
  std::vector<std::size_t> widths;
  for (std::size_t c = 0; c < block.columns.size(); ++c) {
    std::size_t width = block.names[c].size() + (c == 0 ? 2 : 0);  // "# "
    for (const std::string& value : block.columns[c]) width = std::max(width, value.size());
    widths.push_back(width);
  }
  std::string all;
  const auto add_line = [&](const auto& value_of) {
    for (std::size_t c = 0; c < widths.size(); ++c) {
      const std::string& value = value_of(c);
      all += value;
      if (c + 1 < widths.size()) all.append(widths[c] - value.size() + 2, ' ');
    }
    all += '\n';
  };
  const std::string first = "# " + block.names[0];
  add_line([&](std::size_t c) -> const std::string& { return c == 0 ? first : block.names[c]; });
  for (std::size_t i = 0; i < block.columns[0].size(); ++i) {
    add_line([&](std::size_t c) -> const std::string& { return block.columns[c][i]; });
  }
  return all;
}

}  // namespace

std::string as_table(std::vector<Block> blocks, const Layout& layout, const Given& given) {
  std::string all;
  const auto first_list =
      std::find_if(blocks.begin(), blocks.end(), [](const Block& block) { return block.is_list; });
  if (first_list != blocks.end()) lay_out(*first_list, layout, given);
  for (const Block& block : blocks) all += text_of(block);
  if (!all.empty()) all.pop_back();
  return all;
}

}  // namespace mc::runner
