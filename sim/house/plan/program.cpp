// SPDX-License-Identifier: MIT
#include "sim/house/plan/program.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/house/plan/rules.h"

namespace bulletnav::sim::plan {
namespace {

struct Wish {
  RoomType type = RoomType::kStorage;
  int limit = 1;      // most rooms of this type in a house
  int from = 0;       // rooms a house has before anyone asks for it
  double weight = 1;  // against other wishes
};

constexpr std::array kWishes = {
    Wish{RoomType::kBedroom, 3, 5, 3.0},    Wish{RoomType::kKidsRoom, 2, 5, 2.2},
    Wish{RoomType::kDiningRoom, 1, 6, 2.2}, Wish{RoomType::kEntry, 1, 5, 2.4},
    Wish{RoomType::kStudy, 1, 6, 1.3},      Wish{RoomType::kToilet, 1, 6, 1.4},
    Wish{RoomType::kLaundry, 1, 7, 1.2},    Wish{RoomType::kStorage, 2, 6, 1.3},
    Wish{RoomType::kBathroom, 2, 8, 1.8},
};

int Count(const std::vector<RoomType>& types, RoomType type) {
  return static_cast<int>(std::count(types.begin(), types.end(), type));
}

double WeightOf(const Wish& wish, const std::vector<RoomType>& types) {
  const int sleeping = Count(types, RoomType::kBedroom) + Count(types, RoomType::kKidsRoom);
  const int have = Count(types, wish.type);
  if (have >= wish.limit || static_cast<int>(types.size()) < wish.from) return 0.0;
  if (IsSleeping(wish.type) && sleeping >= 4) return 0.0;
  if (wish.type == RoomType::kBathroom && sleeping < 2) return 0.0;
  return have == 0 || IsSleeping(wish.type) ? wish.weight : 0.5 * wish.weight;
}

std::vector<RoomType> DrawTypes(int count, Rng* rng) {
  std::vector<RoomType> types = {RoomType::kLivingRoom, RoomType::kKitchen, RoomType::kBathroom,
                                 RoomType::kBedroom, RoomType::kCorridor};
  while (static_cast<int>(types.size()) < count) {
    std::array<double, kWishes.size()> weights{};
    for (std::size_t i = 0; i < kWishes.size(); ++i) weights[i] = WeightOf(kWishes[i], types);
    types.push_back(kWishes[rng->Weighted(weights)].type);
  }
  return types;
}

}  // namespace

bool Program::Has(RoomType type) const {
  return Find(type) >= 0;
}

int Program::Find(RoomType type) const {
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    if (rooms[i].type == type) return static_cast<int>(i);
  }
  return -1;
}

Program DrawProgram(const PlanOptions& options, Rng* rng) {
  Program program;
  const int count = rng->Between(options.min_rooms, options.max_rooms);
  const double by_count = static_cast<double>(count - 5) / 7.0;
  program.size = std::clamp(by_count + 0.22 * rng->Normal(), 0.0, 1.0);
  for (const RoomType type : DrawTypes(count, rng)) {
    const RoomRule& rule = RuleOf(type);
    const double wanted = std::lerp(static_cast<double>(rule.small_target),
                                    static_cast<double>(rule.large_target), program.size);
    program.rooms.push_back({type, static_cast<float>(wanted * rng->Uniform(0.9, 1.12)), {}});
  }
  program.rooms[3].target += static_cast<float>(rng->Uniform(0.5, 3.5));  // the parents' bedroom
  // A flat without a dining room eats in the living room or the kitchen.
  if (!program.Has(RoomType::kDiningRoom)) {
    program.rooms[0].target += static_cast<float>(rng->Uniform(0.0, 5.0));
    program.rooms[1].target += static_cast<float>(rng->Uniform(0.0, 3.0));
  }
  return program;
}

}  // namespace bulletnav::sim::plan
