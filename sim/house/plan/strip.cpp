// SPDX-License-Identifier: MIT
#include "sim/house/plan/strip.h"

#include <algorithm>
#include <cmath>

#include "sim/base/check.h"
#include "sim/house/plan/rules.h"

namespace bulletnav::sim::plan {
namespace {

constexpr Span kImpossible{1, 0, 0};
constexpr float kMinFront = 1.25f;  // what a door and its casing need on the corridor, metres

float TargetOf(const Draft& draft, int room) {
  return draft.rooms[static_cast<std::size_t>(room)].target;
}

/// Clear limits in metres turned into a span of middle lines.
Span ToSpan(const Draft& draft, float low, float want, float high) {
  if (low > high + 1e-4f) return kImpossible;
  Span span{draft.Gross(low), 0, draft.Gross(high)};
  if (span.high > span.low && draft.Clear(span.high) > high) span.high -= kGrid;
  span.want = std::clamp(draft.Gross(want), span.low, span.high);
  return span;
}

Span OneRoomSpan(const Draft& draft, int room, int depth) {
  const RoomRule& rule = RuleOf(draft.type(room));
  const float clear = draft.Clear(depth);
  if (clear < rule.min_side) return kImpossible;
  if (rule.type == RoomType::kCorridor) {  // a branch to the outside
    return ToSpan(draft, 1.2f, 1.4f, kMaxCorridor);
  }
  const float low = std::max({rule.min_side, rule.min_area / clear, clear / rule.max_aspect});
  const float high = std::min(rule.max_area / clear, clear * rule.max_aspect);
  return ToSpan(draft, low, TargetOf(draft, room) / clear, high);
}

/// Two rooms behind each other share a width.
Span BehindSpan(const Draft& draft, const Slot& slot, int depth) {
  const RoomRule& near = RuleOf(draft.type(slot.room));
  const RoomRule& far = RuleOf(draft.type(slot.behind));
  const float clear = draft.Clear(depth) - 0.01f * static_cast<float>(draft.wall_cm);
  if (clear < near.min_side + far.min_side) return kImpossible;
  const float low = std::max({near.min_side, far.min_side, (near.min_area + far.min_area) / clear});
  const float high = std::min((near.max_area + far.max_area) / clear, 3.2f);
  const float want = (TargetOf(draft, slot.room) + TargetOf(draft, slot.behind)) / clear;
  return ToSpan(draft, low, want, high);
}

Span NotchSpan(const Draft& draft, const Slot& slot, int depth) {
  const RoomRule& large = RuleOf(draft.type(slot.room));
  const RoomRule& small = RuleOf(draft.type(slot.notch));
  const float clear = draft.Clear(depth);
  if (clear < large.min_side + small.min_side + 0.3f) return kImpossible;
  const float low = std::max({large.min_side, small.min_side + kMinFront + 0.3f,
                              (large.min_area + small.min_area) / clear});
  const float high = std::min((large.max_area + small.max_area) / clear, clear * large.max_aspect);
  const float want = (TargetOf(draft, slot.room) + TargetOf(draft, slot.notch)) / clear + 0.3f;
  return ToSpan(draft, low, want, high);
}

/// Lengths of the slots, adding up to `length`.
std::vector<int> Share(const std::vector<Span>& spans, int length) {
  Span sum;
  for (const Span& span : spans) {
    sum.low += span.low;
    sum.want += span.want;
    sum.high += span.high;
  }
  BULLETNAV_CHECK_LE(sum.low, length);
  BULLETNAV_CHECK_LE(length, sum.high);
  const bool grow = length >= sum.want;
  const int room = grow ? sum.high - sum.want : sum.want - sum.low;
  const double part = room == 0 ? 0.0 : static_cast<double>(length - sum.want) / room;
  std::vector<int> lengths;
  double exact = 0.0;
  int used = 0;
  for (const Span& span : spans) {
    const int reach = grow ? span.high - span.want : span.want - span.low;
    exact += span.want + part * reach;
    const int cut = std::clamp(SnapToGrid(exact) - used, span.low, span.high);
    lengths.push_back(cut);
    used += cut;
  }
  for (std::size_t i = 0; used != length; i = (i + 1) % spans.size()) {  // rounding's rest
    const int step = std::clamp(length - used, -kGrid, kGrid);
    if (lengths[i] + step < spans[i].low || lengths[i] + step > spans[i].high) continue;
    lengths[i] += step;
    used += step;
  }
  return lengths;
}

/// Where the wall between a near and a far room goes.
int CutDepth(const Draft& draft, const Slot& slot, int depth, float clear_width) {
  const RoomRule& near = RuleOf(draft.type(slot.room));
  const RoomRule& far = RuleOf(draft.type(slot.behind));
  const float target = TargetOf(draft, slot.room);
  const float share = target / (target + TargetOf(draft, slot.behind));
  const int low = draft.Gross(std::max(near.min_side, near.min_area / clear_width));
  const int high = depth - draft.Gross(std::max(far.min_side, far.min_area / clear_width));
  return std::clamp(SnapToGrid(share * static_cast<float>(depth)), std::min(low, high), high);
}

class StripFiller {
 public:
  StripFiller(const Axes& frame, int depth, Draft* draft, Rng* rng)
      : frame_(frame), depth_(depth), draft_(draft), rng_(rng) {}

