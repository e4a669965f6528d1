#pragma once
// What the interactive page shows (./lab demo). A lab's hidden case, tagged [.demo], writes records
// of what the submission makes; the page's script draws them, and computes what follows from them.

#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "measurements/support/methods.hpp"

namespace mc::measurements {

/// Numbers in [0, 1) as text: each is rounded down to `characters` of 6 bits.
std::string encoded(std::span<const double> values, std::size_t characters);

/// At the beginning of a case: from here on the page says which tasks are missing, and why.
void begin_demo();

using DemoField = std::variant<std::string, double, std::vector<double>, std::vector<std::string>>;

/// Writes demo-`lab`-KEY.json, a record of these fields and the lab. NaN becomes null.
void write_demo(int lab, const std::string& key,
                const std::vector<std::pair<std::string, DemoField>>& fields);

/// The whole case of a lab's points of the plane: of each method, sets of 1, 4, … 1,024.
void demo_points(int lab, const std::vector<Method>& methods);

}  // namespace mc::measurements
