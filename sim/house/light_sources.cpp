// SPDX-License-Identifier: MIT
#include "sim/house/light_sources.h"

#include <algorithm>
#include <cmath>

#include "sim/math/pose.h"

namespace bulletnav::sim {
namespace {

using Vec = Eigen::Vector3f;

constexpr float kSkyRadiance = 2.6f;
constexpr float kLampReach = 0.6f;     // parts nearer than this belong to one lamp, metres
constexpr float kLongestPatch = 0.8f;  // windows are cut down to this, metres
constexpr float kFarthest = 9.0f;      // light from farther away is left out, metres
constexpr float kFaintest = 0.0002f;   // light that would not be seen is not looked for
constexpr float kStandOff = 0.12f;     // shadow rays stop short of a lamp's own shade, metres
constexpr auto kPiF = static_cast<float>(kPi);

Vec SkyColor() {
  return {0.97f, 1.0f, 1.04f};
}

Vec LampColor() {
  return {1.05f, 0.99f, 0.90f};
}

}  // namespace

LightSources::LightSources(const SceneMesh& mesh, std::span<const int> glow_of_triangle,
                           float lamp_power) {
  const auto add_all = [&](Glow glow, const auto& add) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (glow_of_triangle[t] != static_cast<int>(glow)) continue;
      const auto& corners = mesh.triangles[t];
      add(mesh.positions[corners[0]], mesh.positions[corners[1]], mesh.positions[corners[2]]);
    }
  };
  add_all(Glow::kSky, [&](const Vec& a, const Vec& b, const Vec& c) {
    AddWindowTriangle(a, b, c, 3);
  });
  windows_ = patches_.size();
  add_all(Glow::kLamp, [&](const Vec& a, const Vec& b, const Vec& c) {
    AddLampPart((a + b + c) / 3.0f, 0.5f * (b - a).cross(c - a).norm());
  });
  for (std::size_t i = windows_; i < patches_.size(); ++i) {
    // Until here a lamp's centre is summed over its area, which power counts.
    patches_[i].centre /= patches_[i].power.x();
    patches_[i].power = lamp_power * LampColor();
  }
}

void LightSources::AddWindowTriangle(const Vec& a, const Vec& b, const Vec& c, int halvings) {
  const float ab = (b - a).norm();
  const float bc = (c - b).norm();
  const float ca = (a - c).norm();
  const float longest = std::max({ab, bc, ca});
  if (halvings > 0 && longest > kLongestPatch) {
    if (longest == ab) {
      AddWindowTriangle(a, 0.5f * (a + b), c, halvings - 1);
      AddWindowTriangle(0.5f * (a + b), b, c, halvings - 1);
    } else if (longest == bc) {
      AddWindowTriangle(a, b, 0.5f * (b + c), halvings - 1);
      AddWindowTriangle(a, 0.5f * (b + c), c, halvings - 1);
    } else {
      AddWindowTriangle(a, b, 0.5f * (a + c), halvings - 1);
      AddWindowTriangle(0.5f * (a + c), b, c, halvings - 1);
    }
    return;
  }
  const Vec n = (b - a).cross(c - a);
  patches_.push_back(
      {(a + b + c) / 3.0f, n.normalized(), 0.5f * n.norm() * kSkyRadiance * SkyColor()});
}

void LightSources::AddLampPart(const Vec& centre, float area) {
  for (std::size_t i = windows_; i < patches_.size(); ++i) {
    LightPatch& lamp = patches_[i];
    if ((lamp.centre / lamp.power.x() - centre).norm() > kLampReach) continue;
    lamp.centre += area * centre;
    lamp.power.array() += area;
    return;
  }
  patches_.push_back({area * centre, Vec::Zero(), Vec::Constant(area)});
}

Vec LightSources::Irradiance(const RayTracer& scene, const Vec& point, const Vec& normal) const {
  Vec sum = Vec::Zero();
  for (const LightPatch& light : patches_) {
    const Vec way = light.centre - point;
    const float squared = way.squaredNorm();
    // A point can be a lamp's centre itself: there is no direction to it.
    if (squared == 0.0f || squared > kFarthest * kFarthest) continue;
    const float distance = std::sqrt(squared);
    const float cosine = normal.dot(way) / distance;
    if (cosine <= 0.0f) continue;
    const bool is_window = !light.normal.isZero();
    const float facing = is_window ? -light.normal.dot(way) / distance : 1.0f;
    if (facing <= 0.0f) continue;
    // Close to a patch the point formula overshoots; its size bounds it.
    const float spread = squared + 0.1f;
    const Vec given = light.power * (cosine * facing / (is_window ? kPiF * spread : spread));
    if (given.y() < kFaintest) continue;
    const float stop = is_window ? 0.02f : std::min(kStandOff, 0.5f * distance);
    if (scene.IsBlocked(point, light.centre - stop / distance * way)) continue;
    sum += given;
  }
  return sum;
}

}  // namespace bulletnav::sim
