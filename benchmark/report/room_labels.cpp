// SPDX-License-Identifier: MIT
#include "benchmark/report/room_labels.h"

#include <algorithm>
#include <limits>
#include <string>

#include <Eigen/Geometry>

namespace bulletnav::bench {
namespace {

using Point = Eigen::Vector2f;

constexpr float kStep = 0.05f;          // metres
constexpr float kPullToMiddle = 0.05f;  // metres from the walls given up for one nearer to it

float ToSegment(const Point& p, const Point& a, const Point& b) {
  const float length2 = (b - a).squaredNorm();
  const float t = length2 > 0.0f ? std::clamp((p - a).dot(b - a) / length2, 0.0f, 1.0f) : 0.0f;
  return (p - a - t * (b - a)).norm();
}

float ToOutline(const Point& p, std::span<const Point> outline) {
  float nearest = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    nearest = std::min(nearest, ToSegment(p, outline[i], outline[(i + 1) % outline.size()]));
  }
  return nearest;
}

}  // namespace

Point PoleOfInaccessibility(std::span<const Point> outline) {
  Eigen::AlignedBox2f box;
  for (const Point& p : outline) box.extend(p);
  const Point middle = box.center();
  const Eigen::Vector2i half = (box.sizes() / (2.0f * kStep)).cast<int>();
  Point best = outline.front();
  float best_score = -std::numeric_limits<float>::infinity();
  for (int y = -half.y(); y <= half.y(); ++y) {
    for (int x = -half.x(); x <= half.x(); ++x) {
      const Point p = middle + kStep * Eigen::Vector2i(x, y).cast<float>();
      if (!sim::IsInside(outline, p)) continue;
      const float score = ToOutline(p, outline) - kPullToMiddle * (p - middle).norm();
      if (score <= best_score) continue;
      best_score = score;
      best = p;
    }
  }
  return best;
}

const sim::Room* RoomAt(const sim::FloorPlan& plan, const sim::PlanPoint& point) {
  for (const sim::Room& room : plan.rooms) {
    if (sim::IsInside(room.outline, point)) return &room;
  }
  return nullptr;
}

std::vector<MapLabel> RoomLabels(const sim::FloorPlan& plan) {
  std::vector<MapLabel> labels;
  for (const sim::Room& room : plan.rooms) {
    std::string text(sim::NameOf(room.type));
    std::replace(text.begin(), text.end(), '_', ' ');
    labels.push_back({std::move(text), PoleOfInaccessibility(room.outline), room.outline});
  }
  return labels;
}

}  // namespace bulletnav::bench
