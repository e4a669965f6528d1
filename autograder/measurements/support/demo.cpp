#include "measurements/support/demo.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "measurements/support/plot_data.hpp"

namespace mc::measurements {

std::string encoded(std::span<const double> values, std::size_t characters) {
  std::string text;
  for (double value : values) {
    for (std::size_t i = 0; i < characters; ++i) {
      value = 64 * std::clamp(value, 0.0, 1.0);
      const double digit = std::min(63.0, std::floor(value));
      value -= digit;
      const auto character = static_cast<char>('?' + static_cast<int>(digit));
      text += character == '\\' ? '!' : character;  // JSON would double it
    }
  }
  return text;
}

void begin_demo() {
  plot_file("demo-empty.txt");
}

void write_demo(int lab, const std::string& key,
                const std::vector<std::pair<std::string, DemoField>>& fields) {
  nlohmann::ordered_json record{{"lab", lab}};
  for (const auto& [name, field] : fields) {
    std::visit([&, to = &record[name]](const auto& value) { *to = value; }, field);
  }
  plot_file(fmt::format("demo-{}-{}.json", lab, key)) << record << '\n';
}

void demo_points(int lab, const std::vector<Method>& methods) {
  constexpr Count sets_in_all = 16, most = 1024;
  begin_demo();
  for (const Method& method : methods) {
    std::vector<std::string> points;
    for (Count n = method.is_sequence ? most : 1; n <= most; n *= 4) {
      for (const PointSet& set : method.points(n, 2, sets_in_all, n)) {
        points.push_back(encoded(set.column(0), 3) + encoded(set.column(1), 3));
      }
    }
    if (points.empty()) continue;
    write_demo(lab, method.key,
               {{"name", method.name},
                {"sequence", method.is_sequence ? 1.0 : 0.0},
                {"sets", static_cast<double>(sets_in_all)},
                {"points", points}});
  }
}

}  // namespace mc::measurements