  void Fill(const Slot& slot, int from, int to) {
    if (slot.behind >= 0) {
      const int cut = CutDepth(*draft_, slot, depth_, draft_->Clear(to - from));
      Add(slot.room, from, 0, to, cut);
      Add(slot.behind, from, cut, to, depth_);
    } else if (slot.notch >= 0) {
      FillNotched(slot, from, to);
    } else {
      Add(slot.room, from, 0, to, depth_ - slot.porch_cm);
    }
  }

 private:
  void FillNotched(const Slot& slot, int from, int to) {
    const RoomRule& small = RuleOf(draft_->type(slot.notch));
    const RoomRule& large = RuleOf(draft_->type(slot.room));
    const float target = TargetOf(*draft_, slot.notch);
    const int most_along = to - from - draft_->Gross(kMinFront);
    const int most_deep = depth_ - draft_->Gross(large.min_side);
    const float side = std::sqrt(target) * static_cast<float>(rng_->Uniform(0.85, 1.2));
    const int along = std::clamp(draft_->Gross(side), draft_->Gross(small.min_side), most_along);
    const int deep = std::clamp(draft_->Gross(target / draft_->Clear(along)),
                                std::min(draft_->Gross(small.min_side), most_deep), most_deep);
    const int cut = slot.notch_first ? from + along : to - along;
    Add(slot.notch, slot.notch_first ? from : cut, 0, slot.notch_first ? cut : to, deep);
    Add(slot.room, slot.notch_first ? cut : from, 0, slot.notch_first ? to : cut, deep);
    Add(slot.room, from, deep, to, depth_);
  }

  void Add(int room, int s0, int d0, int s1, int d1) {
    draft_->rooms[static_cast<std::size_t>(room)].boxes.push_back(frame_.At(s0, d0, s1, d1));
  }

  const Axes& frame_;
  int depth_;
  Draft* draft_;
  Rng* rng_;
};

}  // namespace

Span SlotSpan(const Draft& draft, const Slot& slot, int depth) {
  if (slot.behind >= 0) return BehindSpan(draft, slot, depth);
  if (slot.notch >= 0) return NotchSpan(draft, slot, depth);
  return OneRoomSpan(draft, slot.room, depth - slot.porch_cm);
}

Span StripSpan(const Draft& draft, const Strip& strip) {
  Span sum;
  for (const Slot& slot : strip.slots) {
    const Span span = SlotSpan(draft, slot, strip.depth);
    if (span.empty()) return kImpossible;
    sum.low += span.low;
    sum.want += span.want;
    sum.high += span.high;
  }
  return sum;
}

Box Axes::At(int s0, int d0, int s1, int d1) const {
  const int ax = origin.x + along.x * s0 + out.x * d0;
  const int ay = origin.y + along.y * s0 + out.y * d0;
  const int bx = origin.x + along.x * s1 + out.x * d1;
  const int by = origin.y + along.y * s1 + out.y * d1;
  return {std::min(ax, bx), std::min(ay, by), std::max(ax, bx), std::max(ay, by)};
}

void FillStrip(const Strip& strip, const Axes& frame, int length, Draft* draft, Rng* rng) {
  std::vector<Span> spans;
  for (const Slot& slot : strip.slots) spans.push_back(SlotSpan(*draft, slot, strip.depth));
  const std::vector<int> lengths = Share(spans, length);
  StripFiller filler(frame, strip.depth, draft, rng);
  int at = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    filler.Fill(strip.slots[i], at, at + lengths[i]);
    at += lengths[i];
  }
}

}  // namespace bulletnav::sim::plan
