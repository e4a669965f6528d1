#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/bench.hpp"

namespace mc::grader {
namespace {

/// A JSON number; JSON has no NaN.
nlohmann::json number(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

nlohmann::ordered_json as_json(const std::vector<Ratio>& ratios) {
  auto all = nlohmann::ordered_json::array();
  for (const Ratio& one : ratios) {
    all.push_back({{"name", one.name},
                   {"against", one.against},
                   {"ratio", one.ratio},
                   {"nanoseconds", one.ours},
                   {"nanoseconds_of_the_other", one.other}});
  }
  return all;
}

nlohmann::ordered_json as_json(const Curve& curve) {
  nlohmann::ordered_json one{{"lab", curve.lab},   {"submission", curve.submission},
                             {"what", curve.what}, {"on", curve.on},
                             {"dims", curve.dims}, {"points", nlohmann::json::array()}};
  for (const Curve::Point& point : curve.points) {
    one["points"].push_back({{"n", point.n},
                             {"rmse", number(point.rmse)},
                             {"standard_error", number(point.error)},
                             {"nanoseconds_a_sample", number(point.sample)},
                             {"nanoseconds_of_the_integrand", number(point.integrand)},
                             {"efficiency", number(point.efficiency)}});
  }
  for (int digits = 2; digits <= 6; ++digits) {
    const auto reached = time_to(curve, std::pow(10, -digits));
    one["seconds_to"][fmt::format("1e-{}", digits)] =
        reached ? nlohmann::json(reached->seconds) : nlohmann::json("not reached");
  }
  return one;
}

}  // namespace

std::string bench_csv(const Bench& bench) {
  std::string all = fmt::format(
      "# {}; {} cores; {}; {}; {}; version {}\nlab,submission,kind,what,on,dims,n,value,error\n",
      bench.processor, bench.cores, bench.system, bench.compiler, bench.flags, bench.version);
  for (const BenchRow& row : bench.rows) {
    all += fmt::format("{},{},{},\"{}\",\"{}\",{},{},{},{}\n", row.lab, row.submission, row.kind,
                       row.what, row.on, row.dims, row.n, row.value,
                       std::isnan(row.error) ? "" : fmt::format("{}", row.error));
  }
  return all;
}

std::string bench_json(const Bench& bench) {
  nlohmann::ordered_json all{{"version", bench.version},
                             {"processor", bench.processor},
                             {"cores", bench.cores},
                             {"system", bench.system},
                             {"compiler", bench.compiler},
                             {"flags", bench.flags},
                             {"rounds", bench.rounds},
                             {"whole", bench.whole},
                             {"ratios", as_json(bench.ratios)},
                             {"ratios_without_avx2", as_json(bench.baseline)}};
  for (const Curve& curve : curves_of(bench)) all["curves"].push_back(as_json(curve));
  for (const BenchRow& row : bench.rows) {
    all["rows"].push_back({row.lab, row.submission, row.kind, row.what, row.on, row.dims, row.n,
                           number(row.value), number(row.error)});
  }
  return all.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

}  // namespace mc::grader
