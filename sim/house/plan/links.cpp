// SPDX-License-Identifier: MIT
#include "sim/house/plan/links.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "sim/house/plan/rules.h"

namespace bulletnav::sim::plan {
namespace {

constexpr double kNever = 1e9;
constexpr float kArchWall = 1.3f;

/// How an architect feels about a passage between rooms of two types.
struct Taste {
  RoomType a = RoomType::kLivingRoom;
  RoomType b = RoomType::kLivingRoom;
  double cost = 0.0;   // passages are made in this order until every room is reached
  double extra = 0.0;  // chance of one that is not needed
  double arch = 0.0;   // chance of an arch instead of a door in the most open house
};

using enum RoomType;
constexpr std::array kTastes = {
    Taste{kCorridor, kCorridor, 0.0, 0.0, 0.6},     Taste{kCorridor, kEntry, 0.0, 1.0, 0.75},
    Taste{kEntry, kLivingRoom, 1.0, 0.5, 0.8},      Taste{kCorridor, kLivingRoom, 1.0, 0.45, 0.7},
    Taste{kLivingRoom, kDiningRoom, 1.0, 0.9, 1.0}, Taste{kDiningRoom, kKitchen, 1.0, 1.0, 0.85},
    Taste{kLivingRoom, kKitchen, 2.0, 0.4, 0.9},    Taste{kCorridor, kDiningRoom, 3.0, 0.15, 0.6},
    Taste{kEntry, kDiningRoom, 3.0, 0.15, 0.7},     Taste{kCorridor, kKitchen, 3.5, 0.35, 0.1},
    Taste{kEntry, kKitchen, 3.5, 0.15, 0.2},        Taste{kCorridor, kBedroom, 2.0, 0.0, 0.0},
    Taste{kEntry, kBedroom, 3.0, 0.0, 0.0},         Taste{kCorridor, kKidsRoom, 2.0, 0.0, 0.0},
    Taste{kEntry, kKidsRoom, 3.0, 0.0, 0.0},        Taste{kCorridor, kStudy, 2.0, 0.0, 0.0},
    Taste{kEntry, kStudy, 2.0, 0.0, 0.0},           Taste{kLivingRoom, kStudy, 5.0, 0.0, 0.2},
    Taste{kCorridor, kBathroom, 2.0, 0.0, 0.0},     Taste{kEntry, kBathroom, 3.0, 0.0, 0.0},
    Taste{kBedroom, kBathroom, 5.0, 0.0, 0.0},      Taste{kCorridor, kToilet, 2.0, 0.0, 0.0},
    Taste{kEntry, kToilet, 2.0, 0.0, 0.0},          Taste{kCorridor, kLaundry, 2.5, 0.0, 0.0},
    Taste{kEntry, kLaundry, 2.8, 0.0, 0.0},         Taste{kKitchen, kLaundry, 3.0, 0.0, 0.0},
    Taste{kBathroom, kLaundry, 6.0, 0.0, 0.0},      Taste{kCorridor, kStorage, 2.0, 0.0, 0.0},
    Taste{kEntry, kStorage, 2.0, 0.0, 0.0},         Taste{kKitchen, kStorage, 2.6, 0.0, 0.0},
};

const Taste* FindTaste(RoomType a, RoomType b) {
  for (const Taste& taste : kTastes) {
    if ((taste.a == a && taste.b == b) || (taste.a == b && taste.b == a)) return &taste;
  }
  return nullptr;
}

struct Candidate {
  int a = -1;
  int b = -1;
  double cost = 0.0;
  const Taste* taste = nullptr;
};

class Linker {
 public:
  Linker(const Layout& layout, double openness, Rng* rng)
      : layout_(layout), openness_(openness), rng_(rng) {
    group_.resize(layout.draft.rooms.size());
    std::iota(group_.begin(), group_.end(), 0);
  }

  std::optional<std::vector<Link>> Run() {
    std::vector<Candidate> candidates = Candidates();
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& x, const Candidate& y) {
                       return x.cost < y.cost;
                     });
    for (const Candidate& c : candidates) {
      const bool is_needed = Group(c.a) != Group(c.b);
      if (is_needed || rng_->Chance(c.taste->extra)) Join(c);
    }
    for (int room = 0; room < count(); ++room) {
      if (Group(room) != Group(0) || !IsWellJoined(room)) return std::nullopt;
    }
    if (!HasSharedBathroom() || !AddEntryDoor()) return std::nullopt;
    return std::move(links_);
  }

