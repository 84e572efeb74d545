// SPDX-License-Identifier: MIT
#include "sim/scene/doors.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "sim/base/check.h"
#include "sim/math/rng.h"
#include "sim/math/rotation.h"

namespace bulletnav::sim {
namespace {

constexpr int kNone = -1;
constexpr int kShared = -2;

std::uint32_t ObjectOf(const DoorLeaf& door, const SceneMesh& mesh) {
  const auto found =
      std::find_if(mesh.objects.begin(), mesh.objects.end(), [&](const SceneObject& object) {
        return object.name == door.object;
      });
  BULLETNAV_CHECK(found != mesh.objects.end());
  return static_cast<std::uint32_t>(found - mesh.objects.begin());
}

/// The angle each door shall have.
std::vector<float> Wanted(const DoorSpec& spec, const std::string& scene,
                          const std::vector<DoorLeaf>& doors) {
  std::vector<float> angles;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < doors.size(); ++i) {
    angles.push_back(doors[i].angle);
    if (!doors[i].leads_outside) order.push_back(i);
  }
  if (!spec.turns()) return angles;
  std::size_t open = spec.state == DoorState::kOpen ? order.size() : 0;
  if (spec.open_share) {
    open =
        static_cast<std::size_t>(std::lround(*spec.open_share * static_cast<double>(order.size())));
    Rng(spec.seed, "doors").Fork(scene).Shuffle(order);
  }
  for (std::size_t k = 0; k < order.size(); ++k) {
    const DoorLeaf& door = doors[order[k]];
    angles[order[k]] = k < open ? door.open_angle : door.shut_angle;
  }
  return angles;
}

/// Moves the vertices of doors and of nothing else; the others' it copies.
class Turner {
 public:
  Turner(const std::vector<DoorLeaf>& doors, SceneMesh* mesh)
      : mesh_(*mesh), door_of_(mesh->objects.size(), kNone) {
    for (std::size_t i = 0; i < doors.size(); ++i) {
      door_of_[ObjectOf(doors[i], mesh_)] = static_cast<int>(i);
    }
    owner_.assign(mesh_.positions.size(), kNone);
    std::vector<bool> is_used(owner_.size(), false);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (const std::uint32_t v : mesh_.triangles[t]) {
        owner_[v] = !is_used[v] || owner_[v] == DoorOf(t) ? DoorOf(t) : kShared;
        is_used[v] = true;
      }
    }
  }

  void Turn(const std::vector<Eigen::Affine3f>& turns) {
    for (std::size_t v = 0; v < owner_.size(); ++v) {
      if (owner_[v] < 0) continue;
      mesh_.positions[v] = turns[static_cast<std::size_t>(owner_[v])] * mesh_.positions[v];
    }
    std::map<std::pair<int, std::uint32_t>, std::uint32_t> copies;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const int door = DoorOf(t);
      if (door == kNone) continue;
      for (std::uint32_t& v : mesh_.triangles[t]) {
        if (owner_[v] != kShared) continue;
        const auto [copy, is_new] = copies.try_emplace({door, v}, mesh_.positions.size());
        if (is_new) Copy(v, turns[static_cast<std::size_t>(door)]);
        v = copy->second;
      }
    }
  }

 private:
  int DoorOf(std::size_t triangle) const { return door_of_[mesh_.triangle_objects[triangle]]; }

  void Copy(std::uint32_t v, const Eigen::Affine3f& turn) {
    mesh_.positions.emplace_back(turn * mesh_.positions[v]);
    mesh_.uvs.push_back(Eigen::Vector2f(mesh_.uvs[v]));
    mesh_.colors.push_back(Rgb8(mesh_.colors[v]));
    owner_.push_back(kNone);
  }

  SceneMesh& mesh_;
  std::vector<int> door_of_;  // an object
  std::vector<int> owner_;    // a vertex
};

/// Metres from its hinge to the farthest corner of a leaf, seen along the hinge.
float LeafWidth(const DoorLeaf& door, const SceneMesh& mesh) {
  const std::uint32_t object = ObjectOf(door, mesh);
  float width = 0.0f;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.triangle_objects[t] != object) continue;
    for (const std::uint32_t v : mesh.triangles[t]) {
      width = std::max(width, (mesh.positions[v] - door.hinge).cross(door.axis).norm());
    }
  }
  return width;
}

}  // namespace

void SetDoors(const DoorSpec& spec, const std::string& scene, std::vector<DoorLeaf>* doors,
              SceneMesh* mesh) {
  const std::vector<float> angles = Wanted(spec, scene, *doors);
  std::vector<DoorLeaf> moved;
  std::vector<Eigen::Affine3f> turns;
  for (std::size_t i = 0; i < doors->size(); ++i) {
    DoorLeaf& door = (*doors)[i];
    door.width = LeafWidth(door, *mesh);
    if (angles[i] == door.angle) continue;
    turns.push_back(Eigen::Translation3f(door.hinge) *
                    Eigen::Affine3f(RotationAbout<float>(door.axis, angles[i] - door.angle)) *
                    Eigen::Translation3f(-door.hinge));
    door.angle = angles[i];
    moved.push_back(door);
  }
  if (!moved.empty()) Turner(moved, mesh).Turn(turns);
}

}  // namespace bulletnav::sim
