// SPDX-License-Identifier: MIT
#include "tests/benchmark/training/supervised/bar_world.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "agent/models/semantic_model.h"
#include "sim/math/pose.h"

namespace bulletnav::tests {
namespace {

using agent::kDirections;

constexpr int kRows = 128;
constexpr int kCols = 512;
constexpr double kPillarRadius = 0.6;

struct Pillar {
  double x;
  double y;
  std::array<std::uint8_t, 3> color;
};
constexpr std::array<Pillar, 4> kPillars = {{{4.5, 3.5, {230, 20, 20}},
                                             {-3.5, 4.5, {20, 220, 20}},
                                             {-4.5, -3.5, {30, 30, 240}},
                                             {3.5, -4.5, {240, 230, 20}}}};

double BearingTo(const Stand& from, double x, double y) {
  return sim::WrapAngle(std::atan2(y - from.y, x - from.x) - from.heading);
}

std::int8_t Direction(double bearing) {
  const long nearest = std::lround(bearing / (2.0 * sim::kPi) * kDirections);
  return static_cast<std::int8_t>((nearest + kDirections) % kDirections);
}

void Draw(const Stand& stand, int index, bench::PairBatch* batch) {
  for (int c = 0; c < kCols; ++c) {
    const double bearing = sim::kPi - 2.0 * sim::kPi * (c + 0.5) / kCols;
    std::array<std::uint8_t, 3> color = {120, 120, 120};
    float depth = 10.0f;
    for (const Pillar& pillar : kPillars) {
      const double distance = std::hypot(pillar.x - stand.x, pillar.y - stand.y);
      const double off = sim::WrapAngle(BearingTo(stand, pillar.x, pillar.y) - bearing);
      if (std::abs(off) > std::atan2(kPillarRadius, distance)) continue;
      color = pillar.color;
      depth = static_cast<float>(distance);
    }
    for (int r = 0; r < kRows; ++r) {
      const auto pixel = static_cast<std::size_t>((index * kRows + r) * kCols + c);
      std::copy(color.begin(), color.end(),
                batch->color.begin() + static_cast<std::ptrdiff_t>(3 * pixel));
      batch->depth[pixel] = depth;
    }
  }
}

void Label(const std::vector<Stand>& stands, std::size_t a, std::size_t b,
           bench::PairBatch* batch) {
  const Stand& source = stands[a];
  const Stand& goal = stands[b];
  const std::size_t pair = a * stands.size() + b;
  const double distance = std::hypot(goal.x - source.x, goal.y - source.y);
  batch->same_node[pair] = distance < agent::kNodeRadius;
  batch->direction[pair] = a == b ? std::int8_t{-1} : Direction(BearingTo(source, goal.x, goal.y));
  batch->distance_score[pair] =
      static_cast<float>(std::max(0.0, 1.0 - distance / agent::kNodeRadius));
  for (std::size_t i = 0; i < kDirections; ++i) {
    const double way = source.heading + 2.0 * sim::kPi * static_cast<double>(i) / kDirections;
    const double left = std::hypot(source.x + 3.0 * std::cos(way) - goal.x,
                                   source.y + 3.0 * std::sin(way) - goal.y);
    batch->scores[pair * kDirections + i] =
        static_cast<float>(std::max(0.0, 1.0 - left / agent::kFarthestScored));
  }
}

}  // namespace

bench::PairBatch BarBatch(const std::vector<Stand>& stands) {
  const std::size_t n = stands.size();
  bench::PairBatch batch;
  batch.count = static_cast<int>(n);
  batch.color.resize(n * kRows * kCols * 3);
  batch.depth.resize(n * kRows * kCols);
  batch.explorable.assign(n * kDirections, 1);
  batch.same_node.resize(n * n);
  batch.direction.resize(n * n);
  batch.distance_score.resize(n * n);
  batch.scores.resize(n * n * kDirections);
  for (std::size_t a = 0; a < n; ++a) {
    Draw(stands[a], static_cast<int>(a), &batch);
    const auto red = Direction(BearingTo(stands[a], kPillars[0].x, kPillars[0].y));
    batch.explorable[a * kDirections + static_cast<std::size_t>(red)] = 0;
    for (std::size_t b = 0; b < n; ++b) Label(stands, a, b, &batch);
  }
  return batch;
}

bench::PairBatch BarSource::Batch(std::uint64_t number) const {
  sim::Rng rng = sim::Rng(seed_, "bars").Fork("batch", number);
  std::vector<Stand> stands(static_cast<std::size_t>(count_));
  for (Stand& stand : stands) {
    stand = {rng.Uniform(-2.8, 2.8), rng.Uniform(-2.8, 2.8), rng.Uniform(-sim::kPi, sim::kPi)};
  }
  return BarBatch(stands);
}

}  // namespace bulletnav::tests
