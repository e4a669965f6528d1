#include "runner/table.hpp"

#include <algorithm>
#include <cstdint>

namespace mc::runner {
namespace {

const TypedArgument* find(const TypedArguments& arguments, std::string_view name) {
  const auto at =
      std::ranges::find_if(arguments, [=](const TypedArgument& one) { return one.name == name; });
  return at == arguments.end() ? nullptr : &*at;
}

std::vector<std::string_view> values_of(const TypedArguments& arguments, std::string_view name) {
  const TypedArgument* const argument = find(arguments, name);
  if (argument == nullptr || argument->text.empty()) return {};
  return text::split(argument->text, ',');
}

/// The number; of a list, its length. 1 if there is no such argument.
std::uint64_t count_of(const TypedArguments& arguments, std::string_view name) {
  const TypedArgument* const argument = find(arguments, name);
  if (argument == nullptr) return 1;
  if (argument->is_list) return values_of(arguments, name).size();
  std::uint64_t count = 0;
  text::parse(argument->text, count);
  return count;
}

/// "x", "y" and "z"; from four on "x0", "x1", …
std::vector<std::string> names_of(std::size_t columns, const Layout& layout,
                                  const std::string& otherwise) {
  std::vector<std::string> names = text::words_of(layout.columns);
  if (names.size() == columns) return names;
  names.clear();
  if (columns == 1) return {layout.dims.empty() ? otherwise : "x"};
  for (std::size_t d = 0; d < columns; ++d) {
    names.push_back(columns > 3 ? "x" + std::to_string(d) : std::string(1, "xyz"[d]));
  }
  return names;
}

/// A list as sets of points; the columns of a set follow each other.
struct Shape {
  std::size_t sets = 1, points = 0, columns = 1;
};

Shape shape_of(std::size_t values, const Layout& layout, const TypedArguments& arguments) {
  const std::uint64_t sets = count_of(arguments, layout.sets);
  if (sets == 0 || values % sets != 0) return {1, values, 1};
  const std::uint64_t of_a_set = values / sets;
  const std::uint64_t known =
      count_of(arguments, layout.points.empty() ? layout.dims : layout.points);
  if (known == 0 || of_a_set % known != 0) return {1, values, 1};
  if (!layout.points.empty()) return {sets, known, of_a_set / known};
  return {sets, of_a_set / known, known};
}

/// Cuts the block's only column into those of the shape.
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

/// Adds columns on the left that identify the lines.
void add_labels(Block& block, const Shape& shape, const Layout& layout,
                const TypedArguments& arguments) {
  std::ptrdiff_t added = 0;
  // The column whose entry for line `i` of a set is label(set, i).
  const auto add = [&](std::string_view name, const auto& label) {
    std::vector<std::string> column;
    for (std::size_t set = 0; set < shape.sets; ++set) {
      for (std::size_t i = 0; i < shape.points; ++i) column.push_back(label(set, i));
    }
    block.names.emplace(block.names.begin() + added, name);
    block.columns.insert(block.columns.begin() + added, std::move(column));
    ++added;
  };
  if (shape.sets > 1) {
    const TypedArgument* const argument = find(arguments, layout.sets);
    const auto values = values_of(arguments, layout.sets);
    const bool is_list = argument != nullptr && argument->is_list;
    add(is_list ? layout.sets.substr(0, layout.sets.size() - 1) : "set",  // "seeds"
        [&](std::size_t set, std::size_t) {
          return is_list ? std::string(values[set]) : std::to_string(set);
        });
  }
  if (const std::uint64_t width = count_of(arguments, layout.width);
      !layout.width.empty() && width) {
    add("column", [=](std::size_t, std::size_t i) { return std::to_string(i % width); });
    add("row", [=](std::size_t, std::size_t i) { return std::to_string(i / width); });
  }
  if (!layout.kmax.empty()) {
    const auto kmax = static_cast<std::int64_t>(count_of(arguments, layout.kmax));
    const auto frequency = [=](std::size_t i) {
      return std::to_string(static_cast<std::int64_t>(i) - kmax);
    };
    const auto side = static_cast<std::size_t>(2 * kmax + 1);
    add("kx", [=](std::size_t, std::size_t i) { return frequency(i % side); });
    add("ky", [=](std::size_t, std::size_t i) { return frequency(i / side); });
  }
  const auto labels = values_of(arguments, layout.row_labels);
  if (!layout.row_labels.empty() && labels.size() == shape.points) {
    add(layout.index.empty() ? layout.row_labels : layout.index,
        [&](std::size_t, std::size_t i) { return std::string(labels[i]); });
  } else if (!layout.index.empty()) {
    const std::uint64_t from = layout.from.empty() ? 0 : count_of(arguments, layout.from);
    add(layout.index, [=](std::size_t, std::size_t i) { return std::to_string(from + i); });
  }
}

void lay_out(Block& block, const Layout& layout, const TypedArguments& arguments) {
  Shape shape = shape_of(block.columns[0].size(), layout, arguments);
  if (block.columns.size() == 1) {
    cut(block, shape, layout);
  } else {  // it has its columns already, each with all sets
    shape.points *= shape.columns;
    shape.columns = block.columns.size();
  }
  add_labels(block, shape, layout, arguments);
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

std::string as_table(std::vector<Block> blocks, const Layout& layout,
                     const TypedArguments& arguments) {
  std::string all;
  const auto first_list =
      std::ranges::find_if(blocks, [](const Block& block) { return block.is_list; });
  if (first_list != blocks.end()) lay_out(*first_list, layout, arguments);
  for (const Block& block : blocks) all += text_of(block);
  if (!all.empty()) all.pop_back();
  return all;
}

}  // namespace mc::runner
