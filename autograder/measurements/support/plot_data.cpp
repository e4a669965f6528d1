#include "measurements/support/plot_data.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "protocol/environment.hpp"

namespace mc::measurements {

namespace {

std::ofstream open_data(const std::string& name) {
  const char* directory = std::getenv(protocol::plot_data_variable);
  if (directory == nullptr) throw std::runtime_error("MC_PLOT_DATA is not set");
  std::ofstream file(std::filesystem::path(directory) / name);
  if (!file) throw std::runtime_error("cannot write " + name);
  pass();  // a case that has written something is whole
  return file;
}

std::set<std::string> pictures, reasons;  // of this process: one case

void write_missing() {
  if (reasons.empty()) return;
  for (const std::string& picture : pictures) {
    std::ofstream file = open_data(fmt::format("{}.{}.missing", picture, getpid()));
    for (const std::string& reason : reasons) file << reason << '\n';
  }
}

/// "5.3 is not written yet", "halton threw: …"
std::string reason_of(std::string_view experiment, const sandbox::Outcome& outcome) {
  if (!outcome.answered) return fmt::format("{} {}", experiment, outcome.failure);
  if (outcome.status == wire::Status::todo) return outcome.bytes + " is not written yet";
  return fmt::format("{} threw: {}", experiment, outcome.bytes);
}

[[maybe_unused]] const bool listens = [] {
  on_missing = [](std::string_view experiment, const Call& call) {
    if (reasons.insert(reason_of(experiment, call.outcome)).second) write_missing();
  };
  return true;
}();

}  // namespace

std::ofstream plot_file(const std::string& name, const Names& columns) {
  if (pictures.insert(name.substr(0, name.find_first_of("-."))).second) write_missing();
  std::ofstream file = open_data(name);
  for (const std::string& column : columns) file << column << '\t';
  if (!columns.empty()) file << '\n';
  return file;
}

void plot_row(std::ostream& file, const Values& values) {
  for (const double value : values) {
    file << (std::isnan(value) ? "NaN\t" : fmt::format("{}\t", value));
  }
  file << '\n';
}

void plot_image(const std::string& name, const Values& pixels, std::size_t width) {
  auto file = plot_file(name);
  for (auto row = pixels.begin(); row != pixels.end(); row += static_cast<std::ptrdiff_t>(width)) {
    plot_row(file, {row, row + static_cast<std::ptrdiff_t>(width)});
  }
}

void plot_table(const std::string& name, const Axis& x, const Names& columns,
                const std::function<double(double, std::size_t)>& cell) {
  Names all{x.name};
  all.insert(all.end(), columns.begin(), columns.end());
  auto file = plot_file(name, all);
  for (const double value : x.values) {
    Values row{value};
    for (std::size_t c = 0; c < columns.size(); ++c) row.push_back(cell(value, c));
    plot_row(file, row);
  }
}

void plot_table(const std::string& name, const Axis& x, const Methods& methods,
                const std::function<double(Count n, const Method& method)>& cell) {
  plot_table(name, x, methods.keys(),
             [&](double n, std::size_t c) { return cell(static_cast<Count>(n), methods.at(c)); });
}

Values powers(double from, double factor, double most) {
  Values all;
  for (double x = from; x <= most; x *= factor) all.push_back(x);
  return all;
}

void plot_points(const std::string& name, const Sets& sets) {
  auto file = plot_file(name, {"x", "y"});
  if (sets.empty()) return plot_row(file, {missing, missing});  // a row to draw in any case
  for (std::size_t i = 0; i < sets[0].size(); ++i) {
    plot_row(file, {sets[0].column(0)[i], sets[0].column(1)[i]});
  }
}

void plot_points(const std::string& picture, const Methods& methods, Count n, Count seed) {
  for (const Method& one : methods) {
    plot_points(fmt::format("{}-{}.tsv", picture, one.key), one.points(n, 2, 1, seed));
  }
}

void plot_errors(const Names& names, const std::vector<Integrand>& integrands,
                 const Methods& methods, const Values& sizes,
                 const std::function<Count(Count n)>& replicates) {
  Names columns = methods.keys();
  columns.insert(columns.begin(), "N");
  std::vector<std::ofstream> files;
  for (const std::string& name : names) {
    files.push_back(plot_file("convergence-" + name + ".tsv", columns));
  }
  std::set<std::string> endless;  // what once ran out of time would do so again
  for (const double size : sizes) {
    const auto n = static_cast<Count>(size);
    std::vector<Values> rows(files.size(), {size});
    for (const Method& one : methods) {
      std::vector<ErrorSums> errors(files.size());
      if (n <= one.traits.most && !endless.contains(one.key)) {
        using Clock = std::chrono::steady_clock;
        const auto start = Clock::now();
        errors = errors_of(one, integrands, n, replicates(n), n);
        const bool was_long = Clock::now() - start > std::chrono::seconds(1);
        if (errors[0].count() == 0 && was_long) endless.insert(one.key);
      }
      for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(errors[i].rmse());
    }
    for (std::size_t i = 0; i < rows.size(); ++i) plot_row(files[i], rows[i]);
  }
}

void plot_speed(const std::string& key, Count values, const Rounds& rounds, double error) {
  auto file = plot_file("speed-" + key + ".tsv", {"ns", "error"});
  plot_row(file, {seconds_of(rounds, 0.01, 3) * 1e9 / static_cast<double>(values), error});
}

void plot_speed(const Methods& methods, const Integrand& integrand, Count n, Count replicates) {
  for (const Method& one : methods) {
    plot_speed(one.key, n, one.rounds_of(n, integrand.dims),
               errors_of(one, integrand, n, replicates, n).rmse());
  }
}

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

void demo_points(int lab, const Methods& methods) {
  constexpr Count sets_in_all = 16, most = 1024;
  begin_demo();
  for (const Method& method : methods) {
    std::vector<std::string> points;
    for (Count n = method.traits.is_sequence ? most : 1; n <= most; n *= 4) {
      for (const PointSet& set : method.points(n, 2, sets_in_all, n)) {
        points.push_back(encoded(set.column(0), 3) + encoded(set.column(1), 3));
      }
    }
    if (points.empty()) continue;
    write_demo(lab, method.key,
               {{"name", method.name},
                {"sequence", method.traits.is_sequence ? 1.0 : 0.0},
                {"sets", static_cast<double>(sets_in_all)},
                {"points", points}});
  }
}

}  // namespace mc::measurements
