#include "checks/support/bench_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "protocol/environment.hpp"

namespace mc::checks {
namespace {

/// Replicates of an error: as many as fit into two million coordinates, which is what one
/// measurement can carry, 32 at least and 400 at most. The error's own standard error is then a
/// part 1/sqrt(2 · 32) = 12 % of it at most, if it is as good as normal.
std::uint64_t replicates_for(std::uint64_t coordinates) {
  return std::clamp<std::uint64_t>((std::uint64_t{1} << 20) / coordinates, 32, 400);
}

/// Sums over replicates: of squared errors, and of their squares.
struct Errors {
  double count = 0, squares = 0, fourths = 0;
  void add(double error) {
    ++count;
    squares += error * error;
    fourths += error * error * error * error;
  }
  double rmse() const { return std::sqrt(squares / count); }
  /// Of the RMSE: that of the mean square, by the delta method.
  double standard_error() const {
    const double mean = squares / count;
    return std::sqrt(std::max(0.0, fourths / count - mean * mean) / count) / (2 * rmse());
  }
};

std::vector<const BenchIntegrand*> integrands_of(std::uint64_t dims) {
  std::vector<const BenchIntegrand*> all;
  for (const BenchIntegrand& one : bench_integrands()) {
    if (one.dims == dims) all.push_back(&one);
  }
  return all;
}

/// Errors of one sampler at one n.
class ErrorsAt {
 public:
  explicit ErrorsAt(std::uint64_t dims)
      : dims_(dims), integrands_(integrands_of(dims)), errors_(integrands_.size()) {}

  void add(std::span<const std::span<const double>> columns) {
    points_ += static_cast<double>(columns[0].size());
    for (std::size_t i = 0; i < integrands_.size(); ++i) {
      errors_[i].add(mean_over(*integrands_[i], columns) - 1);
    }
  }
  void write(const std::string& what) const {
    if (errors_.empty() || errors_[0].count == 0) return;
    const auto n = static_cast<std::uint64_t>(std::llround(points_ / errors_[0].count));
    for (std::size_t i = 0; i < integrands_.size(); ++i) {
      bench_row({"error", what, integrands_[i]->name, dims_, n, errors_[i].rmse(),
                 errors_[i].standard_error()});
    }
  }

