// SPDX-License-Identifier: MIT
#include "sim/house/building/bands.h"

#include <algorithm>
#include <utility>

#include "sim/base/check.h"

namespace bulletnav::sim::building {
namespace {

using plan::Axes;
using plan::Draft;

/// A cell that is taken and its place along the row, centimetres.
struct Slot {
  const Cell* cell = nullptr;
  int from = 0;
  int width = 0;
};

/// Chooses cells and widths that fill a row exactly.
class RowFiller {
 public:
  RowFiller(const Draft& draft, std::span<const Cell> cells, int length, Rng* rng)
      : draft_(draft), cells_(cells), length_(length), rng_(rng), taken_(cells.size(), 0) {}

  std::vector<Slot> Run() {
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      for (int k = 0; k < cells_[i].least; ++k) Take(i);
    }
    while (TakeAny()) {
    }
    rng_->Shuffle(slots_);
    Spread();
    int at = 0;
    for (Slot& slot : slots_) {
      slot.from = at;
      at += slot.width;
    }
    return std::move(slots_);
  }

 private:
  int Least(const Cell& cell) const { return draft_.Gross(cell.min_width); }
  int Most(const Cell& cell) const { return draft_.Gross(cell.max_width); }
  int left() const { return length_ - used_; }

  bool Take(std::size_t i) {
    const Cell& cell = cells_[i];
    const auto drawn = static_cast<float>(rng_->Uniform(cell.min_width, cell.max_width));
    const int width = std::min(draft_.Gross(drawn), left());
    if (width < Least(cell)) return false;
    slots_.push_back({&cell, 0, width});
    used_ += width;
    ++taken_[i];
    return true;
  }

  bool TakeAny() {
    std::vector<double> weights;
    double sum = 0.0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const bool may = taken_[i] < cells_[i].most && Least(cells_[i]) <= left();
      weights.push_back(may ? cells_[i].weight : 0.0);
      sum += weights.back();
    }
    return sum > 0.0 && Take(rng_->Weighted(weights));
  }

  /// What is left over goes to those that may grow, then to the widest.
  void Spread() {
    BULLETNAV_CHECK(!slots_.empty());
    for (Slot& slot : slots_) {
      const int more = std::clamp(Most(*slot.cell) - slot.width, 0, left());
      slot.width += more;
      used_ += more;
    }
    const auto widest =
        std::max_element(slots_.begin(), slots_.end(), [](const Slot& a, const Slot& b) {
          return std::pair(!a.cell->is_crossing, a.width) <
                 std::pair(!b.cell->is_crossing, b.width);
        });
    widest->width += left();
    used_ = length_;
  }

  const Draft& draft_;
  std::span<const Cell> cells_;
  int length_;
  Rng* rng_;
  std::vector<int> taken_;
  std::vector<Slot> slots_;
  int used_ = 0;
};

class BlockBuilder {
 public:
  BlockBuilder(const Block& block, const Axes& axes, Sketch* sketch, Rng* rng)
      : block_(block), axes_(axes), sketch_(*sketch), rng_(rng) {
    length_ = draft().Gross(block.length);
  }

  LaidBlock Build(int head) {
    laid_.head = head;
    AddHalls();
    int d = 0;
    for (std::size_t i = 0; i < block_.bands.size(); ++i) {
      const int depth = draft().Gross(block_.bands[i].depth);
      if (!block_.bands[i].hall) AddRow(i, d, depth);
      d += depth;
    }
    if (head < 0 && block_.head) laid_.head = AddEnd(*block_.head, true, d);
    if (block_.tail) laid_.tail = AddEnd(*block_.tail, false, d);
    if (laid_.head >= 0) JoinToHalls(laid_.head, block_.head ? block_.head->way : kArch);
    if (laid_.tail >= 0) JoinToHalls(laid_.tail, block_.tail->way);
    return laid_;
  }

 private:
  static constexpr OpeningKind kArch = OpeningKind::kArch;

  const Draft& draft() const { return sketch_.draft; }

  void AddHalls() {
    int d = 0;
    for (const Band& band : block_.bands) {
      const int depth = draft().Gross(band.depth);
      int room = -1;
      if (band.hall) {
        room = sketch_.Add(*band.hall, axes_.At(0, d, length_, d + depth));
        laid_.halls.push_back(room);
      }
      hall_of_band_.push_back(room);
      d += depth;
    }
  }

  int AddEnd(const End& end, bool is_head, int depth) {
    const int length = draft().Gross(end.length);
    return sketch_.Add(end.type, is_head ? axes_.At(-length, 0, 0, depth)
                                         : axes_.At(length_, 0, length_ + length, depth));
  }

