// SPDX-License-Identifier: MIT
#include "sim/house/placing/room_furnisher.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/house/placing/frames.h"
#include "sim/house/shell/faces.h"

namespace bulletnav::sim::placing {
namespace {

using Vec = Eigen::Vector3f;

constexpr float kWallGap = 0.02f;  // leaves room for baseboards
constexpr float kStep = 0.1f;      // between places tried along a wall
constexpr float kSeatOut = 0.08f;  // from a table's edge to the middle of the seat
constexpr float kTurn = std::numbers::pi_v<float>;
constexpr std::uint64_t kAlike = 1'000'000;  // no room has that many pieces

/// Whole steps in a length; negative if there is no room at all.
int StepsWithin(float length) {
  return static_cast<int>(std::floor(length / kStep));
}

PlanPoint Middle(const Box& box) {
  return FootOf(box).center();
}

PlanPoint FrontOf(const Eigen::Affine3f& pose) {
  const Vec z = pose.linear().col(2);
  return {z.x(), z.z()};
}

/// 1 if it looks straight at the other and is in line with it, less if not.
double Facing(const Eigen::Affine3f& pose, const Box& box, const Placed& other) {
  const PlanPoint way = Middle(other.box) - Middle(box);
  const float opposed = -FrontOf(pose).dot(FrontOf(other.pose));
  const float aside = std::abs(way.x() * FrontOf(pose).y() - way.y() * FrontOf(pose).x());
  const float distance = way.norm();
  const float too_far = std::max(0.0f, distance - 4.2f) + 2.0f * std::max(0.0f, 2.2f - distance);
  return opposed - 0.8f * aside - 0.4f * too_far;
}

}  // namespace

RoomFurnisher::Draft RoomFurnisher::Build(std::string_view kind, const PieceRequest& request) {
  Draft draft;
  draft.kind = &FindFurniture(kind);
  const std::uint64_t number = alike_ ? kAlike : built_++;
  draft.piece = BuildPiece(*draft.kind, rng_.Fork(kind, number), style_.palette, request);
  draft.bounds = draft.piece.mesh.Bounds();
  return draft;
}

std::string RoomFurnisher::Show(const Draft& draft, const Eigen::Affine3f& pose) {
  const MeshBuilder::Frame frame(builder_, pose);
  std::string name = builder_->BeginObject(draft.kind->name, space_.room().name).name;
  builder_->Append(draft.piece.mesh);
  return name;
}

std::optional<Rect> RoomFurnisher::ClearanceOf(const Draft& draft,
                                               const Eigen::Affine3f& pose) const {
  const float wanted = draft.kind->clearance;
  if (wanted <= 0.0f) return std::nullopt;
  Box zone = draft.bounds;
  if (draft.kind->placement == Placement::kFree) {
    zone.min() -= Vec(wanted, 0.0f, wanted);
    zone.max() += Vec(wanted, 0.0f, wanted);
  } else {
    zone.min().z() = zone.max().z();
    zone.max().z() += wanted;
  }
  return FootOf(Transformed(zone, pose));
}

bool RoomFurnisher::Fits(const Draft& draft, const Eigen::Affine3f& pose,
                         const Rules& rules) const {
  const Box box = Transformed(draft.bounds, pose);
  const Rect foot = FootOf(box);
  if (!space_.Contains(foot) || !space_.IsFree(box) || space_.HidesOpening(box)) return false;
  if (box.max().y() > space_.ceiling()) return false;
  if (rules.minds_doorways && box.min().y() < 1.7f && space_.MeetsDoorway(foot)) return false;
  if (rules.minds_clearance && space_.MeetsClearance(foot)) return false;
  if (!rules.keeps_clearance) return true;
  const std::optional<Rect> clearance = ClearanceOf(draft, pose);
  if (!clearance) return true;
  const bool is_front = draft.kind->placement != Placement::kFree;
  // The free floor of pieces in the open is for chairs: walls may be near.
  if (is_front && !space_.Contains(*clearance)) return false;
  const Vec low(clearance->min().x(), 0.1f, clearance->min().y());
  const Vec high(clearance->max().x(), 1.5f, clearance->max().y());
  return !is_front || space_.IsFree({low, high});
}

const Placed* RoomFurnisher::Place(const Draft& draft, const Eigen::Affine3f& pose,
                                   bool keeps_clearance) {
  Placed placed{
      draft.kind,       pose,         draft.bounds.sizes(), Transformed(draft.bounds, pose),
      draft.piece.tops, draft.bounds, Show(draft, pose)};
  const auto clearance = keeps_clearance ? ClearanceOf(draft, pose) : std::nullopt;
  space_.Add(placed.box, clearance);
  placed_.push_back(std::move(placed));
  return &placed_.back();
}

const Placed* RoomFurnisher::PlaceBest(const Draft& draft, std::vector<Candidate> candidates,
                                       bool keeps_clearance, std::string_view seat) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) {
                     return a.score > b.score;
                   });
  constexpr std::size_t kMostTried = 12;
  for (std::size_t i = 0; i < std::min(kMostTried, candidates.size()); ++i) {
    if (!space_.LeavesWayPast(Transformed(draft.bounds, candidates[i].pose))) continue;
    if (!HasSeat(draft, candidates[i].pose, keeps_clearance, seat)) continue;
    return Place(draft, candidates[i].pose, keeps_clearance);
  }
  return nullptr;
}

