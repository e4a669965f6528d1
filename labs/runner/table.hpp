#pragma once
// A result by hand: a table with a point, or another entry, a line, below a line that begins with #
// and says which number is what. A number alone is printed alone.

#include <cstddef>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "runner/text.hpp"
#include "runner/wire.hpp"

namespace mc::runner {

/// How the lists of a result are read. A list without any of this is one column. All but the
/// names in `columns` and `index` are parameters of the experiment: a number, or a list, which
/// stands for how many values it has.
struct Layout {
  std::string_view columns = {};  ///< names, by blanks; without them x y z, or x0 x1 … from four on
  std::string_view points = {};  ///< how many points a set has, if its columns follow each other,
  std::string_view dims = {};    ///< or how many columns it has
  std::string_view sets = {};    ///< how many sets follow each other
  std::string_view index = {};   ///< the name of a column that counts the lines, from 0 on,
  std::string_view from = {};    ///< or from here on,
  std::string_view row_labels = {};  ///< or that holds the values of this list
  std::string_view width = {};       ///< of a picture, whose pixels come row by row
  std::string_view kmax = {};        ///< of a periodogram: ky and within it kx from -kmax to kmax
};

/// An argument of an experiment, as it was typed.
struct Argument {
  std::string_view name;
  std::string_view text;
  bool is_list;
};
using Given = std::vector<Argument>;

/// Columns of one length, each with its name.
struct Block {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> columns;
  bool is_list = true;  ///< or one line of numbers
};

/// The blocks as text, the first list laid out.
std::string as_table(std::vector<Block> blocks, const Layout& layout, const Given& given);

template <class T>
constexpr bool is_list = false;
template <class T>
constexpr bool is_list<std::vector<T>> = true;

/// The columns of a list: one, or one for each field.
template <class T>
Block block_of(const std::string& name, const std::vector<T>& values) {
  Block block;
  if constexpr (wire::Listed<T>) {
    for (const std::string_view field : text::split(field_names(T{}), ',')) {
      block.names.emplace_back(field);
    }
    block.columns.resize(block.names.size());
    for (const T& value : values) {
      std::apply(
          [&](const auto&... field) {
            std::size_t i = 0;
            (block.columns[i++].push_back(text::print(field)), ...);
          },
          fields(const_cast<T&>(value)));
    }
  } else {
    block.names.push_back(name);
    std::vector<std::string>& column = block.columns.emplace_back();
    for (const T& value : values) column.push_back(text::print(value));
  }
  return block;
}

/// Fields that follow each other and have equal length are printed side by side.
template <wire::Listed T>
std::vector<Block> blocks_of(const T& value) {
  std::vector<Block> blocks;
  const auto add = [&](std::string_view name, const auto& field) {
    using Field = std::remove_cvref_t<decltype(field)>;
    Block block;
    if constexpr (is_list<Field>) {
      block = block_of(std::string(name), field);
    } else {
      block = block_of(std::string(name), std::vector<Field>{field});
      block.is_list = false;
    }
    const bool fits = !blocks.empty() && blocks.back().is_list == block.is_list &&
                      blocks.back().columns[0].size() == block.columns[0].size();
    if (!fits) {
      blocks.push_back(std::move(block));
      return;
    }
    Block& last = blocks.back();
    last.names.insert(last.names.end(), block.names.begin(), block.names.end());
    for (auto& column : block.columns) last.columns.push_back(std::move(column));
  };
  const auto names = text::split(field_names(value), ',');
  std::apply(
      [&](const auto&... field) {
        std::size_t i = 0;
        (add(names[i++], field), ...);
      },
      fields(const_cast<T&>(value)));
  return blocks;
}

/// A result, as printed for an experiment that is run by hand; a list without a name has the
/// experiment's.
template <class T>
std::string printed(const T& value, std::string_view name, const Layout& layout,
                    const Given& given) {
  if constexpr (is_list<T>) {
    return as_table({block_of(std::string(name), value)}, layout, given);
  } else if constexpr (wire::Listed<T>) {
    return as_table(blocks_of(value), layout, given);
  } else {
    return text::print(value);
  }
}

}  // namespace mc::runner
