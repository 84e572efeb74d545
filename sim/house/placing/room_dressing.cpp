// SPDX-License-Identifier: MIT
// What lies on the floor, stands on furniture, hangs on walls and from the ceiling.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/house/placing/frames.h"
#include "sim/house/placing/room_furnisher.h"
#include "sim/house/shell/faces.h"

namespace bulletnav::sim::placing {
namespace {

using Vec = Eigen::Vector3f;

constexpr float kEyeHeight = 1.5f;
constexpr float kOnWallGap = 0.003f;
constexpr float kHangStep = 0.15f;  // between places tried along a wall
constexpr float kLampSpacing = 3.6f;
constexpr float kQuarter = 0.5f * std::numbers::pi_v<float>;

}  // namespace

void RoomFurnisher::Rug(std::string_view kind, const PlanPoint& centre, float width, bool turned) {
  constexpr float kNarrower = 0.3f;
  const int attempts = 1 + static_cast<int>(0.5f * width / kNarrower);
  for (int i = 0; i < attempts; ++i) {
    const Draft draft = Build(kind, {width - kNarrower * static_cast<float>(i), 0.0f});
    const Eigen::Affine3f pose = Moved(centre.x(), 0.0f, centre.y(), turned ? kQuarter : 0.0f);
    const Rect foot = FootOf(Transformed(draft.bounds, pose));
    const bool lies_on_other = std::any_of(rugs_.begin(), rugs_.end(), [&](const Rect& other) {
      return other.intersects(foot);
    });
    if (lies_on_other || space_.MeetsPit(foot)) return;
    if (!space_.Contains(foot)) continue;
    Show(draft, pose);
    rugs_.push_back(foot);
    return;
  }
}

bool RoomFurnisher::OnTop(const Placed& piece, std::string_view kind) {
  if (piece.tops.empty()) return false;
  const Draft draft = Build(kind);
  for (int attempt = 0; attempt < 8; ++attempt) {
    const TopSurface& top = attempt < 4 ? piece.tops.front() : rng_.Pick(piece.tops);
    const auto turn = static_cast<float>(rng_.Normal() * 0.3);
    const Box turned = Transformed(draft.bounds, Moved(0.0f, 0.0f, 0.0f, turn));
    const Eigen::Vector2f room = top.area.sizes() - FootOf(turned).sizes();
    if (room.minCoeff() < 0.0f) continue;
    const PlanPoint at = top.area.min() + 0.5f * FootOf(turned).sizes() +
                         PlanPoint(rng_.Uniform() * room.x(), rng_.Uniform() * room.y());
    const Eigen::Affine3f local = Moved(at.x(), top.height, at.y(), turn);
    const Rect foot = FootOf(Transformed(draft.bounds, local));
    const bool hits = std::any_of(on_tops_.begin(), on_tops_.end(), [&](const auto& other) {
      return other.first == &piece && other.second.intersects(foot);
    });
    if (hits) continue;
    on_tops_.emplace_back(&piece, foot);
    Show(draft, piece.pose * local);
    return true;
  }
  return false;
}

void RoomFurnisher::OnTops(const Placed& piece, std::span<const std::string_view> kinds, int most) {
  std::vector<std::string_view> order(kinds.begin(), kinds.end());
  rng_.Shuffle(order);
  int count = 0;
  for (const std::string_view kind : order) {
    if (count >= most) return;
    if (OnTop(piece, kind)) ++count;
  }
}

bool RoomFurnisher::Hang(const Draft& draft, const Eigen::Affine3f& pose) {
  const Box box = Transformed(draft.bounds, pose);
  const bool fits = space_.Contains(FootOf(box)) && space_.IsFree(box) &&
                    space_.HasWallBehind(box) && !space_.HidesOpening(box) &&
                    box.max().y() < space_.ceiling() - 0.05f;
  if (!fits) return false;
  if (box.min().y() < 1.7f && draft.bounds.sizes().z() > 0.1f) {
    if (space_.MeetsDoorway(FootOf(box)) || !space_.LeavesWayPast(box)) return false;
  }
  Placed placed{draft.kind, pose, draft.bounds.sizes(), box, {}, draft.bounds, Show(draft, pose)};
  space_.Add(box, std::nullopt);
  placed_.push_back(std::move(placed));
  return true;
}

const Placed* RoomFurnisher::Over(const Placed& piece, std::string_view kind, float above) {
  const Draft draft = Build(kind);
  const Eigen::Affine3f pose = piece.pose * Moved(0.0f, piece.size.y() + above, kOnWallGap - 0.02f);
  return Hang(draft, pose) ? &placed_.back() : nullptr;
}

const Placed* RoomFurnisher::OnWall(std::string_view kind, float low, const Wish& wish) {
  const Draft draft = Build(kind, {wish.width, wish.height});
  const float y = low > 0.0f ? low : kEyeHeight - 0.5f * draft.bounds.sizes().y();
  std::vector<Candidate> candidates;
  for (const shell::Side& side : space_.sides()) {
    const float half = 0.5f * draft.bounds.sizes().x() + 0.08f;
    const Eigen::Affine3f face = shell::FaceFrame(side.left, side.right);
    const int steps = static_cast<int>(std::floor((side.length() - 2.0f * half) / kHangStep));
    for (int i = 0; i <= steps; ++i) {
      const float s = half + kHangStep * static_cast<float>(i);
      const Eigen::Affine3f pose = face * Moved(s, y, kOnWallGap);
      const double off = std::abs(2.0 * s / side.length() - 1.0);
      candidates.push_back({pose, 0.4 * (1.0 - off) + 3.0 * Score(draft, pose, wish)});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) {
                     return a.score > b.score;
                   });
  for (const Candidate& candidate : candidates) {
    if (Hang(draft, candidate.pose)) return &placed_.back();
  }
  return nullptr;
}

void RoomFurnisher::DressWindow(const shell::Side& side, const shell::Hole& window, bool curtain) {
  const float width = window.x1 - window.x0;
  const float middle = 0.5f * (window.x0 + window.x1);
  const Eigen::Affine3f face = shell::FaceFrame(side.left, side.right);
  const float top = std::min(window.top + 0.14f, space_.ceiling() - 0.06f);
  const auto hang = [&](std::string_view kind, float w, float height) {
    const Draft draft = Build(kind, {w, height});
    const Eigen::Affine3f pose =
        face * Moved(middle, top - draft.bounds.max().y(), kOnWallGap + 0.01f);
    const Box box = Transformed(draft.bounds, pose);
    if (!space_.Contains(FootOf(box)) || !space_.IsFree(box)) return false;
    Show(draft, pose);
    space_.Add(box, std::nullopt);
    return true;
  };
  if (curtain) {
    const float floor = top - 0.02f;
    const float sill = top - window.bottom + 0.12f;
    for (const auto& [drop, more] :
         {std::pair{floor, 0.55f}, {floor, 0.3f}, {sill, 0.55f}, {sill, 0.3f}}) {
      if (hang("curtain", width + more, drop)) return;
    }
  }
  // Blinds are rarely all the way down.
  const auto share = static_cast<float>(rng_.Uniform(0.2, rng_.Chance(0.2) ? 1.0 : 0.55));
  hang("blind", width + 0.06f, share * (top - window.bottom));
}

void RoomFurnisher::DressWindows(bool curtains) {
  for (const shell::Side& side : space_.sides()) {
    for (const shell::Hole& hole : side.holes) {
      if (hole.bottom >= 0.0f) DressWindow(side, hole, curtains);
    }
  }
}

void RoomFurnisher::Radiators() {
  for (const shell::Side& side : space_.sides()) {
    for (const shell::Hole& hole : side.holes) {
      if (hole.bottom < 0.75f) continue;
      const Draft draft = Build("radiator", {0.8f * (hole.x1 - hole.x0), 0.0f});
      const Eigen::Affine3f pose =
          shell::FaceFrame(side.left, side.right) * Moved(0.5f * (hole.x0 + hole.x1), 0.0f, 0.02f);
      if (Fits(draft, pose, {false, false})) Place(draft, pose, false);
    }
  }
}

void RoomFurnisher::Light(std::string_view kind, const Placed* over) {
  const Rect& floor = space_.main_floor();
  PlanPoint middle = floor.center();
  int count = 1;
  if (over != nullptr) {
    middle = FootOf(over->box).center();
  } else {
    count = std::max(1, static_cast<int>(std::lround(floor.sizes().maxCoeff() / kLampSpacing)));
  }
  const bool along_x = floor.sizes().x() > floor.sizes().y();
  const std::uint64_t same = built_;
  for (int i = 0; i < count; ++i) {
    built_ = same;
    const Draft draft = Build(kind);
    PlanPoint at = middle;
    const float share = (static_cast<float>(i) + 0.5f) / static_cast<float>(count) - 0.5f;
    at[along_x ? 0 : 1] += share * floor.sizes().maxCoeff();
    const Eigen::Affine3f pose = Moved(at.x(), space_.ceiling(), at.y(), along_x ? 0.0f : kQuarter);
    const Box box = Transformed(draft.bounds, pose);
    if (!space_.Contains(FootOf(box)) || !space_.IsFree(box)) continue;
    Show(draft, pose);
    space_.Add(box, std::nullopt);
  }
}

bool RoomFurnisher::HangAt(std::string_view kind, const PlanPoint& at, float turn) {
  const Draft draft = Build(kind);
  const Eigen::Affine3f pose = Moved(at.x(), space_.ceiling(), at.y(), turn);
  const Box box = Transformed(draft.bounds, pose);
  if (!space_.Contains(FootOf(box)) || !space_.IsFree(box)) return false;
  Show(draft, pose);
  space_.Add(box, std::nullopt);
  return true;
}

void RoomFurnisher::HangInCorner(std::string_view kind) {
  for (const shell::Side& side : space_.sides()) {
    if (!side.left_is_hollow) continue;
    const Draft draft = Build(kind);
    const float out = 0.5f * draft.bounds.sizes().x() + 0.12f;
    const Eigen::Affine3f pose =
        shell::FaceFrame(side.left, side.right) * Moved(out, space_.ceiling(), out);
    if (!Fits(draft, pose, {})) continue;
    if (!space_.LeavesWayPast(Transformed(draft.bounds, pose))) continue;
    Place(draft, pose, false);
    return;
  }
}

}  // namespace bulletnav::sim::placing