bool RoomFurnisher::HasSeat(const Draft& draft, const Eigen::Affine3f& pose, bool keeps_clearance,
                            std::string_view seat) const {
  if (seat.empty()) return true;
  return Try([&](RoomFurnisher* copy) {
    return copy->SeatAt(*copy->Place(draft, pose, keeps_clearance), seat) != nullptr;
  });
}

double RoomFurnisher::Score(const Draft& draft, const Eigen::Affine3f& pose, const Wish& wish) {
  const Box box = Transformed(draft.bounds, pose);
  double score = rng_.Uniform(0.0, 0.25);
  if (wish.near != nullptr) score -= (Middle(wish.near->box) - Middle(box)).norm();
  if (wish.beside != nullptr) score -= FootOf(box).exteriorDistance(*wish.beside);
  if (wish.facing != nullptr) score += 2.0 * Facing(pose, box, *wish.facing);
  if (wish.far_from_doors) {
    double nearest = 4.0;
    for (const PlanPoint& mouth : space_.mouths()) {
      nearest = std::min<double>(nearest, FootOf(box).exteriorDistance(mouth));
    }
    score += 0.5 * nearest;
  }
  return score;
}

void RoomFurnisher::AddWallCandidates(const Draft& draft, const shell::Side& side, const Wish& wish,
                                      const Rules& rules, std::vector<Candidate>* candidates) {
  const float half = 0.5f * draft.bounds.sizes().x();
  const float low = half + (side.left_is_hollow ? kWallGap : 0.0f);
  const float high = side.length() - half - (side.right_is_hollow ? kWallGap : 0.0f);
  if (high < low) return;
  const Eigen::Affine3f face = shell::FaceFrame(side.left, side.right);
  const auto try_at = [&](float s, double bonus) {
    const Eigen::Affine3f pose = face * Moved(s, 0.0f, kWallGap);
    if (!Fits(draft, pose, rules)) return;
    candidates->push_back({pose, bonus + Score(draft, pose, wish)});
  };
  const double in_middle = wish.anchor == Anchor::kCentre ? 1.0 : 0.1;
  const double at_end = wish.anchor == Anchor::kEnd ? 1.0 : 0.3;
  try_at(low, at_end);
  try_at(high, at_end);
  const int steps = std::max(1, static_cast<int>((high - low) / kStep));
  for (int i = 1; i < steps; ++i) {
    const float s = low + (high - low) * static_cast<float>(i) / static_cast<float>(steps);
    const double off = std::abs(2.0 * s / side.length() - 1.0);
    try_at(s, in_middle * (1.0 - off));
  }
}

const Placed* RoomFurnisher::AgainstWall(std::string_view kind, const Wish& wish) {
  constexpr float kNarrower = 0.2f;
  const float most = wish.min_width > 0.0f ? wish.width - wish.min_width : 0.0f;
  const int attempts = 1 + static_cast<int>(most / kNarrower + 1e-3f);
  for (int i = 0; i < attempts; ++i) {
    const Draft draft = Build(kind, {wish.width - kNarrower * static_cast<float>(i), wish.height});
    if (const Placed* placed = PlaceAtWall(draft, wish, {})) return placed;
    const bool is_last = i + 1 == attempts;
    if (is_last && wish.squeeze) return PlaceAtWall(draft, wish, {true, false, false});
  }
  return nullptr;
}

const Placed* RoomFurnisher::PlaceAtWall(const Draft& draft, const Wish& wish, const Rules& rules) {
  std::vector<Candidate> candidates;
  for (const shell::Side& side : space_.sides()) {
    AddWallCandidates(draft, side, wish, rules, &candidates);
  }
  return PlaceBest(draft, std::move(candidates), rules.keeps_clearance, wish.seat);
}

