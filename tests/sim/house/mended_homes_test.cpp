// SPDX-License-Identifier: MIT
// What people would notice at once in a furnished home.
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/house/furniture.h"
#include "sim/house/shell/faces.h"
#include "sim/house/shell/room_shell.h"
#include "sim/math/rotation.h"
#include "tests/sim/house/furnished_home.h"

namespace bulletnav::sim {
namespace {

constexpr std::uint64_t kHomes = 40;

using Home = FurnishedHome;

/// Made once for all tests.
const std::vector<Home>& Homes() {
  static const std::vector<Home> homes = [] {
    std::vector<Home> made;
    for (std::uint64_t seed = 0; seed < kHomes; ++seed) made.push_back(Furnished(seed));
    return made;
  }();
  return homes;
}

Eigen::Affine3f PoseOf(const Furnishing& piece) {
  return Eigen::Translation3f(piece.position) *
         RotationAbout<float>(Eigen::Vector3f::UnitY(), piece.yaw);
}

/// Where it is in the frame of a side of its room.
Eigen::AlignedBox3f SeenFrom(const shell::Side& side, const Furnishing& piece) {
  const Eigen::Affine3f pose = shell::FaceFrame(side.left, side.right).inverse() * PoseOf(piece);
  const Eigen::AlignedBox3f box(piece.low, piece.high);
  Eigen::AlignedBox3f seen;
  for (int i = 0; i < 8; ++i) {
    seen.extend(pose * box.corner(static_cast<Eigen::AlignedBox3f::CornerType>(i)));
  }
  return seen;
}

/// Whether there is wall, and no hole, behind all of it.
bool HangsOnWall(const Home& home, const Furnishing& piece) {
  const std::vector<shell::Side> sides = shell::SidesOf(home.plan, home.style, piece.room);
  return std::any_of(sides.begin(), sides.end(), [&](const shell::Side& side) {
    const Eigen::AlignedBox3f seen = SeenFrom(side, piece);
    constexpr float kTouch = 0.03f;
    const bool touches = std::abs(seen.min().z()) <= kTouch && seen.min().x() >= -0.001f &&
                         seen.max().x() <= side.length() + 0.001f;
    return touches && std::none_of(side.holes.begin(), side.holes.end(), [&](const auto& hole) {
             return seen.max().x() > hole.x0 && seen.min().x() < hole.x1 &&
                    seen.max().y() > hole.bottom && seen.min().y() < hole.top;
           });
  });
}

std::string NameOf(std::uint64_t seed, const Home& home, const Furnishing& piece) {
  return " " + std::to_string(seed) + ":" +
         home.plan.rooms[static_cast<std::size_t>(piece.room)].name + ":" + piece.kind;
}

TEST(MendedHomes, WhatHangsHasAWallBehindIt) {
  std::string floating;
  for (std::uint64_t seed = 0; seed < kHomes; ++seed) {
    const Home& home = Homes()[seed];
    for (const Furnishing& piece : home.furniture) {
      if (FindFurniture(piece.kind).placement != Placement::kOnWall) continue;
      if (!HangsOnWall(home, piece)) floating += NameOf(seed, home, piece);
    }
  }
  EXPECT_EQ(floating, "");
}

TEST(MendedHomes, EveryDeskHasAChair) {
  std::string lacking;
  for (std::uint64_t seed = 0; seed < kHomes; ++seed) {
    const Home& home = Homes()[seed];
    for (const Furnishing& desk : home.furniture) {
      if (desk.kind != "desk") continue;
      const Eigen::Vector3f before = PoseOf(desk) * Eigen::Vector3f(0, 0, desk.high.z() + 0.2f);
      const bool has_chair =
          std::any_of(home.furniture.begin(), home.furniture.end(), [&](const Furnishing& chair) {
            return chair.kind == "office_chair" && (chair.position - before).norm() < 0.6f;
          });
      if (!has_chair) lacking += NameOf(seed, home, desk);
    }
  }
  EXPECT_EQ(lacking, "");
}

TEST(MendedHomes, EveryBathroomHasAToiletAndEveryStudyADesk) {
  static const std::map<RoomType, std::string> wanted = {
      {RoomType::kBathroom, "toilet"}, {RoomType::kToilet, "toilet"}, {RoomType::kStudy, "desk"}};
  std::string lacking;
  for (std::uint64_t seed = 0; seed < kHomes; ++seed) {
    const Home& home = Homes()[seed];
    for (std::size_t i = 0; i < home.plan.rooms.size(); ++i) {
      const auto want = wanted.find(home.plan.rooms[i].type);
      if (want == wanted.end()) continue;
      const bool has = std::any_of(home.furniture.begin(), home.furniture.end(), [&](auto& piece) {
        return piece.room == static_cast<int>(i) && piece.kind == want->second;
      });
      if (!has) lacking += " " + std::to_string(seed) + ":" + home.plan.rooms[i].name;
    }
  }
  EXPECT_EQ(lacking, "");
}

}  // namespace
}  // namespace bulletnav::sim
