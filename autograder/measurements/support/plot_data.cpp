#include "measurements/support/plot_data.hpp"

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

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

void plot_table(const std::string& name, const Axis& x, const std::vector<Method>& methods,
                const std::function<double(Count n, const Method& method)>& cell) {
  plot_table(name, x, keys_of(methods),
             [&](double n, std::size_t c) { return cell(static_cast<Count>(n), methods[c]); });
}

Values powers(double from, double factor, double most) {
  Values all;
  for (double x = from; x <= most; x *= factor) all.push_back(x);
  return all;
}

void plot_names(const std::vector<Method>& methods) {
  std::ofstream file = open_data("names.gp");
  for (const Method& one : methods) {
    const std::string space = one.task.empty() ? "" : " ";
    file << fmt::format("{}_is = \"{}{}{}\"\n", one.key, one.task, space, one.name);
  }
}

void plot_points(const std::string& name, const Sets& sets) {
  auto file = plot_file(name, {"x", "y"});
  if (sets.empty())
    plot_row(file, {missing, missing});  // so that there is a row to draw in any case
  for (std::size_t i = 0; !sets.empty() && i < sets[0].size(); ++i) {
    plot_row(file, {sets[0].column(0)[i], sets[0].column(1)[i]});
  }
}

void plot_points(const std::string& picture, const std::vector<Method>& methods, Count n,
                 Count seed) {
  for (const Method& one : methods) {
    plot_points(fmt::format("{}-{}.tsv", picture, one.key), one.points(n, 2, 1, seed));
  }
}

void plot_errors(const ErrorPlot& plot) {
  Names columns = keys_of(plot.methods);
  columns.insert(columns.begin(), "N");
  columns.insert(columns.end(), plot.more.begin(), plot.more.end());
  std::vector<std::ofstream> files;
  for (const std::string& name : plot.names) {
    files.push_back(plot_file("convergence-" + name + ".tsv", columns));
  }
  std::set<std::string> endless;  // what once ran out of time would do so again
  for (const Count n : plot.sizes) {
    std::vector<Values> rows(files.size(), {static_cast<double>(n)});
    for (const Method& one : plot.methods) {
      std::vector<ErrorSums> errors(files.size());
      if (n <= one.most && !endless.contains(one.key)) {
        using Clock = std::chrono::steady_clock;
        const auto start = Clock::now();
        errors = errors_of(one, plot.integrands, n, plot.replicates(n), n);
        const bool was_long = Clock::now() - start > std::chrono::seconds(1);
        if (errors[0].count == 0 && was_long) endless.insert(one.key);
      }
      for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(errors[i].rmse());
    }
    const Values theory = plot.theory(n);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].insert(rows[i].end(), theory.begin(), theory.end());
      plot_row(files[i], rows[i]);
    }
  }
}

void plot_speed(const Method& method, Count values, const Rounds& rounds, double error) {
  auto file = plot_file("speed-" + method.key + ".tsv", {"ns", "error"});
  plot_row(file, {seconds_of(rounds, 0.01, 3) * 1e9 / static_cast<double>(values), error});
}

void plot_speed(const std::vector<Method>& methods, const Integrand& integrand, Count n,
                Count replicates) {
  for (const Method& one : methods) {
    plot_speed(one, n, one.rounds_of(n, integrand.dims),
               errors_of(one, integrand, n, replicates, n).rmse());
  }
}

}  // namespace mc::measurements