const Placed* RoomFurnisher::Alongside(std::string_view kind) {
  const Draft draft = Build(kind);
  const float half = 0.5f * draft.bounds.sizes().x();
  std::vector<Candidate> candidates;
  for (const shell::Side& side : space_.sides()) {
    const Eigen::Affine3f face = shell::FaceFrame(side.left, side.right);
    for (const bool head_left : {true, false}) {
      const float s = head_left ? kWallGap : side.length() - kWallGap;
      const float turn = head_left ? 0.5f * kTurn : -0.5f * kTurn;
      const Eigen::Affine3f pose = face * Moved(s, 0.0f, half + kWallGap, turn);
      if (!Fits(draft, pose, {true, false})) continue;
      candidates.push_back({pose, Score(draft, pose, {.far_from_doors = true})});
    }
  }
  return PlaceBest(draft, std::move(candidates), false);
}

const Placed* RoomFurnisher::AgainstWallWithSeat(std::string_view kind, std::string_view chair,
                                                 Wish wish) {
  wish.seat = chair;
  const Placed* piece = AgainstWall(kind, wish);
  if (piece != nullptr) SeatAt(*piece, chair);
  return piece;
}

const Placed* RoomFurnisher::AtWall(const shell::Side& side, float x, std::string_view kind,
                                    const Wish& wish) {
  const Draft draft = Build(kind, {wish.width, wish.height});
  const Eigen::Affine3f pose = shell::FaceFrame(side.left, side.right) * Moved(x, 0.0f, kWallGap);
  if (!Fits(draft, pose, {false, true})) return nullptr;
  if (!space_.LeavesWayPast(Transformed(draft.bounds, pose))) return nullptr;
  return Place(draft, pose, true);
}

const Placed* RoomFurnisher::NearWall(std::string_view kind, const Wish& wish) {
  const Draft draft = Build(kind, {wish.width, wish.height});
  // Pieces that stand free are centred on their middle: move the back to the wall.
  const float back = -draft.bounds.min().z();
  const float half = 0.5f * draft.bounds.sizes().x() + 0.03f;
  std::vector<Candidate> candidates;
  for (const shell::Side& side : space_.sides()) {
    const Eigen::Affine3f face = shell::FaceFrame(side.left, side.right);
    const int steps = StepsWithin(side.length() - 2.0f * half);
    for (int i = 0; i <= steps; ++i) {
      const float s = half + kStep * static_cast<float>(i);
      const Eigen::Affine3f pose = face * Moved(s, 0.0f, back + 0.04f);
      if (!Fits(draft, pose, {true, false})) continue;
      const double at_end = i == 0 || i == steps ? 0.5 : 0.0;
      candidates.push_back({pose, at_end + Score(draft, pose, wish)});
    }
  }
  return PlaceBest(draft, std::move(candidates));
}

const Placed* RoomFurnisher::InCorner(std::string_view kind) {
  const Draft draft = Build(kind);
  std::vector<Candidate> candidates;
  for (const shell::Side& side : space_.sides()) {
    if (!side.left_is_hollow) continue;
    const float s = 0.5f * draft.bounds.sizes().x() + kWallGap;
    const Eigen::Affine3f pose = shell::FaceFrame(side.left, side.right) * Moved(s, 0.0f, kWallGap);
    if (Fits(draft, pose, {})) candidates.push_back({pose, Score(draft, pose, {})});
  }
  return PlaceBest(draft, std::move(candidates));
}

const Placed* RoomFurnisher::InTheOpen(std::string_view kind, const Wish& wish) {
  const Draft draft = Build(kind, {wish.width, wish.height});
  const PlanPoint target =
      wish.near != nullptr ? Middle(wish.near->box) : space_.main_floor().center();
  Rect bounds;
  for (const PlanPoint& p : space_.room().outline) bounds.extend(p);
  const bool is_long = bounds.sizes().x() > bounds.sizes().y();
  const int cols = StepsWithin(bounds.sizes().x());
  const int cells = cols * StepsWithin(bounds.sizes().y());
  std::vector<Candidate> candidates;
  for (const float turn : {0.0f, 0.5f * kTurn}) {
    // Long pieces lie along long rooms.
    const double along = (turn == 0.0f) == is_long ? 0.3 : 0.0;
    for (int cell = 0; cell < cells; ++cell) {
      const int row = cell / cols;
      const PlanPoint at = bounds.min() + kStep * PlanPoint(static_cast<float>(cell % cols),
                                                            static_cast<float>(row));
      const Eigen::Affine3f pose = Moved(at.x(), 0.0f, at.y(), turn);
      if (!Fits(draft, pose, {})) continue;
      candidates.push_back({pose, along - (at - target).norm()});
    }
  }
  return PlaceBest(draft, std::move(candidates));
}

const Placed* RoomFurnisher::AtPlace(std::string_view kind, const PlanPoint& at, float turn,
                                     const Wish& wish) {
  const Draft draft = Build(kind, {wish.width, wish.height});
  const Eigen::Affine3f pose = Moved(at.x(), 0.0f, at.y(), turn);
  if (!Fits(draft, pose, {.minds_clearance = false, .keeps_clearance = false})) return nullptr;
  if (!space_.LeavesWayPast(Transformed(draft.bounds, pose))) return nullptr;
  return Place(draft, pose, false);
}

