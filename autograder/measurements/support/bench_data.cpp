#include "measurements/support/bench_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "measurements/support/integrands.hpp"

namespace mc::checks {
namespace {

/// Replicates of an error: as many as fit into two million coordinates, which is what one
/// measurement can carry, 32 at least and 400 at most. The error's own standard error is then a
/// part 1/sqrt(2 · 32) = 12 % of it at most, if it is as good as normal.
std::uint64_t replicates_for(std::uint64_t coordinates) {
  return std::clamp<std::uint64_t>((std::uint64_t{1} << 20) / coordinates, 32, 400);
}

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
  std::vector<ErrorSums> errors_;
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

}  // namespace

std::optional<double> seconds_once(const Rounds& run) {
  auto rounds = rounds_of(run, 0.025);
  return rounds ? seconds_by_difference(run, *rounds) : std::nullopt;
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
