// SPDX-License-Identifier: MIT
#include "sim/import/house_doors.h"

#include <algorithm>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/config/json_node.h"
#include "sim/math/pose.h"

namespace bulletnav::sim {
namespace {

using Json = FloatJson;
using Node = JsonNode<Json>;
using Vec = Eigen::Vector3f;

constexpr const char* kRemedy =
    "generate the house again, or delete this file and leave out import.doors";

/// Plans are the world's (x, z).
Vec PointOf(const Node& node) {
  node.ExpectList(2);
  return {node.Item(0).Number(), 0.0f, node.Item(1).Number()};
}

/// sim/house/floor_plan.h says how openings are meant; it is of a higher floor.
DoorLeaf LeafOf(const Node& opening, int number) {
  const Node leaf = opening.At("leaf");
  const std::string hinge = leaf.At("hinge").Text();
  if (hinge != "a" && hinge != "b") leaf.At("hinge").Fail("'" + hinge + "' is not one of: a, b");
  const Vec a = PointOf(opening.At("a"));
  const Vec b = PointOf(opening.At("b"));
  if (a == b) opening.Fail("has no length: a and b are the same point");
  const Vec to_a = Vec::UnitY().cross((b - a).normalized());  // to the left of the way to b
  const bool opens_into_a = leaf.At("opens_into").value() == opening.At("rooms").Item(0).value();
  const Vec swing = opens_into_a ? to_a : Vec(-to_a);
  DoorLeaf door;
  door.object = "door_" + std::to_string(number);
  door.hinge = (hinge == "a" ? a : b) + 0.5f * opening.At("wall_thickness").Positive() * swing;
  // A leaf that lies to the left of its hinge opens to the left, counter-clockwise from above.
  if ((hinge == "a") != opens_into_a) door.axis = -Vec::UnitY();
  door.angle = leaf.At("angle").Number();
  door.open_angle = door.angle > 0.0f ? door.angle : static_cast<float>(0.5 * kPi);
  door.leads_outside = opening.At("rooms").Item(1).IsNull();
  return door;
}

}  // namespace

std::optional<std::vector<DoorLeaf>> ReadHouseDoors(const std::filesystem::path& mesh) {
  const std::filesystem::path file = std::filesystem::path(mesh).replace_extension(".json");
  std::error_code unreadable;
  if (file == mesh || !std::filesystem::exists(file, unreadable)) return std::nullopt;
  const Json document = ParseJson<Json>(ReadTextFile(file), file, 1, kRemedy);
  const Node openings = Node(document, file, "", kRemedy).At("openings");
  const std::size_t n = openings.Size();
  std::vector<DoorLeaf> doors;
  for (std::size_t i = 0; i < n; ++i) {
    const Node opening = openings.Item(i);
    if (opening.At("leaf").IsNull()) continue;
    opening.At("rooms").ExpectList(2);
    doors.push_back(LeafOf(opening, static_cast<int>(doors.size()) + 1));
  }
  return doors;
}

void RequireLeaves(const std::filesystem::path& file, const std::vector<DoorLeaf>& doors,
                   const SceneMesh& mesh) {
  for (const DoorLeaf& door : doors) {
    const bool is_there =
        std::any_of(mesh.objects.begin(), mesh.objects.end(), [&](const SceneObject& object) {
          return object.name == door.object;
        });
    if (is_there) continue;
    throw FileError(file, "",
                    "its doors cannot be turned: it has no object '" + door.object +
                        "'; generate the house again, or leave out import.doors");
  }
}

}  // namespace bulletnav::sim