const Placed* RoomFurnisher::At(const Placed& other, std::string_view kind, const Offset& offset,
                                const Wish& wish) {
  const Draft draft = Build(kind, {wish.width, wish.height});
  const Eigen::Affine3f pose = other.pose * Moved(offset.x, 0.0f, offset.z, offset.turn);
  if (!Fits(draft, pose, {false, false})) return nullptr;
  if (!space_.LeavesWayPast(Transformed(draft.bounds, pose))) return nullptr;
  return Place(draft, pose, false);
}

const Placed* RoomFurnisher::Beside(const Placed& other, std::string_view kind, bool left,
                                    float gap) {
  const std::uint64_t same = built_;
  const Draft probe = Build(kind);
  built_ = same;
  const float by = 0.5f * (other.size.x() + probe.bounds.sizes().x()) + gap;
  const bool is_centred = probe.kind->placement == Placement::kFree;
  const float z = is_centred ? 0.5f * probe.bounds.sizes().z() : 0.0f;
  return At(other, kind, {left ? by : -by, z, 0.0f});
}

const Placed* RoomFurnisher::Before(const Placed& other, std::string_view kind, float gap,
                                    bool turned) {
  const std::uint64_t same = built_;
  const Draft probe = Build(kind);
  built_ = same;
  const float depth = probe.bounds.sizes().z();
  const bool is_centred = probe.kind->placement == Placement::kFree;
  const bool other_is_centred = other.kind->placement == Placement::kFree;
  const float front = other_is_centred ? 0.5f * other.size.z() : other.size.z();
  const float z = front + gap + (is_centred ? 0.5f * depth : (turned ? depth : 0.0f));
  return At(other, kind, {0.0f, z, turned ? kTurn : 0.0f});
}

const Placed* RoomFurnisher::SeatAt(const Placed& desk, std::string_view chair, float gap) {
  if (const Placed* seat = At(desk, chair, {0.0f, desk.size.z() + gap, kTurn})) return seat;
  const bool is_under = PlaceChair(desk, chair, {0.0f, desk.size.z() + kSeatOut, kTurn});
  return is_under ? &placed_.back() : nullptr;
}

std::vector<std::string_view> RoomFurnisher::kinds() const {
  std::vector<std::string_view> kinds;
  for (const Placed& placed : placed_) kinds.push_back(placed.kind->name);
  return kinds;
}

bool RoomFurnisher::PlaceChair(const Placed& table, std::string_view chair, const Offset& seat) {
  const Draft draft = Build(chair);
  const float pulled = rng_.Chance(0.25) ? static_cast<float>(rng_.Uniform(0.05, 0.25)) : 0.0f;
  const float skew = rng_.Chance(0.3) ? static_cast<float>(rng_.Normal() * 0.15) : 0.0f;
  const Eigen::Affine3f pose =
      table.pose * Moved(seat.x, 0.0f, seat.z, seat.turn + skew) * Moved(0.0f, 0.0f, -pulled);
  const Box box = Transformed(draft.bounds, pose);
  // A chair pushed under the table meets the table's box: only its back half is tested.
  Draft back = draft;
  back.bounds.max().z() = -kSeatOut - 0.01f;
  if (!Fits(back, pose, {false, false}) || !space_.LeavesWayPast(box)) return false;
  if (!space_.Contains(FootOf(box))) return false;
  Place(draft, pose, false);
  return true;
}

int RoomFurnisher::ChairsAround(const Placed& table, std::string_view chair, int most) {
  // All alike: built from one state of the generator.
  const std::uint64_t same = built_;
  const float width = table.size.x();
  const float half_depth = 0.5f * table.size.z();
  const bool is_round = std::abs(width - table.size.z()) < 0.05f;
  std::vector<Offset> seats;
  const int a_side = is_round ? 1 : std::max(1, static_cast<int>(width / 0.62f));
  for (int i = 0; i < a_side; ++i) {
    const float x = width * ((static_cast<float>(i) + 0.5f) / static_cast<float>(a_side) - 0.5f);
    seats.push_back({x, -half_depth - kSeatOut, 0.0f});
    seats.push_back({-x, half_depth + kSeatOut, kTurn});
  }
  seats.push_back({-0.5f * width - kSeatOut, 0.0f, 0.5f * kTurn});
  seats.push_back({0.5f * width + kSeatOut, 0.0f, -0.5f * kTurn});
  int count = 0;
  for (const Offset& seat : seats) {
    if (count >= most) break;
    built_ = same;
    if (PlaceChair(table, chair, seat)) ++count;
  }
  return count;
}

}  // namespace bulletnav::sim::placing
