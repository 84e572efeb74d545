// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "benchmark/slam/training/place_config.h"
#include "sim/math/pose.h"
#include "sim/render/renderer.h"
#include "sim/world.h"

namespace bulletnav::bench {

/// Pictures of one scene, some of each place: view v of place p is number p * views + v.
struct PlaceViews {
  int places = 0;
  int views = 0;  // of a place
  int rows = 0;   // of a picture
  int cols = 0;
  std::vector<sim::BodyPose> poses;
  std::vector<std::uint8_t> pictures;  // [count, rows, cols, 3], as ShrinkPicture makes them
  std::vector<std::uint8_t> shared;    // [count, count] covisibility, 255 is all

  int count() const { return places * views; }
  std::size_t picture_size() const {
    return static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols) * 3;
  }
  std::span<const std::uint8_t> picture(int number) const {
    return std::span(pictures).subspan(static_cast<std::size_t>(number) * picture_size(),
                                       picture_size());
  }
  double covisibility(int a, int b) const {
    return shared[static_cast<std::size_t>(a) * static_cast<std::size_t>(count()) +
                  static_cast<std::size_t>(b)] /
           255.0;
  }
};

/// What counts as the same place and as another one; views in between are neither.
inline constexpr double kSamePlace = 0.3;
inline constexpr double kOtherPlace = 0.1;

/// Views are kept so large; networks for smaller pictures average them.
inline constexpr int kViewRows = 96;
inline constexpr int kViewCols = 128;

/// Draws places at random, and of each views that share kSamePlace or more with the first one: from
/// any side from which they can be had, one of them turned by more than 90 degrees where that can
/// be. Every second one is drawn in `changed`, if that is there: other light and colours. The
/// covisibility of all pairs is by depth. A function of the arguments. Throws sim::Error if there
/// is no floor, or if not one place can be seen from several sides.
PlaceViews MakePlaceViews(const sim::World& world, const sim::RenderScene* changed,
                          const PlaceDataConfig& config);

}  // namespace bulletnav::bench