 private:
  std::uint64_t dims_;
  std::vector<const BenchIntegrand*> integrands_;
  std::vector<Errors> errors_;
  double points_ = 0;
};

void bench_errors_at(const BenchSampler& sampler, std::uint64_t dims, std::uint64_t n) {
  ErrorsAt errors(dims);
  const std::uint64_t replicates = replicates_for(n * dims);
  const std::uint64_t at_once = std::max<std::uint64_t>(1, (std::uint64_t{1} << 20) / (n * dims));
  for (std::uint64_t done = 0; done < replicates; done += at_once) {
    const auto got = sampler.points(n, dims, std::min(at_once, replicates - done), done + 1);
    if (!got) return;
    const std::span<const double> values = got->values;
    for (std::size_t first = 0; first + n * dims <= values.size(); first += n * dims) {
      std::vector<std::span<const double>> columns;
      for (std::size_t d = 0; d < dims; ++d) columns.push_back(values.subspan(first + d * n, n));
      errors.add(columns);
    }
  }
  errors.write(sampler.name);
}

bool is_asked_for(const std::string& task) {
  const char* tasks = std::getenv(protocol::speed_tasks_variable);
  return tasks != nullptr && fmt::format(" {} ", tasks).find(' ' + task + ' ') != std::string::npos;
}

/// So many rounds that they take about `wanted` seconds, the start of the program included.
std::optional<std::uint64_t> rounds_of(const Rounds& run, double wanted) {
  constexpr double enough = 0.004;
  for (std::uint64_t rounds = 1;; rounds *= 4) {
    const auto took = run(rounds);
    if (!took) return {};
    if (*took < enough) continue;
    return static_cast<std::uint64_t>(
        std::ceil(static_cast<double>(rounds) * std::max(1.0, wanted / *took)));
  }
}

}  // namespace

void bench_row(const protocol::Row& row) {
  static std::ofstream file = [] {
    const char* path = std::getenv(protocol::rows_variable);
    if (path == nullptr) throw std::runtime_error("MC_BENCH_DATA is not set");
    return std::ofstream(path, std::ios::app);
  }();
  file << protocol::line_of(row) << std::endl;
}

std::optional<double> seconds_once(const Rounds& run) {
  const auto enough = rounds_of(run, 0.025);
  if (!enough) return {};
  std::uint64_t rounds = *enough;
  // What it takes before the first round may be more than that (values to be made, memory to be
  // had): its noise must not be taken for a round.
  for (int attempt = 0;; ++attempt, rounds *= 4) {
    const auto one = run(rounds), two = run(2 * rounds);
    if (!one || !two) return {};
    if (*two - *one > 0.25 * *one) return (*two - *one) / static_cast<double>(rounds);
    if (attempt == 3) return {};
  }
}

void bench_speed(const std::string& task, const std::string& name, std::uint64_t values,
                 const Rounds& rounds) {
  if (!is_asked_for(task)) return;
  const auto count = rounds_of(rounds, 0.025);
  if (!count) return;
  // The median of three differences, the two runs of each close together: a shared machine changes its
  // pace from one second to the next.
  std::array<double, 3> differences{};
  for (double& difference : differences) {
    const auto once = rounds(*count), twice = rounds(2 * *count);
    if (!once || !twice) return;
    difference = *twice - *once;
  }
  std::sort(differences.begin(), differences.end());
  const double nanoseconds = differences[1] * 1e9 / static_cast<double>(*count * values);
  if (nanoseconds > 0) bench_row({"speed", task + ' ' + name, "", 0, values, nanoseconds});
}

void bench_speed_error(const std::string& task, const std::string& name,
                       const BenchSampler& sampler, std::uint64_t n) {
  if (!is_asked_for(task)) return;
  constexpr std::uint64_t sets = 64;
  const auto got = sampler.points(n, 2, sets, 1);
  if (!got || got->values.size() != sets * n * 2) return;
  Errors errors;
  for (std::uint64_t set = 0; set < sets; ++set) {
    const std::span<const double> values = std::span(got->values).subspan(set * n * 2, n * 2);
    const std::array columns{values.first(n), values.last(n)};
    errors.add(mean_over(*integrands_of(2).front(), columns) - 1);
  }
  bench_row({"speed error", task + ' ' + name, "exp(x + y)", 2, n, errors.rmse(),
             errors.standard_error()});
}

std::vector<std::uint64_t> bench_sizes(const BenchSampler& sampler, std::uint64_t dims) {
  std::vector<std::uint64_t> sizes;
  for (std::uint64_t n = 16; n <= sampler.most; n *= 4) {
    const double root = std::pow(static_cast<double>(n), 1 / static_cast<double>(dims));
    if (sampler.power_of_root && std::abs(root - std::round(root)) > 1e-9) continue;
    sizes.push_back(n);
  }
  return sizes;
}

void bench_errors(const std::vector<BenchSampler>& samplers) {
  for (const BenchSampler& sampler : samplers) {
    for (const std::uint64_t dims : sampler.dims) {
      for (const std::uint64_t n : bench_sizes(sampler, dims)) bench_errors_at(sampler, dims, n);
    }
  }
}

void bench_errors_of_sets(const std::string& what, std::span<const std::uint64_t> sizes,
                          std::span<const double> x, std::span<const double> y) {
  ErrorsAt errors(2);
  std::size_t first = 0;
  for (const std::uint64_t size : sizes) {
    if (size == 0 || first + size > std::min(x.size(), y.size())) break;
    const std::array columns{x.subspan(first, size), y.subspan(first, size)};
    errors.add(columns);
    first += size;
  }
  errors.write(what);
}

void bench_times(const std::vector<BenchSampler>& samplers) {
  for (const BenchIntegrand& one : bench_integrands()) {
    bench_row({"integrand", one.name, "", one.dims, 0, nanoseconds_of(one)});
    bench_row({"variance", one.name, "", one.dims, 0, one.variance});
  }
  for (const BenchSampler& sampler : samplers) {
    for (const std::uint64_t dims : sampler.dims) {
      auto sizes = bench_sizes(sampler, dims);
      if (sampler.same_for_all_n) sizes = {4096};
      for (std::size_t i = 0; i < sizes.size(); ++i) {
        if (i % 2 == 1 && i + 1 < sizes.size()) continue;  // every other one, and the last
        const auto round = seconds_once(
            [&](std::uint64_t rounds) { return sampler.rounds(sizes[i], dims, rounds); });
        if (!round) break;
        bench_row({"time", sampler.name, "", dims, sizes[i],
                   *round * 1e9 / static_cast<double>(sizes[i])});
      }
    }
  }
}

void bench_growth(const std::string& what, std::uint64_t dims, std::uint64_t most,
                  const std::function<std::optional<Used>(std::uint64_t, std::uint64_t)>& rounds,
                  std::uint64_t least, std::uint64_t factor) {
  for (std::uint64_t n = least; n <= most; n *= factor) {
    std::size_t memory = 0;
    const auto round = seconds_once([&](std::uint64_t times) -> std::optional<double> {
      const auto used = rounds(n, times);
      if (!used) return {};
      memory = std::max(memory, used->memory);
      return used->seconds;
    });
    if (!round) return;
    bench_row({"growth", what, "n", dims, n, *round});
    bench_row({"memory", what, "n", dims, n, static_cast<double>(memory)});
  }
}

void bench_growth_of_dims(const BenchSampler& sampler) {
  for (std::uint64_t dims = 1; dims <= 32; dims *= 2) {
    const auto round =
        seconds_once([&](std::uint64_t rounds) { return sampler.rounds(4096, dims, rounds); });
    if (!round) return;
    bench_row({"growth", sampler.name, "dims", dims, 4096, *round});
  }
}

}  // namespace mc::checks
