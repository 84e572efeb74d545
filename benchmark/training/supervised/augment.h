// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "benchmark/training/supervised/color_jitter.h"
#include "benchmark/training/supervised/pair_batch.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {

/// How panoramas are varied while training. Default: as all trainings before there was sensor
/// noise.
struct AugmentSpec {
  bool turn = true;         // each panorama by a random number of twelfths of a circle
  double brightness = 0.3;  // as in ColorJitter, like the next two
  double contrast = 0.2;
  double tint = 0.1;
  /// Share of the panoramas that get a sensor's noise: any of the named models (sim::SensorNoise),
  /// with panes, at a strength up to `noise_strength`.
  std::optional<double> sensor_noise;    // default: none
  std::optional<double> noise_strength;  // default: 1.5

  template <class V>
  void Visit(V& v) {
    v("turn", turn);
    v("brightness", brightness);
    v("contrast", contrast);
    v("tint", tint);
    v("sensor_noise", sensor_noise);
    v("noise_strength", noise_strength);
  }
  ColorJitter color() const { return {brightness, contrast, tint}; }
  /// Throws Error.
  void Validate() const;
};

/// What a batch's depth is there for: to be seen, or to tell the truth, which noise must not touch.
enum class DepthUse { kInput, kTruth };

/// Varies each panorama of the batch by itself.
void Augment(const AugmentSpec& spec, sim::Rng rng, DepthUse depth, PairBatch* batch);

}  // namespace bulletnav::bench
