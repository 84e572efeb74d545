// SPDX-License-Identifier: MIT
#include "benchmark/evaluate_perception/scene_mean.h"

#include <algorithm>
#include <cstddef>

#include "sim/base/check.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

constexpr int kDraws = 1000;
constexpr std::size_t kTail = 25;  // draws beyond either end of the interval

}  // namespace

void SceneMean::Add(double value) {
  BULLETNAV_CHECK(!scenes_.empty());
  scenes_.back().sum += value;
  ++scenes_.back().count;
}

MeanFigure SceneMean::Figure(std::uint64_t seed) const {
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  std::vector<Sum> scenes;
  Sum all;
  for (const Sum& scene : scenes_) {
    if (scene.count > 0) scenes.push_back(scene);
    all.sum += scene.sum;
    all.count += scene.count;
  }
  MeanFigure figure;
  figure.interval = {-kEndless, kEndless};
  if (scenes.empty()) return figure;
  figure.count = all.count;
  figure.value = all.sum / static_cast<double>(all.count);
  if (scenes.size() == 1) return figure;
  sim::Rng rng(seed, "scene mean");
  std::vector<double> means(kDraws);
  for (double& mean : means) {
    Sum drawn;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const Sum& scene = rng.Pick(scenes);
      drawn.sum += scene.sum;
      drawn.count += scene.count;
    }
    mean = drawn.sum / static_cast<double>(drawn.count);
  }
  std::sort(means.begin(), means.end());
  figure.interval = {means[kTail], means[kDraws - 1 - kTail]};
  return figure;
}

}  // namespace bulletnav::bench
