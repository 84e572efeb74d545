// SPDX-License-Identifier: MIT
#include "tests/benchmark/evaluate_perception/fake_cases.h"

#include <cmath>

#include "sim/math/rng.h"

namespace bulletnav::tests {

using agent::kDirections;
using bench::SceneCases;

SceneCases RandomCases(std::uint64_t seed, int places) {
  sim::Rng rng(seed, "fake cases");
  SceneCases cases;
  cases.scene = "fake.glb";
  bench::SceneSamples& samples = cases.samples;
  for (int i = 0; i < places; ++i) {
    samples.poses.push_back(
        {{rng.Uniform(0, 12), 0.0, rng.Uniform(0, 12)}, rng.Uniform(-sim::kPi, sim::kPi)});
    samples.explorable.push_back(static_cast<std::uint16_t>(rng.Next() & rng.Next() & 0xfff));
    bench::SceneSamples::Reach reach{};
    for (auto& r : reach) r = static_cast<std::uint16_t>(rng.Between(0, 300));
    samples.reach.push_back(reach);
  }
  const auto n = samples.poses.size();
  for (const sim::BodyPose& source : samples.poses) {
    for (const sim::BodyPose& goal : samples.poses) {
      bench::PairLabel label = bench::LabelPose(sim::RelativePose(source, goal));
      label.same_node = label.distance_m() < 3.0f && rng.Chance(0.8) ? 1 : 0;
      for (auto& score : label.score) score = static_cast<std::uint8_t>(rng.Below(256));
      samples.pairs.push_back(label);
      cases.walls.push_back(static_cast<std::uint8_t>(rng.Below(6)));
    }
  }
  cases.explorable.resize(n);
  cases.predictions.resize(n * n);
  return cases;
}

void PredictTruth(SceneCases* cases) {
  for (int source = 0; source < cases->count(); ++source) {
    const auto s = static_cast<std::size_t>(source);
    for (int i = 0; i < kDirections; ++i) {
      cases->explorable[s][static_cast<std::size_t>(i)] =
          cases->samples.IsExplorable(source, i) ? 1.0f : 0.0f;
    }
    for (int goal = 0; goal < cases->count(); ++goal) {
      const bench::PairLabel& truth = cases->samples.pair(source, goal);
      agent::PairPrediction& said = cases->prediction(source, goal);
      said.same_node = truth.same_node != 0 ? 0.9f : 0.1f;
      said.direction[truth.direction] = 1.0f;
      said.distance = truth.distance_m();
      for (int i = 0; i < kDirections; ++i) {
        said.score[static_cast<std::size_t>(i)] = truth.far_score(i);
      }
    }
  }
}

void PredictConstant(SceneCases* cases) {
  for (bench::PerDirection& said : cases->explorable) said.fill(0.6f);
  for (agent::PairPrediction& said : cases->predictions) {
    said.same_node = 0.6f;
    said.direction[0] = 1.0f;
    said.distance = 1.5f;
    said.score.fill(0.5f);
  }
}

}  // namespace bulletnav::tests
