// SPDX-License-Identifier: MIT
#include "sim/house/plan/archetypes.h"

#include <algorithm>
#include <array>

#include "sim/base/check.h"
#include "sim/house/plan/arrange.h"
#include "sim/house/plan/block.h"
#include "sim/house/plan/rules.h"
#include "sim/house/plan/wing.h"

namespace bulletnav::sim::plan {
namespace {

constexpr Axes kEastward{{0, 0}, {1, 0}, {0, 1}};

/// Probability weights of the archetypes, in their order, for small, middling and large homes.
constexpr std::array<std::array<double, 6>, 3> kArchetypeWeights = {{
    {2.0, 2.0, 1.2, 3.0, 0.0, 0.0},
    {2.5, 2.0, 1.0, 1.5, 1.5, 0.7},
    {2.5, 1.5, 0.2, 0.5, 2.0, 2.0},
}};

class Sketch {
 public:
  Sketch(const Program& program, const Traits& traits, Rng* rng)
      : traits_(traits), rng_(rng), taken_(program.rooms.size(), false) {
    draft_.rooms = program.rooms;
    draft_.wall_cm = traits.wall_cm;
    draft_.outer_cm = traits.outer_cm;
    corridor_ = Take(RoomType::kCorridor);
  }

  std::optional<Draft> Run() {
    if (!Build()) return std::nullopt;
    return std::move(draft_);
  }

 private:
  bool Build() {
    switch (traits_.archetype) {
      case Archetype::kBlockWing:
        return BuildBlockWing();
      case Archetype::kFlat:
        return BuildFlat();
      case Archetype::kGallery:
        return BuildGallery();
      case Archetype::kHub:
        return rng_->Chance(0.6) ? BuildBlockWing() : BuildFlat();
      case Archetype::kElbow:
        return BuildElbow();
      case Archetype::kSplit:
        return BuildSplit();
    }
    BULLETNAV_CHECK(false);
  }

  bool BuildBlockWing() {
    const std::vector<int> block = TakePublicRooms(0.9, 0.65);
    Wing wing = NewWing(corridor_, true);
    if (traits_.has_far_room) TakeFarRoom(&wing);
    wing.right_may_be_short = traits_.has_court;
    PlaceRest(Rest(), &wing);
    return BuildWing(wing, kEastward, &draft_, rng_) && AddBlock(block, wing);
  }

  bool BuildFlat() {
    Wing wing = NewWing(corridor_, true);
    wing.left.depth = Between(3.3f, 4.8f);
    wing.right.depth = Between(3.3f, 4.8f);
    if (rng_->Chance(0.65)) {
      wing.near_room = Take(RoomType::kLivingRoom);
      wing.near_on_left = rng_->Chance(0.5);
    }
    if (traits_.has_far_room) TakeFarRoom(&wing);
    PlaceRest(Rest(), &wing);
    return BuildWing(wing, kEastward, &draft_, rng_).has_value();
  }

  bool BuildGallery() {
    Wing wing = NewWing(corridor_, false);
    wing.left.depth = Between(3.6f, 4.9f);
    if (rng_->Chance(0.8)) wing.near_room = Take(RoomType::kLivingRoom);
    if (traits_.has_far_room) TakeFarRoom(&wing);
    PlaceRest(Rest(), &wing);
    return BuildWing(wing, kEastward, &draft_, rng_).has_value();
  }

  /// A first leg to the east with rooms to its north, then a second one to the south.
  bool BuildElbow() {
    const std::vector<int> block = TakePublicRooms(0.85, 0.6);
    Wing first = NewWing(corridor_, rng_->Chance(0.4));
    Wing leg = NewWing(corridor_, rng_->Chance(0.5));
    if (traits_.has_far_room) TakeFarRoom(&leg);
    std::vector<int> rest = Rest();
    rng_->Shuffle(rest);
    const auto share = static_cast<std::ptrdiff_t>(rest.size()) * rng_->Between(35, 60) / 100;
    PlaceRest({rest.begin(), rest.begin() + share}, &first);
    PlaceRest({rest.begin() + share, rest.end()}, &leg);
    if (first.left.slots.empty() || leg.left.slots.empty()) return false;
    // The outer corner belongs to one of the outer strips; the inner one to the first leg.
    const bool first_takes_corner = rng_->Chance(0.5);
    first.left_beyond = first_takes_corner ? leg.left.depth : 0;
    first.right_beyond = -first.corridor_width;
    leg.left_from = -first.corridor_width - (first_takes_corner ? 0 : first.left.depth);
    leg.right_from = first.right.slots.empty() ? 0 : first.right.depth;
    const std::optional<int> length = BuildWing(first, kEastward, &draft_, rng_);
    if (!length) return false;
    const Axes southward{{*length, first.corridor_width}, {0, 1}, {-1, 0}};
    return BuildWing(leg, southward, &draft_, rng_) && AddBlock(block, first);
  }

