// SPDX-License-Identifier: MIT
#include "sim/import/articulated_object.h"

#include "sim/import/door_joint.h"
#include "sim/math/rotation.h"

namespace bulletnav::sim {
namespace {

constexpr int kNoDoor = -1;

struct PlacedLink {
  Eigen::Affine3f X_WL = Eigen::Affine3f::Identity();  // with the object's scale
  int door = kNoDoor;
};

/// From the joint's axes to the child link's.
Eigen::Affine3f MotionOf(const UrdfJoint& joint, double position, float scale) {
  if (joint.type == UrdfJointType::kPrismatic) {
    return Eigen::Affine3f(Eigen::Translation3f(static_cast<float>(position) / scale * joint.axis));
  }
  return Eigen::Affine3f(RotationAbout<double>(joint.axis.cast<double>(), position).cast<float>());
}

std::optional<DoorLeaf> DoorOf(const UrdfJoint& joint, const Eigen::Affine3f& X_WJ,
                               double position) {
  if (joint.type != UrdfJointType::kRevolute) return std::nullopt;
  TurningJoint turning;
  turning.hinge = X_WJ.translation();
  turning.axis = (X_WJ.linear() * joint.axis).normalized();
  turning.lower = joint.lower;
  turning.upper = joint.upper;
  turning.position = position;
  turning.angle_at_zero = joint.angle_at_zero;
  return LeafOn(turning, Eigen::Vector3f::UnitY());
}

void AddVisuals(const UrdfLink& link, const PlacedLink& placed, const ArticulatedObject& object,
                SceneParts* scene) {
  for (const UrdfVisual& visual : link.visuals) {
    ScenePart part;
    part.asset = visual.asset;
    part.mesh = visual.shape;
    part.X_WA = placed.X_WL * visual.X_LA;
    part.place = object.place + ", link '" + link.name + "'";
    part.object = {object.category, object.name, ""};
    part.door = placed.door;
    if (placed.door != kNoDoor) part.object = {"door", object.name + "::" + link.name, ""};
    scene->parts.push_back(std::move(part));
  }
}

}  // namespace

void AddArticulated(const Urdf& model, const ArticulatedObject& object, SceneParts* scene) {
  PlacedLink root;
  root.X_WL = object.X_WR;
  root.X_WL.linear() *= object.scale;
  std::vector<PlacedLink> links(model.links.size(), root);
  std::size_t moving = 0;
  for (const UrdfJoint& joint : model.joints) {
    const PlacedLink& parent = links[joint.parent];
    PlacedLink& child = links[joint.child];
    child.door = parent.door;
    child.X_WL = parent.X_WL * joint.X_PJ;
    if (!joint.moves()) continue;
    const double position = moving < object.positions.size() ? object.positions[moving] : 0.0;
    ++moving;
    const std::optional<DoorLeaf> door = DoorOf(joint, child.X_WL, position);
    if (door && child.door == kNoDoor) {
      child.door = static_cast<int>(scene->doors.size());
      scene->doors.push_back(*door);
    }
    if (position != 0.0) child.X_WL = child.X_WL * MotionOf(joint, position, object.scale);
  }
  for (std::size_t i = 0; i < links.size(); ++i) {
    AddVisuals(model.links[i], links[i], object, scene);
  }
}

}  // namespace bulletnav::sim
