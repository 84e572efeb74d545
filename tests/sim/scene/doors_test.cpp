// SPDX-License-Identifier: MIT
#include "sim/scene/doors.h"

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/config/yaml_reader.h"
#include "sim/config/yaml_writer.h"
#include "sim/math/pose.h"

namespace bulletnav::sim {
namespace {

using Vec = Eigen::Vector3f;

constexpr auto kQuarter = static_cast<float>(0.5 * kPi);

/// `count` leaves, 1 m wide and shut, each hanging by its two inner corners on a wall's triangle.
struct Row {
  SceneMesh mesh;
  std::vector<DoorLeaf> doors;

  explicit Row(int count) {
    mesh.materials.emplace_back();
    mesh.objects = {{}, {"wall", "wall_1", ""}};
    for (int i = 0; i < count; ++i) {
      const auto z = static_cast<float>(2 * i);
      const auto base = static_cast<std::uint32_t>(mesh.positions.size());
      for (const Vec& p : {Vec(0, 0, z), Vec(0, 2, z), Vec(1, 0, z), Vec(-1, 0, z)}) {
        mesh.positions.push_back(p);
        mesh.uvs.emplace_back(0.0f, 0.0f);
        mesh.colors.push_back(kWhite);
      }
      mesh.triangles.push_back({base, base + 1, base + 2});
      mesh.triangles.push_back({base, base + 1, base + 3});
      mesh.triangle_materials.insert(mesh.triangle_materials.end(), 2, 0);
      DoorLeaf door;
      door.object = "door_" + std::to_string(i + 1);
      door.hinge = Vec(0, 0, z);
      door.open_angle = kQuarter;
      mesh.objects.push_back({"door", door.object, ""});
      mesh.triangle_objects.insert(mesh.triangle_objects.end(),
                                   {static_cast<std::uint32_t>(mesh.objects.size()) - 1, 1});
      doors.push_back(door);
    }
  }

  int open() const {
    return static_cast<int>(std::count_if(doors.begin(), doors.end(), [](const DoorLeaf& door) {
      return door.is_open();
    }));
  }
  Vec Corner(std::size_t triangle, std::size_t k) const {
    return mesh.positions[mesh.triangles[triangle][k]];
  }
};

TEST(SetDoors, TurnsALeafAboutItsHingeAndNothingElse) {
  Row row(2);
  row.doors[1].axis = -Vec::UnitY();
  const Row before = row;
  SetDoors({.state = DoorState::kOpen}, "scene", &row.doors, &row.mesh);
  row.mesh.Validate();
  EXPECT_TRUE(row.Corner(0, 2).isApprox(Vec(0, 0, -1), 1e-6f));  // to the left
  EXPECT_TRUE(row.Corner(2, 2).isApprox(Vec(0, 0, 3), 1e-6f));   // to the right
  for (const std::size_t wall : {1u, 3u}) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(row.Corner(wall, k), before.Corner(wall, k));
  }
  EXPECT_FLOAT_EQ(row.doors[0].angle, kQuarter);
  EXPECT_FLOAT_EQ(row.doors[0].width, 1.0f);
  SetDoors({.state = DoorState::kClosed}, "scene", &row.doors, &row.mesh);
  for (const std::size_t leaf : {0u, 2u}) {
    EXPECT_LT((row.Corner(leaf, 2) - before.Corner(leaf, 2)).norm(), 1e-6f);
  }
}

TEST(SetDoors, LeavesAMeshAsItIsWithoutChange) {
  Row row(3);
  row.doors[0].leads_outside = true;
  const Row before = row;
  for (const DoorState state : {DoorState::kAsBuilt, DoorState::kClosed}) {
    SetDoors({.state = state}, "scene", &row.doors, &row.mesh);
    EXPECT_EQ(row.mesh.positions, before.mesh.positions);
  }
  SetDoors({.state = DoorState::kOpen}, "scene", &row.doors, &row.mesh);
  EXPECT_FALSE(row.doors[0].is_open());
  EXPECT_EQ(row.open(), 2);
}

TEST(SetDoors, OpensTheShareOfDoorsThatIsAskedFor) {
  std::set<std::vector<bool>> draws;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    for (const auto& [share, open] : {std::pair{0.0, 0}, {0.25, 2}, {0.5, 3}, {1.0, 6}}) {
      Row row(7);
      row.doors[2].leads_outside = true;
      SetDoors({.open_share = share, .seed = seed}, "scene", &row.doors, &row.mesh);
      EXPECT_EQ(row.open(), open) << share;
      Row again(7);
      again.doors[2].leads_outside = true;
      SetDoors({.open_share = share, .seed = seed}, "scene", &again.doors, &again.mesh);
      EXPECT_EQ(again.mesh.positions, row.mesh.positions);
      std::vector<bool> states;
      for (const DoorLeaf& door : row.doors) states.push_back(door.is_open());
      if (share == 0.5) draws.insert(states);
    }
  }
  EXPECT_GT(draws.size(), 4u);
}

struct Block {
  std::optional<DoorSpec> doors;

  template <class V>
  void Visit(V& v) {
    v("doors", doors);
  }
};

std::string ErrorOf(const std::string& text) {
  try {
    LoadYamlText<Block>(text, "c.yaml");
  } catch (const Error& e) {
    return e.what();
  }
  return "no error";
}

TEST(DoorSpec, IsAStateOrAShareInYaml) {
  EXPECT_EQ(LoadYamlText<Block>("doors: closed", "c.yaml").doors->state, DoorState::kClosed);
  const Block share = LoadYamlText<Block>("doors: {open_share: 0.5, seed: 3}", "c.yaml");
  EXPECT_EQ(*share.doors, (DoorSpec{.open_share = 0.5, .seed = 3}));
  for (const char* text : {"{}", "doors: as_built", "doors: {open_share: 0.25, seed: 7}"}) {
    const Block block = LoadYamlText<Block>(text, "c.yaml");
    YamlWriter writer;
    writer.Write(block);
    EXPECT_EQ(LoadYamlText<Block>(writer.text(), "c.yaml").doors, block.doors) << writer.text();
  }
}

TEST(DoorSpec, SaysWhatIsWrong) {
  using testing::HasSubstr;
  EXPECT_THAT(ErrorOf("doors: shut"),
              HasSubstr("c.yaml:1:8: 'shut' is not one of: as_built, open, closed"));
  EXPECT_THAT(ErrorOf("doors: {open_share: 1.5}"), HasSubstr("open_share must be from 0 to 1"));
  EXPECT_THAT(ErrorOf("doors: {seed: 3}"), HasSubstr("open_share"));
  EXPECT_THAT(ErrorOf("doors: {open_shar: 0.5}"), HasSubstr("open_share"));
}

}  // namespace
}  // namespace bulletnav::sim
