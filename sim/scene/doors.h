// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "sim/config/enum_names.h"
#include "sim/scene/mesh.h"

namespace bulletnav::sim {

class YamlNode;

/// A door's leaf, which can be turned about its hinge. Angles in radians, 0 where it is shut.
struct DoorLeaf {
  std::string object;                               // its name in SceneMesh::objects
  Eigen::Vector3f hinge = Eigen::Vector3f::Zero();  // a point of the hinge's axis
  Eigen::Vector3f axis = Eigen::Vector3f::UnitY();  // unit; the leaf opens by positive turns
  float angle = 0.0f;                               // how far it stands open now
  float shut_angle = 0.0f;                          // where it is when closed
  float open_angle = 0.0f;                          // and when open
  float width = 0.0f;                               // metres from the hinge to the far edge
  bool leads_outside = false;                       // it stays as it is

  bool is_open() const { return angle != shut_angle; }
};

enum class DoorState { kAsBuilt, kOpen, kClosed };

template <>
struct EnumNames<DoorState> {
  static constexpr std::array kNames = {std::pair{"as_built", DoorState::kAsBuilt},
                                        std::pair{"open", DoorState::kOpen},
                                        std::pair{"closed", DoorState::kClosed}};
};

/// How the doors of a scene stand: all in one state, or a share of them open and the others closed.
/// In YAML the name of a state, or `{open_share: 0.5, seed: 3}`.
struct DoorSpec {
  DoorState state = DoorState::kAsBuilt;  // where no share is given
  std::optional<double> open_share = std::nullopt;
  std::uint64_t seed = 0;  // other doors for another seed

  bool turns() const { return open_share || state != DoorState::kAsBuilt; }
  /// Throws Error.
  void Validate() const;
  std::string ToYaml() const;
  bool operator==(const DoorSpec&) const = default;
};

/// For YamlReader. Throws FileError.
void ReadYaml(const YamlNode& node, DoorSpec& value);

/// Turns leaves about their hinges, in the mesh and in `doors`, as the spec says, and measures
/// their widths; those that lead outside stay. Of a share, round(share * n) of the n others are
/// open: a draw from the seed and `scene`, a name. Light that is baked into colours stays as it
/// was. The same bits on every processor. Expects: doors of this mesh (checked).
void SetDoors(const DoorSpec& spec, const std::string& scene, std::vector<DoorLeaf>* doors,
              SceneMesh* mesh);

}  // namespace bulletnav::sim
