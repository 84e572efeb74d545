// SPDX-License-Identifier: MIT
#include "benchmark/evaluate_perception/relative_pose_figures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "agent/perception/relative_pose.h"
#include "benchmark/evaluate_perception/connection_figures.h"
#include "sim/base/elementary.h"

namespace bulletnav::bench {
namespace {

constexpr std::size_t kNearBins = 4;  // of kDistanceBins, up to 3 m

struct PoseErrors {
  int steps = 0;  // between the right direction and the likeliest
  double bearing_deg = 0.0;
  double distance = 0.0;
  double place = 0.0;
};

PoseErrors ErrorsOf(const SceneCases& cases, int source, int goal) {
  const agent::PairPrediction& said = cases.prediction(source, goal);
  const auto& poses = cases.samples.poses;
  const sim::PlanarPose truth = sim::RelativePose(poses[static_cast<std::size_t>(source)],
                                                  poses[static_cast<std::size_t>(goal)]);
  const agent::RelativeGoal there = agent::RelativePoseOf(said);
  const auto likeliest = static_cast<int>(
      std::max_element(said.direction.begin(), said.direction.end()) - said.direction.begin());
  const int off = std::abs(likeliest - int{cases.samples.pair(source, goal).direction});
  PoseErrors errors;
  errors.steps = std::min(off, agent::kDirections - off);
  errors.bearing_deg =
      sim::RadToDeg(std::abs(sim::WrapAngle(there.bearing - sim::Atan2(truth.y, truth.x))));
  errors.distance = std::abs(double{said.distance} - std::hypot(truth.x, truth.y));
  errors.place = std::hypot(there.distance * sim::Cos(there.bearing) - truth.x,
                            there.distance * sim::Sin(there.bearing) - truth.y);
  return errors;
}

struct PoseSums {
  SceneMean exact;
  SceneMean near;
  SceneMean bearing;
  SceneMean distance;
  SceneMean place;

  void NextScene() {
    for (SceneMean* mean : {&exact, &near, &bearing, &distance, &place}) mean->NextScene();
  }
  void Add(const PoseErrors& errors) {
    exact.Add(errors.steps == 0 ? 1.0 : 0.0);
    near.Add(errors.steps <= 1 ? 1.0 : 0.0);
    bearing.Add(errors.bearing_deg);
    distance.Add(errors.distance);
    place.Add(errors.place);
  }
  RelativePoseFigures::Means Figures(std::uint64_t seed) const {
    return {exact.Figure(seed), near.Figure(seed), bearing.Figure(seed), distance.Figure(seed),
            place.Figure(seed)};
  }
};

double MeanErrorOfMedian(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  const double median = *middle;
  double sum = 0.0;
  for (const double value : values) sum += std::abs(value - median);
  return sum / static_cast<double>(values.size());
}

}  // namespace

RelativePoseFigures MeasureRelativePoses(std::span<const SceneCases> scenes, std::uint64_t seed) {
  PoseSums all;
  std::array<PoseSums, kNearBins> bins;
  std::vector<double> distances;
  for (const SceneCases& cases : scenes) {
    all.NextScene();
    for (PoseSums& bin : bins) bin.NextScene();
    ForEachPair(cases, [&](int source, int goal) {
      const PairLabel& truth = cases.samples.pair(source, goal);
      if (truth.same_node == 0) return;
      const PoseErrors errors = ErrorsOf(cases, source, goal);
      const double distance = double{truth.distance_m()};
      all.Add(errors);
      bins[std::min(DistanceBin(distance), kNearBins - 1)].Add(errors);
      distances.push_back(distance);
    });
  }
  RelativePoseFigures figures;
  figures.all = all.Figures(seed);
  figures.distance_error_of_median = MeanErrorOfMedian(distances);
  for (std::size_t i = 0; i < kNearBins; ++i) {
    figures.by_distance.push_back({DistanceBinName(i), bins[i].Figures(seed)});
  }
  return figures;
}

}  // namespace bulletnav::bench
