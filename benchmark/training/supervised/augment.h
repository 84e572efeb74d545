// SPDX-License-Identifier: MIT
#pragma once
#include "benchmark/training/supervised/pair_batch.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {

/// How panoramas are varied while training.
struct AugmentSpec {
  bool turn = true;         // each panorama by a random number of twelfths of a circle
  double brightness = 0.3;  // all channels times 1 - this to 1 + this
  double contrast = 0.2;    // likewise, around middle grey
  double tint = 0.1;        // likewise, each channel by itself

  template <class V>
  void Visit(V& v) {
    v("turn", turn);
    v("brightness", brightness);
    v("contrast", contrast);
    v("tint", tint);
  }
  /// Throws Error.
  void Validate() const;
};

/// Varies each panorama of the batch by itself.
void Augment(const AugmentSpec& spec, sim::Rng rng, PairBatch* batch);

}  // namespace bulletnav::bench