  bool BuildSplit() {
    std::vector<int> block = TakePublicRooms(1.0, 0.8);
    const int entry = Find(RoomType::kEntry);
    if (entry >= 0 && rng_->Chance(0.4)) block.push_back(Take(RoomType::kEntry));
    draft_.rooms.push_back({RoomType::kCorridor, 4.0f, {}});
    taken_.push_back(true);
    Wing east = NewWing(corridor_, true);
    Wing west = NewWing(static_cast<int>(draft_.rooms.size()) - 1, true);
    if (traits_.has_far_room) TakeFarRoom(&west);
    std::vector<int> rest = Rest();
    rng_->Shuffle(rest);
    const auto share = static_cast<std::ptrdiff_t>(rest.size()) * rng_->Between(40, 65) / 100;
    PlaceRest({rest.begin(), rest.begin() + share}, &east);
    PlaceRest({rest.begin() + share, rest.end()}, &west);
    if (!BuildWing(east, kEastward, &draft_, rng_) || !AddBlock(block, east)) return false;
    const int shift = rng_->Chance(0.5) ? 0 : SnapToGrid(rng_->Uniform(-200.0, 200.0));
    const Axes westward{{block_.x0, shift}, {-1, 0}, {0, 1}};
    return BuildWing(west, westward, &draft_, rng_).has_value();
  }

  Wing NewWing(int corridor, bool has_right) {
    Wing wing;
    wing.corridor = corridor;
    wing.corridor_width = draft_.Gross(traits_.corridor_m);
    wing.left.depth = Between(2.9f, 4.6f);
    if (has_right) wing.right.depth = Between(2.9f, 4.6f);
    return wing;
  }

  /// The public block closes the wing's near end. It may stand out from the strips.
  bool AddBlock(const std::vector<int>& rooms, const Wing& wing) {
    const auto jog = [&] {
      if (!traits_.has_long_block || rng_->Chance(0.4)) return 0;
      return rng_->Chance(0.75) ? Snapped(0.9, 3.2) : -Snapped(0.9, 1.8);
    };
    const int right_depth = wing.right.slots.empty() ? 0 : wing.right.depth;
    block_.y0 = -wing.left.depth - jog();
    block_.y1 = wing.corridor_width + right_depth + jog();
    if (right_depth == 0) block_.y1 += Snapped(0.0, 3.0);
    double area = 0.0;
    for (const int room : rooms) area += static_cast<double>(At(room).target) + 0.5;
    const double clear = static_cast<double>(draft_.Clear(block_.height()));
    const int width = draft_.Gross(static_cast<float>(area / clear));
    if (width < 300 || width > 1100) return false;
    block_.x0 = -width;
    SliceBlock(block_, rooms, &draft_, rng_);
    return true;
  }

  void TakeFarRoom(Wing* wing) {
    std::vector<int> sleeping;
    for (const int room : Rest()) {
      if (IsSleeping(draft_.type(room))) sleeping.push_back(room);
    }
    if (sleeping.empty()) return;
    wing->far_room = rng_->Chance(0.6) ? sleeping.front() : rng_->Pick(sleeping);
    wing->far_on_left = wing->right.depth == 0 || rng_->Chance(0.5);
    taken_[static_cast<std::size_t>(wing->far_room)] = true;
  }