  void JoinToHalls(int room, OpeningKind way) {
    for (const int hall : laid_.halls) sketch_.Join(room, hall, way);
  }

  int HallOf(std::size_t band) const {
    return band < hall_of_band_.size() ? hall_of_band_[band] : -1;
  }

  void AddRow(std::size_t band, int d, int depth) {
    const Band& row = block_.bands[band];
    const int before = band > 0 ? HallOf(band - 1) : -1;
    const int after = HallOf(band + 1);
    BULLETNAV_CHECK(before >= 0 || after >= 0);
    const int length = plan::SnapToGrid(static_cast<double>(row.share) * length_);
    for (const Slot& slot : RowFiller(draft(), row.cells, length, rng_).Run()) {
      const bool to_before = after < 0 || (before >= 0 && rng_->Chance(0.5));
      const int room = AddCell(slot, d, depth, to_before);
      sketch_.Join(room, to_before ? before : after, slot.cell->way);
      if (slot.cell->is_crossing) {
        if (before >= 0 && after >= 0) sketch_.Join(room, to_before ? after : before, kArch);
        continue;
      }
      const bool is_long = draft().Clear(slot.width) > 9.0f && slot.cell->way != kArch;
      if (is_long && rng_->Chance(0.6)) {
        sketch_.Join(room, to_before ? before : after, slot.cell->way);
      }
    }
  }

  /// The cell's room; its alcove is at the beginning or the end of it, on the side of its hall.
  int AddCell(const Slot& slot, int d, int depth, bool hall_is_before) {
    const Alcove& alcove = slot.cell->alcove;
    const int s0 = slot.from;
    const int s1 = slot.from + slot.width;
    if (alcove.width <= 0.0f) {
      return sketch_.Add(slot.cell->type, axes_.At(s0, d, s1, d + depth));
    }
    const int in = draft().Gross(alcove.depth);
    const int wide = draft().Gross(alcove.width);
    const int near = hall_is_before ? d : d + depth - in;  // of the part beside the hall
    const int far = hall_is_before ? d + in : d;
    const bool first = rng_->Chance(0.5);
    const int room = sketch_.Add(slot.cell->type, axes_.At(s0, far, s1, far + depth - in));
    sketch_.draft.rooms.back().boxes.push_back(first ? axes_.At(s0 + wide, near, s1, near + in)
                                                     : axes_.At(s0, near, s1 - wide, near + in));
    const int bath = sketch_.Add(alcove.type, first ? axes_.At(s0, near, s0 + wide, near + in)
                                                    : axes_.At(s1 - wide, near, s1, near + in));
    sketch_.Join(bath, room, OpeningKind::kDoor);
    return room;
  }

  const Block& block_;
  const Axes& axes_;
  Sketch& sketch_;
  Rng* rng_;
  int length_ = 0;
  std::vector<int> hall_of_band_;
  LaidBlock laid_;
};

}  // namespace

int Sketch::Add(RoomType type, const plan::Box& box) {
  draft.rooms.push_back({type, 0.0f, {box}});
  return static_cast<int>(draft.rooms.size()) - 1;
}

void Sketch::Join(int a, int b, OpeningKind way) {
  links.push_back({a, b, way});
}

int GrossDepth(const plan::Draft& draft, const Block& block) {
  int depth = 0;
  for (const Band& band : block.bands) depth += draft.Gross(band.depth);
  return depth;
}

void LayBent(Block block, float longest, Sketch* sketch, Rng* rng) {
  const plan::Axes straight{{0, 0}, {1, 0}, {0, 1}};
  if (block.length <= longest || !block.head) {
    LayBlock(block, straight, -1, sketch, rng);
    return;
  }
  const float share = static_cast<float>(rng->Uniform(0.4, 0.6));
  Block other = block;
  const int depth = GrossDepth(sketch->draft, block);
  const float corner = sketch->draft.Clear(depth);
  other.length = (1.0f - share) * block.length;
  other.tail.reset();
  block.length *= share;
  block.head->length = corner;
  const LaidBlock laid = LayBlock(block, straight, -1, sketch, rng);
  LayBlock(other, {{0, depth}, {0, 1}, {-1, 0}}, laid.head, sketch, rng);
}

LaidBlock LayBlock(const Block& block, const plan::Axes& axes, int head, Sketch* sketch, Rng* rng) {
  return BlockBuilder(block, axes, sketch, rng).Build(head);
}

}  // namespace bulletnav::sim::building
