// SPDX-License-Identifier: MIT
#include "benchmark/slam/training/place_measures.h"

#include <cmath>
#include <cstddef>
#include <utility>

#include "benchmark/base/ranking.h"
#include "sim/base/check.h"
#include "sim/math/pose.h"

namespace bulletnav::bench {
namespace {

double AveragePrecisionOf(std::vector<Answer> answers) {
  return AveragePrecision(PrecisionRecallCurve(std::move(answers)));
}

bool HasLike(const PlaceViews& views, int a) {
  for (int b = 0; b < views.count(); ++b) {
    if (b != a && views.covisibility(a, b) >= kSamePlace) return true;
  }
  return false;
}

/// The first of the most similar of `count` views to view `a`, itself aside.
int MostSimilar(std::span<const float> cosines, int a, int count) {
  int best = -1;
  for (int b = 0; b < count; ++b) {
    if (a == b) continue;
    const float cosine = cosines[static_cast<std::size_t>(b)];
    if (best < 0 || cosine > cosines[static_cast<std::size_t>(best)]) best = b;
  }
  return best;
}

/// Of views that have one like them, the share whose most similar view is one.
double RecallAtOne(const PlaceViews& views, std::span<const float> cosines) {
  const int count = views.count();
  int queries = 0;
  int right = 0;
  for (int a = 0; a < count; ++a) {
    if (!HasLike(views, a)) continue;
    const auto row = static_cast<std::size_t>(a) * static_cast<std::size_t>(count);
    ++queries;
    if (views.covisibility(a, MostSimilar(cosines.subspan(row), a, count)) >= kSamePlace) ++right;
  }
  return queries == 0 ? 0.0 : static_cast<double>(right) / queries;
}

}  // namespace

PlaceMeasures MeasurePlaces(const PlaceViews& views, std::span<const float> cosines) {
  const auto count = static_cast<std::size_t>(views.count());
  BULLETNAV_CHECK_EQ(cosines.size(), count * count);
  std::vector<Answer> all;
  std::vector<Answer> turned;
  int same = 0;
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const bool is_same =
          views.covisibility(static_cast<int>(a), static_cast<int>(b)) >= kSamePlace;
      const Answer answer = {cosines[a * count + b], is_same};
      all.push_back(answer);
      same += is_same ? 1 : 0;
      const double turn = sim::WrapAngle(views.poses[a].yaw - views.poses[b].yaw);
      if (std::abs(turn) > M_PI / 2) turned.push_back(answer);
    }
  }
  PlaceMeasures measures;
  measures.guessing = static_cast<double>(same) / static_cast<double>(all.size());
  measures.ap = AveragePrecisionOf(std::move(all));
  measures.ap_turned = AveragePrecisionOf(std::move(turned));
  measures.recall_at_1 = RecallAtOne(views, cosines);
  return measures;
}

PlaceMeasures MeanOf(std::span<const PlaceMeasures> measures) {
  BULLETNAV_CHECK(!measures.empty());
  PlaceMeasures mean;
  const auto count = static_cast<double>(measures.size());
  for (const PlaceMeasures& one : measures) {
    mean.ap += one.ap / count;
    mean.guessing += one.guessing / count;
    mean.ap_turned += one.ap_turned / count;
    mean.recall_at_1 += one.recall_at_1 / count;
  }
  return mean;
}

}  // namespace bulletnav::bench
