// SPDX-License-Identifier: MIT
#include "benchmark/perf/bench_figure.h"

#include <algorithm>
#include <chrono>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "sim/base/instruction_set.h"

namespace bulletnav::bench {
namespace {

constexpr int kRuns = 7;

}  // namespace

std::string WidestInstructionSet() {
  if (sim::MayUse(sim::InstructionSet::kAmx)) return "amx";
  if (sim::MayUse(sim::InstructionSet::kAvx512)) return "avx512";
  if (sim::MayUse(sim::InstructionSet::kAvx2)) return "avx2";
  return sim::MayUse(sim::InstructionSet::kSse41) ? "sse41" : "";
}

double Median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

double MedianRate(const std::function<void()>& work, int units, double seconds) {
  using Clock = std::chrono::steady_clock;
  work();  // warm caches
  std::vector<double> rates;
  for (int run = 0; run < kRuns; ++run) {
    const Clock::time_point start = Clock::now();
    double elapsed = 0.0;
    int done = 0;
    while (elapsed < seconds) {
      work();
      done += units;
      elapsed = std::chrono::duration<double>(Clock::now() - start).count();
    }
    rates.push_back(done / elapsed);
  }
  return Median(rates);
}

std::string ToJson(const std::vector<BenchFigure>& figures) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const BenchFigure& f : figures) {
    list.push_back({{"name", f.name},
                    {"value", f.value},
                    {"unit", f.unit},
                    {"scene", f.scene},
                    {"backend", f.backend},
                    {"workers", f.workers},
                    {"instruction_set", f.instruction_set}});
  }
  return list.dump(1) + "\n";
}

std::string ToText(const std::vector<BenchFigure>& figures) {
  std::string text = fmt::format("{:<34} {:>10} {:<14} {:<8} {:>7}  {:<12}  {}\n", "figure",
                                 "value", "unit", "backend", "workers", "isa", "scene");
  for (const BenchFigure& f : figures) {
    text += fmt::format("{:<34} {:>10.4g} {:<14} {:<8} {:>7}  {:<12}  {}\n", f.name, f.value,
                        f.unit, f.backend, f.workers, f.instruction_set, f.scene);
  }
  return text;
}

}  // namespace bulletnav::bench
