// SPDX-License-Identifier: MIT
#pragma once
#include "benchmark/slam/training/place_views.h"
#include "sim/math/rng.h"

namespace bulletnav::tests {

/// A scene of places that are a colour each, darker or lighter from view to view.
inline bench::PlaceViews RandomViews(int places, int views, std::uint64_t seed) {
  sim::Rng rng(seed, "views");
  bench::PlaceViews made;
  made.places = places;
  made.views = views;
  made.rows = bench::kViewRows;
  made.cols = bench::kViewCols;
  for (int place = 0; place < places; ++place) {
    const int paint = rng.Between(0, 0xffffff);
    for (int view = 0; view < views; ++view) {
      made.poses.push_back({Eigen::Vector3d(place, 0.0, view), rng.Uniform(-3.0, 3.0)});
      const int light = rng.Between(-20, 20);
      for (int i = 0; i < bench::kViewRows * bench::kViewCols * 3; ++i) {
        const int shade = (paint >> (8 * (i % 3))) % 256 / 2 + light + 40;
        made.pictures.push_back(static_cast<std::uint8_t>(shade));
      }
    }
  }
  const int count = made.count();
  for (int a = 0; a < count; ++a) {
    for (int b = 0; b < count; ++b) made.shared.push_back(a / views == b / views ? 200 : 0);
  }
  return made;
}

}  // namespace bulletnav::tests
