// SPDX-License-Identifier: MIT
#include "benchmark/evaluate_perception/wall_count.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace bulletnav::bench {
namespace {

using Eigen::Vector3f;

constexpr float kLow = 1.95f;   // metres above the floor
constexpr float kHigh = 2.32f;  // wardrobes are up to 2.25 m high, ceilings 2.4 m at least
constexpr float kBelowCeiling = 0.05f;
constexpr float kThickest = 0.4f;    // of a wall, across or along the line
constexpr float kStep = 2e-3f;       // past a surface, to find the next one
constexpr float kAround = 0.02f;     // how far off a wall's two heights may begin
constexpr float kSameFacing = 0.9f;  // cosine

struct Surface {
  float at = 0.0f;  // metres along the line
  Vector3f normal = Vector3f::Zero();
};

/// What a wall's surfaces have in common: where the first and the last of them are.
struct Stretch {
  Surface first;
  float end = 0.0f;
};

/// A level line with a place on it for every metre.
class Line {
 public:
  Line(const sim::PhysicsWorld& scene, const Vector3f& from, const Vector3f& to)
      : scene_(scene), from_(from), length_((to - from).norm()), along_((to - from) / length_) {}

  float length() const { return length_; }

  std::vector<Surface> Surfaces() const {
    std::vector<Surface> surfaces;
    float start = 0.0f;
    while (start < length_) {
      const auto hit = scene_.RayTest(At(start), At(length_));
      if (!hit) break;
      const float at = start + hit->fraction * (length_ - start);
      surfaces.push_back({at, hit->normal});
      start = at + kStep;
    }
    return surfaces;
  }

  bool IsBlocked(float begin, float end) const {
    return scene_.RayTest(At(std::max(begin, 0.0f)), At(std::min(end, length_))).has_value();
  }

  /// Whether a surface is the other side, or a moulding, of what begins with `first`.
  bool IsOneWall(const Surface& first, const Surface& other) const {
    const float apart = other.at - first.at;
    if (apart <= kThickest) return true;
    const bool is_parallel = std::abs(first.normal.dot(other.normal)) > kSameFacing;
    return is_parallel && apart * std::abs(first.normal.dot(along_)) <= kThickest;
  }

 private:
  Vector3f At(float metres) const { return from_ + metres * along_; }

  const sim::PhysicsWorld& scene_;
  Vector3f from_;
  float length_;
  Vector3f along_;
};

float HighAbove(const sim::PhysicsWorld& scene, const Vector3f& place) {
  const auto hit = scene.RayTest(place + kLow * Vector3f::UnitY(),
                                 place + (kHigh + kBelowCeiling) * Vector3f::UnitY());
  if (!hit) return kHigh;
  return kLow + hit->fraction * (kHigh + kBelowCeiling - kLow) - kBelowCeiling;
}

}  // namespace

int WallsBetween(const sim::PhysicsWorld& scene, const Eigen::Vector3d& from,
                 const Eigen::Vector3d& to) {
  const Vector3f a = from.cast<float>();
  const Vector3f b = to.cast<float>();
  if ((b - a).norm() < kStep) return 0;
  const float high = std::min(HighAbove(scene, a), HighAbove(scene, b));
  const Vector3f low_up = std::min(kLow, high) * Vector3f::UnitY();
  const Line low(scene, a + low_up, b + low_up);
  const Line over(scene, a + high * Vector3f::UnitY(), b + high * Vector3f::UnitY());
  std::vector<Stretch> stretches;
  for (const Surface& surface : over.Surfaces()) {
    if (stretches.empty() || !over.IsOneWall(stretches.back().first, surface)) {
      stretches.push_back({surface, surface.at});
    }
    stretches.back().end = surface.at;
  }
  return static_cast<int>(
      std::count_if(stretches.begin(), stretches.end(), [&](const Stretch& stretch) {
        return low.IsBlocked(stretch.first.at - kAround, stretch.end + kAround);
      }));
}

}  // namespace bulletnav::bench
