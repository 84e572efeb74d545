// SPDX-License-Identifier: MIT
#pragma once
#include <initializer_list>
#include <vector>

#include "sim/house/furniture.h"

namespace bulletnav::sim::furniture {

using Vec = MeshBuilder::Vec;
using Vec2 = MeshBuilder::Vec2;
using Frame = MeshBuilder::Frame;

/// What the catalogue's build functions work with: a mesh builder together with the draws, the
/// colours and the request of one piece, and the tops that it offers.
class PieceMaker : public MeshBuilder {
 public:
  PieceMaker(const Rng& rng, const Palette& palette, const PieceRequest& request)
      : rng_(rng), palette_(palette), request_(request) {}

  const Palette& palette() const { return palette_; }
  const PieceRequest& request() const { return request_; }
  Rng& rng() { return rng_; }

  float Draw(float low, float high) { return static_cast<float>(rng_.Uniform(low, high)); }
  /// Both in turn: the order in which a call's arguments are drawn would be the compiler's choice.
  Vec2 Draw(const Vec2& low, const Vec2& high) {
    const float x = Draw(low.x(), high.x());
    return {x, Draw(low.y(), high.y())};
  }
  bool Chance(double p) { return rng_.Chance(p); }
  int Below(int n) { return rng_.Below(n); }
  int Between(int low, int high) { return rng_.Between(low, high); }

  /// The width asked for, less what the piece adds to it at its sides, or one drawn from the usual.
  float Width(float low, float high, float overhang = 0.0f) {
    const float drawn = Draw(low, high);  // always, so that the rest does not hang on the request
    return request_.width > 0.0f ? request_.width - overhang : drawn;
  }
  /// Whether a part that reaches up to `height` may be added.
  bool Fits(float height) const { return request_.height <= 0.0f || height <= request_.height; }

  /// Small things can stand here; in the piece's frame, whatever the frame now.
  void AddTop(float height, const Vec2& low, const Vec2& high) {
    tops_.push_back({height, Eigen::AlignedBox2f(low, high)});
  }
  const std::vector<TopSurface>& tops() const { return tops_; }

  /// Lathe with the profile written in place.
  void Turn(const Surface& surface, const Vec& at, std::initializer_list<Vec2> profile,
            int sides = 10) {
    Lathe(surface, at, {profile.begin(), profile.size()}, sides);
  }

 private:
  Rng rng_;
  const Palette& palette_;
  PieceRequest request_;
  std::vector<TopSurface> tops_;
};

}  // namespace bulletnav::sim::furniture
