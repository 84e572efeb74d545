// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace bulletnav::bench {

/// What kernels are taken here, as BULLETNAV_ISA says it: amx, avx512, avx2, sse41, or "" for none.
std::string WidestInstructionSet();

/// One measured figure.
struct BenchFigure {
  std::string name;
  double value = 0.0;
  std::string unit;
  std::string scene;
  std::string backend;
  int workers = 1;
  std::string instruction_set = WidestInstructionSet();
};

/// How often per second `work` can be done: the median of several runs of at least `seconds` each.
/// `work` does `units` at a time.
double MedianRate(const std::function<void()>& work, int units, double seconds = 0.25);

/// Middle value; the mean of the middle two if their number is even.
double Median(std::vector<double> values);

/// A list of {name, value, unit, scene, backend, workers, instruction_set}.
std::string ToJson(const std::vector<BenchFigure>& figures);
/// A table for people.
std::string ToText(const std::vector<BenchFigure>& figures);

}  // namespace bulletnav::bench
