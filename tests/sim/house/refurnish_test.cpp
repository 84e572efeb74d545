// SPDX-License-Identifier: MIT
#include "sim/house/refurnish.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "tests/sim/house/furnished_home.h"

namespace bulletnav::sim {
namespace {

using Home = FurnishedHome;

/// Kinds and places of what is in a room.
std::vector<std::pair<std::string, Eigen::Vector3f>> In(int room, const Home& home) {
  std::vector<std::pair<std::string, Eigen::Vector3f>> pieces;
  for (const Furnishing& piece : home.furniture) {
    if (piece.room == room) pieces.emplace_back(piece.kind, piece.position);
  }
  return pieces;
}

std::set<int> RoomsThatDiffer(const Home& a, const Home& b) {
  std::set<int> rooms;
  for (int i = 0; i < static_cast<int>(a.plan.rooms.size()); ++i) {
    if (In(i, a) != In(i, b)) rooms.insert(i);
  }
  return rooms;
}

TEST(Refurnish, OnlyItsShareOfTheRoomsIsFurnishedAnew) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const Home before = Furnished(seed, {});
    const Home after = Furnished(seed, {.share = 0.3});
    const auto rooms = static_cast<double>(before.plan.rooms.size());
    const std::set<int> differ = RoomsThatDiffer(before, after);
    EXPECT_LE(differ.size(), std::max(1.0, std::round(0.3 * rooms))) << seed;
    EXPECT_TRUE(RoomsThatDiffer(after, Furnished(seed, {.share = 0.3})).empty()) << seed;
    EXPECT_TRUE(RoomsThatDiffer(before, Furnished(seed, {.share = 0.0, .seed = 9})).empty());
  }
}

TEST(Refurnish, AllRoomsDifferWhereAllAre) {
  int differ = 0;
  int rooms = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const Home before = Furnished(seed, {});
    differ += static_cast<int>(RoomsThatDiffer(before, Furnished(seed, {.share = 1.0})).size());
    rooms += static_cast<int>(before.plan.rooms.size());
  }
  EXPECT_GT(differ, 0.9 * rooms);  // a storage room may get the same shelf again
}

TEST(Refurnish, ItsSeedChoosesTheRooms) {
  bool is_other = false;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Home before = Furnished(seed, {});
    is_other = is_other || RoomsThatDiffer(before, Furnished(seed, {.share = 0.3, .seed = 1})) !=
                               RoomsThatDiffer(before, Furnished(seed, {.share = 0.3, .seed = 2}));
  }
  EXPECT_TRUE(is_other);
}

TEST(Refurnish, OneRoomAtLeast) {
  const Rng rng(1, "house");
  const std::vector<Rng> rngs = RoomRngs(rng, 9, {.share = 0.01});
  const auto anew = std::count_if(rngs.begin(), rngs.end(), [&](const Rng& room) {
    Rng mine = room;
    Rng its = rng;
    return mine.Next() != its.Next();
  });
  EXPECT_EQ(anew, 1);
  EXPECT_TRUE(RoomRngs(rng, 0, {.share = 0.5}).empty());
}

TEST(Refurnish, SharesOutOfRangeAreRefused) {
  EXPECT_THROW(Refurnish{.share = 1.5}.Validate(), Error);
  EXPECT_THROW(Refurnish{.share = std::nan("")}.Validate(), Error);
  EXPECT_NO_THROW(Refurnish{.share = 1.0}.Validate());
}

}  // namespace
}  // namespace bulletnav::sim