 private:
  int count() const { return static_cast<int>(group_.size()); }
  RoomType type(int room) const { return layout_.draft.type(room); }

  int Group(int room) const { return group_[static_cast<std::size_t>(room)]; }

  std::vector<Candidate> Candidates() {
    const int second_bathroom = SecondBathroom();
    const bool is_ensuite = rng_->Chance(0.6);
    std::vector<Candidate> candidates;
    for (int a = 0; a < count(); ++a) {
      for (int b = a + 1; b < count(); ++b) {
        const Taste* taste = FindTaste(type(a), type(b));
        if (taste == nullptr || layout_.SharedWall(a, b) < kDoorWall) continue;
        double cost = taste->cost + rng_->Uniform(0.0, 0.4);
        const bool to_hall = IsCirculation(type(a)) || IsCirculation(type(b));
        if (is_ensuite && to_hall && (a == second_bathroom || b == second_bathroom)) cost += 5.0;
        candidates.push_back({a, b, cost, taste});
      }
    }
    return candidates;
  }

  int SecondBathroom() const {
    int seen = 0;
    for (int room = 0; room < count(); ++room) {
      if (type(room) == kBathroom && ++seen == 2) return room;
    }
    return -1;
  }

  void Join(const Candidate& c) {
    const bool has_room = layout_.SharedWall(c.a, c.b) >= kArchWall;
    const bool is_arch = has_room && rng_->Chance(c.taste->arch * openness_);
    links_.push_back({c.a, c.b, is_arch ? OpeningKind::kArch : OpeningKind::kDoor});
    const int from = Group(c.b);
    std::replace(group_.begin(), group_.end(), from, Group(c.a));
  }

  int CountLinks(int room, bool (*wanted)(RoomType)) const {
    return static_cast<int>(std::count_if(links_.begin(), links_.end(), [&](const Link& link) {
      return (link.a == room && wanted(type(link.b))) || (link.b == room && wanted(type(link.a)));
    }));
  }

  static bool IsAny(RoomType) { return true; }
  static bool IsBathroom(RoomType type) { return type == kBathroom; }

  /// Nobody walks through private rooms, except from a bedroom into its own bathroom.
  bool IsWellJoined(int room) const {
    const RoomType t = type(room);
    if (IsCirculation(t) || IsPublic(t)) return true;
    const int all = CountLinks(room, IsAny);
    if (!IsSleeping(t)) return all == 1;
    return CountLinks(room, IsCirculation) == 1 && CountLinks(room, IsBathroom) == all - 1;
  }

  bool HasSharedBathroom() const {
    for (int room = 0; room < count(); ++room) {
      if (type(room) == kBathroom && CountLinks(room, IsCirculation) > 0) return true;
    }
    return false;
  }

  /// Into the entry if there is one, else into a corridor.
  bool AddEntryDoor() {
    std::vector<int> halls;
    for (const RoomType wanted : {kEntry, kCorridor}) {
      for (int room = 0; halls.empty() && room < count(); ++room) {
        const bool fits = layout_.SharedWall(room, kOutside) >= kArchWall;
        if (type(room) == wanted && fits) halls.push_back(room);
      }
    }
    if (halls.empty()) return false;
    const bool has_entry =
        std::any_of(layout_.draft.rooms.begin(), layout_.draft.rooms.end(), [](const DraftRoom& r) {
          return r.type == kEntry;
        });
    if (has_entry && type(halls.front()) != kEntry) return false;
    links_.push_back({halls.front(), kOutside, OpeningKind::kDoor});
    return true;
  }

  const Layout& layout_;
  double openness_;
  Rng* rng_;
  std::vector<int> group_;
  std::vector<Link> links_;
};

}  // namespace

std::optional<std::vector<Link>> DrawLinks(const Layout& layout, double openness, Rng* rng) {
  return Linker(layout, openness, rng).Run();
}

}  // namespace bulletnav::sim::plan