  std::vector<int> TakePublicRooms(double dining_chance, double kitchen_chance) {
    std::vector<int> rooms = {Take(RoomType::kLivingRoom)};
    if (Find(RoomType::kDiningRoom) >= 0 && rng_->Chance(dining_chance)) {
      rooms.push_back(Take(RoomType::kDiningRoom));
    }
    if (rng_->Chance(kitchen_chance)) rooms.push_back(Take(RoomType::kKitchen));
    return rooms;
  }

  void PlaceRest(const std::vector<int>& rooms, Wing* wing) {
    std::vector<Bundle> bundles = MakeBundles(draft_, rooms, rng_);
    for (Bundle& bundle : bundles) {
      for (Slot& slot : bundle.slots) {
        if (draft_.type(slot.room) != RoomType::kEntry) continue;
        bundle.privacy -= rng_->Chance(0.7) ? 0.5 : 0.0;  // most entries lie by the living block
        if (traits_.has_porch) slot.porch_cm = Snapped(0.8, 1.6);
      }
    }
    if (traits_.has_branch && !has_branch_) {
      bundles.push_back({{Slot{.room = wing->corridor}}, rng_->Uniform(-0.2, 0.5)});
      has_branch_ = true;
    }
    Distribute(draft_, std::move(bundles), &wing->left, &wing->right, rng_);
  }

  DraftRoom& At(int room) { return draft_.rooms[static_cast<std::size_t>(room)]; }

  int Find(RoomType type) const {
    for (std::size_t i = 0; i < draft_.rooms.size(); ++i) {
      if (draft_.rooms[i].type == type && !taken_[i]) return static_cast<int>(i);
    }
    return -1;
  }

  int Take(RoomType type) {
    const int room = Find(type);
    BULLETNAV_CHECK_GE(room, 0);
    taken_[static_cast<std::size_t>(room)] = true;
    return room;
  }

  std::vector<int> Rest() const {
    std::vector<int> rest;
    for (std::size_t i = 0; i < taken_.size(); ++i) {
      if (!taken_[i]) rest.push_back(static_cast<int>(i));
    }
    return rest;
  }

  /// A random gross size for a clear one between the limits.
  int Between(float low, float high) {
    return draft_.Gross(
        static_cast<float>(rng_->Uniform(static_cast<double>(low), static_cast<double>(high))));
  }
  int Snapped(double low_m, double high_m) {
    return SnapToGrid(100.0 * rng_->Uniform(low_m, high_m));
  }

  Traits traits_;
  Rng* rng_;
  Draft draft_;
  std::vector<bool> taken_;
  int corridor_ = -1;
  bool has_branch_ = false;
  Box block_;
};

}  // namespace

Traits DrawTraits(const Program& program, const PlanOptions& options, Rng* rng) {
  const auto count = static_cast<int>(program.rooms.size());
  std::array<double, 6> weights = kArchetypeWeights[count <= 6 ? 0 : (count <= 9 ? 1 : 2)];
  // A second corridor is one more room.
  if (count == options.max_rooms) weights[static_cast<std::size_t>(Archetype::kSplit)] = 0.0;
  Traits traits;
  traits.archetype = static_cast<Archetype>(rng->Weighted(weights));
  traits.wall_cm = 2 * rng->Between(5, 7);
  traits.outer_cm = 2 * rng->Between(10, 15);
  const bool is_hub = traits.archetype == Archetype::kHub;
  traits.corridor_m = static_cast<float>(is_hub ? rng->Uniform(1.5, 1.8) : rng->Uniform(1.1, 1.5));
  traits.has_far_room = rng->Chance(0.4);
  traits.has_court = rng->Chance(0.25);
  // Beside a court or in a gallery the corridor lies at an outside wall already.
  const bool is_inside = !traits.has_court && traits.archetype != Archetype::kGallery;
  traits.has_branch = is_inside && !program.Has(RoomType::kEntry) && rng->Chance(0.5);
  traits.has_porch = rng->Chance(0.25);
  traits.has_long_block = rng->Chance(0.55);
  return traits;
}

std::optional<Draft> DrawDraft(const Program& program, const Traits& traits, Rng* rng) {
  return Sketch(program, traits, rng).Run();
}

}  // namespace bulletnav::sim::plan
