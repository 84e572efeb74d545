// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "benchmark/slam/training/place_views.h"

namespace bulletnav::bench {

/// How well descriptors tell places, means over scenes.
struct PlaceMeasures {
  double loss = 0.0;
  double ap = 0.0;         // of all pairs of views of a scene, ranked by cosine; true: kSamePlace
  double guessing = 0.0;   // the share of true ones
  double ap_turned = 0.0;  // of pairs turned by more than 90 degrees
  double recall_at_1 = 0.0;

  template <class V>
  void Visit(V& v) {
    v("loss", loss);
    v("ap", ap);
    v("guessing", guessing);
    v("ap_turned", ap_turned);
    v("recall_at_1", recall_at_1);
  }
};

/// Of one scene, but for the loss; `cosines` [count, count].
PlaceMeasures MeasurePlaces(const PlaceViews& views, std::span<const float> cosines);

/// Means; the loss stays 0. Expects: at least one (checked).
PlaceMeasures MeanOf(std::span<const PlaceMeasures> measures);

}  // namespace bulletnav::bench
