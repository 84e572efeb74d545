// SPDX-License-Identifier: MIT
#include "sim/house/plan/rules.h"

#include <algorithm>
#include <array>

#include "sim/base/check.h"

namespace bulletnav::sim::plan {
namespace {

// type, min and max area, min side, max aspect, small and large target, privacy, window wall
constexpr std::array kRules = {
    RoomRule{RoomType::kLivingRoom, 15.0f, 48.0f, 3.2f, 2.0f, 20.0f, 38.0f, 0.0f, 2.5f},
    RoomRule{RoomType::kKitchen, 6.5f, 20.0f, 2.1f, 2.2f, 8.5f, 16.5f, 0.05f, 1.75f},
    RoomRule{RoomType::kDiningRoom, 8.0f, 22.0f, 2.6f, 1.9f, 10.0f, 18.0f, 0.03f, 2.25f},
    RoomRule{RoomType::kBedroom, 8.5f, 24.0f, 2.6f, 1.8f, 11.0f, 16.5f, 0.85f, 2.05f},
    RoomRule{RoomType::kKidsRoom, 8.0f, 18.0f, 2.5f, 1.8f, 9.5f, 14.5f, 0.75f, 1.95f},
    RoomRule{RoomType::kBathroom, 3.6f, 9.0f, 1.6f, 2.2f, 4.8f, 7.2f, 0.65f, 0.0f},
    RoomRule{RoomType::kToilet, 1.5f, 3.0f, 0.95f, 2.4f, 1.8f, 2.2f, 0.2f, 0.0f},
    RoomRule{RoomType::kCorridor, 1.6f, 30.0f, kMinCorridor, 99.0f, 5.0f, 12.0f, 0.5f, 0.0f},
    RoomRule{RoomType::kEntry, 2.6f, 12.0f, 1.35f, 3.0f, 4.0f, 8.0f, 0.12f, 0.0f},
    RoomRule{RoomType::kStudy, 6.0f, 16.0f, 2.2f, 1.9f, 8.0f, 12.0f, 0.4f, 1.95f},
    RoomRule{RoomType::kLaundry, 3.0f, 9.0f, 1.5f, 2.4f, 3.8f, 6.0f, 0.25f, 0.0f},
    RoomRule{RoomType::kStorage, 1.5f, 7.0f, 1.0f, 2.6f, 2.2f, 4.2f, 0.4f, 0.0f},
};

}  // namespace

const RoomRule& RuleOf(RoomType type) {
  BULLETNAV_CHECK_LT(static_cast<std::size_t>(type), kRules.size());
  const auto& rule = kRules[static_cast<std::size_t>(type)];
  BULLETNAV_CHECK(rule.type == type);
  return rule;
}

bool IsCirculation(RoomType type) {
  using enum RoomType;
  static constexpr std::array kThrough = {kCorridor,  kEntry,     kLobby,       kOpenOffice,
                                          kReception, kShopFloor, kWaitingRoom, kWarehouse,
                                          kWorkshop,  kStudio};
  return std::find(kThrough.begin(), kThrough.end(), type) != kThrough.end();
}

bool IsSleeping(RoomType type) {
  return type == RoomType::kBedroom || type == RoomType::kKidsRoom;
}

bool IsWet(RoomType type) {
  return type == RoomType::kKitchen || type == RoomType::kBathroom || type == RoomType::kToilet ||
         type == RoomType::kLaundry;
}

bool IsPublic(RoomType type) {
  return type == RoomType::kLivingRoom || type == RoomType::kDiningRoom ||
         type == RoomType::kKitchen;
}

bool IsSmall(RoomType type) {
  return type == RoomType::kBathroom || type == RoomType::kToilet || type == RoomType::kLaundry ||
         type == RoomType::kStorage || type == RoomType::kRestroom ||
         type == RoomType::kFittingRoom || type == RoomType::kTechnicalRoom;
}

}  // namespace bulletnav::sim::plan
