#pragma once
// The tables of a page.

#include <string>
#include <string_view>
#include <vector>

#include "checks/support/catch.hpp"

namespace mc::tests {

using Cells = std::vector<std::vector<std::string>>;

/// The table that begins after `from` in a page, without its header: the text of each cell, up to a
/// line break.
inline Cells cells_after(const std::string& page, const std::string& from) {
  CAPTURE(from);
  const auto begin = page.find("<table>", page.find(from));
  REQUIRE(begin != std::string::npos);
  std::string_view rest(page);
  rest = rest.substr(begin, page.find("</table>", begin) - begin);
  Cells rows;
  bool in_cell = false;
  while (!rest.empty()) {
    const auto length = rest[0] == '<' ? rest.find('>') + 1 : 1;
    const std::string_view tag = rest.substr(0, length);
    if (tag == "<tr>") rows.emplace_back();
    if (tag.starts_with("<td") || tag.starts_with("<th")) {
      rows.back().emplace_back();
      in_cell = true;
    }
    if (tag.starts_with("</t") || tag == "<br>" || tag == "<pre>") in_cell = false;
    if (in_cell && length == 1) rows.back().back() += tag;
    rest.remove_prefix(length);
  }
  rows.erase(rows.begin());
  return rows;
}

}  // namespace mc::tests
