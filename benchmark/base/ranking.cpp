// SPDX-License-Identifier: MIT
#include "benchmark/base/ranking.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "sim/base/check.h"

namespace bulletnav::bench {

std::vector<PrecisionRecall> PrecisionRecallCurve(std::vector<Answer> answers) {
  std::sort(answers.begin(), answers.end(), [](const Answer& a, const Answer& b) {
    return a.score > b.score;
  });
  const auto all =
      static_cast<double>(std::count_if(answers.begin(), answers.end(), [](const Answer& a) {
        return a.is_true;
      }));
  std::vector<PrecisionRecall> curve;
  if (all == 0.0) return curve;
  double found = 0.0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    found += answers[i].is_true ? 1.0 : 0.0;
    const bool is_last = i + 1 == answers.size() || answers[i + 1].score < answers[i].score;
    if (!is_last) continue;
    curve.push_back({double{answers[i].score}, found / static_cast<double>(i + 1), found / all});
  }
  return curve;
}

double AveragePrecision(std::span<const PrecisionRecall> curve) {
  double area = 0.0;
  double recall = 0.0;
  for (const PrecisionRecall& point : curve) {
    area += point.precision * (point.recall - recall);
    recall = point.recall;
  }
  return area;
}

std::vector<PrecisionRecall> Thin(std::span<const PrecisionRecall> curve, int steps) {
  std::vector<PrecisionRecall> thin;
  double next = 0.0;
  for (const PrecisionRecall& point : curve) {
    if (point.recall < next) continue;
    thin.push_back(point);
    next = (std::floor(point.recall * steps) + 1.0) / steps;
  }
  return thin;
}

std::vector<double> Ranks(std::span<const double> values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return values[a] < values[b];
  });
  std::vector<double> ranks(values.size());
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin + 1;
    while (end < order.size() && values[order[end]] == values[order[begin]]) ++end;
    const double rank = 0.5 * static_cast<double>(begin + 1 + end);
    for (; begin < end; ++begin) ranks[order[begin]] = rank;
  }
  return ranks;
}

double RankCorrelation(std::span<const double> a, std::span<const double> b) {
  BULLETNAV_CHECK_EQ(a.size(), b.size());
  const std::vector<double> ranks_a = Ranks(a);
  const std::vector<double> ranks_b = Ranks(b);
  const double middle = 0.5 * static_cast<double>(a.size() + 1);
  double both = 0.0;
  double var_a = 0.0;
  double var_b = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double off_a = ranks_a[i] - middle;
    const double off_b = ranks_b[i] - middle;
    both += off_a * off_b;
    var_a += off_a * off_a;
    var_b += off_b * off_b;
  }
  return var_a > 0.0 && var_b > 0.0 ? both / std::sqrt(var_a * var_b) : 0.0;
}

}  // namespace bulletnav::bench
