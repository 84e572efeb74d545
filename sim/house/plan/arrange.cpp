// SPDX-License-Identifier: MIT
#include "sim/house/plan/arrange.h"

#include <algorithm>
#include <array>
#include <utility>

#include "sim/house/plan/rules.h"

namespace bulletnav::sim::plan {
namespace {

constexpr double kOrderNoise = 0.16;

/// Rooms that may lie behind another one, and the room beside them through which they are entered.
constexpr std::array kHosted = {
    std::pair{RoomType::kBathroom, RoomType::kBedroom},
    std::pair{RoomType::kLaundry, RoomType::kKitchen},
    std::pair{RoomType::kStorage, RoomType::kKitchen},
    std::pair{RoomType::kToilet, RoomType::kEntry},
    std::pair{RoomType::kStorage, RoomType::kEntry},
};

bool CanBeHosted(RoomType guest, RoomType host) {
  return std::any_of(kHosted.begin(), kHosted.end(), [&](const auto& pair) {
    return pair.first == guest && pair.second == host;
  });
}

class Bundler {
 public:
  Bundler(const Draft& draft, Rng* rng) : draft_(draft), rng_(rng) {}

  std::vector<Bundle> Run(const std::vector<int>& rooms) {
    std::vector<int> small;
    for (const int room : rooms) {
      if (IsSmall(draft_.type(room))) {
        small.push_back(room);
      } else {
        AddAlone(room);
      }
    }
    rng_->Shuffle(small);
    bathrooms_left_ = static_cast<int>(std::count_if(small.begin(), small.end(), [&](int room) {
      return draft_.type(room) == RoomType::kBathroom;
    }));
    while (!small.empty()) {
      const int room = small.back();
      small.pop_back();
      if (rng_->Chance(0.6) && PutBehind(room, &small)) continue;
      if (rng_->Chance(NotchChance(room)) && PutIntoCorner(room)) continue;
      AddAlone(room);
    }
    return std::move(bundles_);
  }

 private:
  double NotchChance(int room) const {
    const RoomType type = draft_.type(room);
    return type == RoomType::kToilet || type == RoomType::kStorage ? 0.85 : 0.2;
  }

  void AddAlone(int room) {
    const double privacy = RuleOf(draft_.type(room)).privacy + kOrderNoise * rng_->Normal();
    bundles_.push_back({{Slot{.room = room}}, privacy});
  }

  /// `far` goes behind another small room, beside a host.
  bool PutBehind(int far, std::vector<int>* small) {
    const RoomType type = draft_.type(far);
    if (small->empty() || (type == RoomType::kBathroom && bathrooms_left_ < 2)) return false;
    std::vector<std::size_t> hosts;
    for (std::size_t i = 0; i < bundles_.size(); ++i) {
      const bool is_single = bundles_[i].slots.size() == 1;
      if (is_single && CanBeHosted(type, draft_.type(bundles_[i].slots[0].room))) {
        hosts.push_back(i);
      }
    }
    if (hosts.empty()) return false;
    if (type == RoomType::kBathroom) --bathrooms_left_;
    Bundle& bundle = bundles_[rng_->Pick(hosts)];
    const Slot column{.room = small->back(), .behind = far};
    small->pop_back();
    bundle.slots.insert(rng_->Chance(0.5) ? bundle.slots.begin() : bundle.slots.end(), column);
    return true;
  }

  bool PutIntoCorner(int room) {
    std::vector<Slot*> large;
    for (Bundle& bundle : bundles_) {
      for (Slot& slot : bundle.slots) {
        const bool is_plain = slot.behind < 0 && slot.notch < 0;
        const auto index = static_cast<std::size_t>(slot.room);
        const bool is_large = draft_.rooms[index].target > 13.0f;
        if (is_plain && is_large && !IsSmall(draft_.type(slot.room))) large.push_back(&slot);
      }
    }
    if (large.empty()) return false;
    Slot* slot = rng_->Pick(large);
    slot->notch = room;
    slot->notch_first = rng_->Chance(0.5);
    return true;
  }

  const Draft& draft_;
  Rng* rng_;
  std::vector<Bundle> bundles_;
  int bathrooms_left_ = 0;
};

/// Length a bundle would like to have in a strip; a large number if it does not fit its depth.
int WantedLength(const Draft& draft, const Bundle& bundle, int depth) {
  const Span span = StripSpan(draft, {depth, bundle.slots});
  return span.empty() ? 100000 : span.want;
}

}  // namespace

std::vector<Bundle> MakeBundles(const Draft& draft, const std::vector<int>& rooms, Rng* rng) {
  return Bundler(draft, rng).Run(rooms);
}

void Distribute(const Draft& draft, std::vector<Bundle> bundles, Strip* north, Strip* south,
                Rng* rng) {
  rng->Shuffle(bundles);
  std::stable_sort(bundles.begin(), bundles.end(), [&](const Bundle& a, const Bundle& b) {
    return WantedLength(draft, a, 400) > WantedLength(draft, b, 400);
  });
  std::array<Strip*, 2> strips = {north, south};
  std::array<std::vector<Bundle>, 2> shares;
  std::array<int, 2> lengths = {StripSpan(draft, *north).want, StripSpan(draft, *south).want};
  for (const Bundle& bundle : bundles) {
    std::size_t side = lengths[0] <= lengths[1] ? 0 : 1;
    if (rng->Chance(0.2)) side = 1 - side;
    if (strips[side]->depth == 0) side = 1 - side;
    lengths[side] += WantedLength(draft, bundle, strips[side]->depth);
    shares[side].push_back(bundle);
  }
  for (std::size_t side = 0; side < 2; ++side) {
    std::stable_sort(shares[side].begin(), shares[side].end(),
                     [](const Bundle& a, const Bundle& b) {
                       return a.privacy < b.privacy;
                     });
    for (const Bundle& bundle : shares[side]) {
      auto& slots = strips[side]->slots;
      slots.insert(slots.end(), bundle.slots.begin(), bundle.slots.end());
    }
  }
}

}  // namespace bulletnav::sim::plan
