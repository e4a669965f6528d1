#pragma once
// A result printed for a person: a table with one point, or other entry, per line, under a line of
// names that begins with #. A single number is printed alone.

#include <cstddef>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "runner/text.hpp"
#include "runner/wire.hpp"

namespace mc::runner {

/// How the first list of a result is cut into columns; without any of these it is one column. All
/// but `columns` and `index` name a parameter of the experiment, whose value counts: a number, or
/// the length of a list.
struct Layout {
  std::string_view columns =
      {};  ///< their names, between blanks; otherwise x y z, or x0 x1 x2 x3 …
  std::string_view points = {};      ///< points of a set, whose columns follow each other,
  std::string_view dims = {};        ///< or its columns
  std::string_view sets = {};        ///< sets that follow each other
  std::string_view index = {};       ///< the name of a column that numbers the lines, from 0 on,
  std::string_view from = {};        ///< or from this number on,
  std::string_view row_labels = {};  ///< or that has the values of this list
  std::string_view width = {};       ///< of a picture, whose pixels are stored row by row
  std::string_view kmax = {};        ///< of a periodogram: for each ky, kx from -kmax to kmax
};

/// An argument of an experiment, as it was typed.
struct TypedArgument {
  std::string_view name;
  std::string_view text;
  bool is_list;
};
using TypedArguments = std::vector<TypedArgument>;

/// Columns of equal length, each with its name.
struct Block {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> columns;
  bool is_list = true;  ///< false: one line of numbers
};

/// The blocks as text, the first list laid out.
std::string as_table(std::vector<Block> blocks, const Layout& layout,
                     const TypedArguments& arguments);

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

/// The result of an experiment that is run by hand; a list without a name has the experiment's.
template <class T>
std::string printed(const T& value, std::string_view name, const Layout& layout,
                    const TypedArguments& arguments) {
  if constexpr (is_list<T>) {
    return as_table({block_of(std::string(name), value)}, layout, arguments);
  } else if constexpr (wire::Listed<T>) {
    return as_table(blocks_of(value), layout, arguments);
  } else {
    return text::print(value);
  }
}

}  // namespace mc::runner
