// SPDX-License-Identifier: MIT
#include "sim/house/plan/wing.h"

#include <algorithm>

#include "sim/house/plan/rules.h"

namespace bulletnav::sim::plan {
namespace {

constexpr int kShortestCourt = 250;  // cm; a narrower niche in the outline looks like a mistake

/// How far an end room stretches along the corridor; 0 if it has no good size.
int EndRoomLength(const Draft& draft, int room, int depth) {
  const RoomRule& rule = RuleOf(draft.type(room));
  const float clear = draft.Clear(depth);
  const float low = std::max({rule.min_side, rule.min_area / clear, clear / rule.max_aspect});
  const float high = rule.max_area / clear;
  if (clear < rule.min_side || low > high) return 0;
  const float want = draft.rooms[static_cast<std::size_t>(room)].target / clear;
  return draft.Gross(std::clamp(want, low, high));
}

/// Corridor lengths that suit a strip.
Span CorridorSpan(const Draft& draft, const Strip& strip, int from, int beyond) {
  Span span = StripSpan(draft, strip);
  if (span.empty()) return span;
  const int shift = from - beyond;
  return {span.low + shift, span.want + shift, span.high + shift};
}

class WingBuilder {
 public:
  WingBuilder(const Wing& wing, const Axes& axes, Draft* draft, Rng* rng)
      : wing_(wing), axes_(axes), draft_(draft), rng_(rng) {}

  std::optional<int> Build() {
    if (!MeasureEndRooms()) return std::nullopt;
    const std::optional<int> length = ChooseLength();
    if (!length) return std::nullopt;
    Add(wing_.corridor, axes_.At(0, 0, *length, wing_.corridor_width));
    const GridPoint back = {-axes_.out.x, -axes_.out.y};
    if (!wing_.left.slots.empty()) {
      const int strip = *length + wing_.left_beyond - wing_.left_from;
      Fill(wing_.left, {PointAt(wing_.left_from, 0), axes_.along, back}, strip);
    }
    if (!wing_.right.slots.empty()) {
      const int strip =
          short_right_ > 0 ? short_right_ : *length + wing_.right_beyond - wing_.right_from;
      const GridPoint origin = PointAt(wing_.right_from, wing_.corridor_width);
      Fill(wing_.right, {origin, axes_.along, axes_.out}, strip);
    }
    AddEndRooms(*length);
    return length;
  }

 private:
  bool MeasureEndRooms() {
    if (wing_.near_room >= 0) {
      near_ = EndRoomLength(*draft_, wing_.near_room, EndDepth(wing_.near_on_left));
      (wing_.near_on_left ? wing_.right_from : wing_.left_from) -= near_;
      if (near_ == 0) return false;
    }
    if (wing_.far_room >= 0) {
      far_ = EndRoomLength(*draft_, wing_.far_room, EndDepth(wing_.far_on_left));
      (wing_.far_on_left ? wing_.right_beyond : wing_.left_beyond) += far_;
      if (far_ == 0) return false;
    }
    return true;
  }

  int EndDepth(bool on_left) const {
    return wing_.corridor_width + (on_left ? wing_.left.depth : wing_.right.depth);
  }

  std::optional<int> ChooseLength() {
    const bool has_left = !wing_.left.slots.empty();
    const bool has_right = !wing_.right.slots.empty();
    const Span left = CorridorSpan(*draft_, wing_.left, wing_.left_from, wing_.left_beyond);
    const Span right = CorridorSpan(*draft_, wing_.right, wing_.right_from, wing_.right_beyond);
    if ((has_left && left.empty()) || (has_right && right.empty())) return std::nullopt;
    if (!has_left || !has_right) return CheckedLength(has_left ? left.want : right.want);
    if (wing_.right_may_be_short && right.want + kShortestCourt <= left.want) {
      short_right_ = right.want + wing_.right_beyond - wing_.right_from;
      return CheckedLength(left.want);
    }
    const int low = std::max(left.low, right.low);
    const int high = std::min(left.high, right.high);
    if (low > high) return std::nullopt;
    return CheckedLength(std::clamp(SnapToGrid(0.5 * (left.want + right.want)), low, high));
  }

  static std::optional<int> CheckedLength(int length) {
    constexpr int kShortest = 150;
    return length < kShortest ? std::nullopt : std::optional(length);
  }

  void AddEndRooms(int length) {
    const int width = wing_.corridor_width;
    if (wing_.near_room >= 0) {
      const int d0 = wing_.near_on_left ? -wing_.left.depth : 0;
      const int d1 = wing_.near_on_left ? width : width + wing_.right.depth;
      Add(wing_.near_room, axes_.At(-near_, d0, 0, d1));
    }
    if (wing_.far_room >= 0) {
      const int d0 = wing_.far_on_left ? -wing_.left.depth : 0;
      const int d1 = wing_.far_on_left ? width : width + wing_.right.depth;
      Add(wing_.far_room, axes_.At(length, d0, length + far_, d1));
    }
  }

  GridPoint PointAt(int s, int d) const {
    return {axes_.origin.x + axes_.along.x * s + axes_.out.x * d,
            axes_.origin.y + axes_.along.y * s + axes_.out.y * d};
  }

  void Fill(const Strip& strip, const Axes& axes, int length) {
    FillStrip(strip, axes, length, draft_, rng_);
  }

  void Add(int room, const Box& box) {
    draft_->rooms[static_cast<std::size_t>(room)].boxes.push_back(box);
  }

  Wing wing_;
  Axes axes_;
  Draft* draft_;
  Rng* rng_;
  int near_ = 0;
  int far_ = 0;
  int short_right_ = 0;  // length of a right strip that leaves a court
};

}  // namespace

std::optional<int> BuildWing(const Wing& wing, const Axes& axes, Draft* draft, Rng* rng) {
  return WingBuilder(wing, axes, draft, rng).Build();
}

}  // namespace bulletnav::sim::plan
