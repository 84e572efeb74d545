// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>
#include <utility>

#include "sim/config/yaml_reader.h"
#include "sim/scene/import.h"

template <>
struct bulletnav::sim::EnumNames<bulletnav::sim::UpAxis> {
  static constexpr std::array kNames = {std::pair{"y", bulletnav::sim::UpAxis::kY},
                                        std::pair{"z", bulletnav::sim::UpAxis::kZ}};
};

namespace bulletnav::bench {

/// sim::ImportOptions as a block of a config.
struct ImportSpec {
  std::optional<sim::UpAxis> up;  // found from the mesh if not given
  double scale = 1.0;
  bool ground_plane = false;
  std::optional<sim::DoorSpec> doors;
  std::optional<sim::Finish> finish;

  sim::ImportOptions options() const {
    return {up, scale, ground_plane, doors, finish.value_or(sim::Finish{})};
  }

  template <class V>
  void Visit(V& v) {
    v("up", up);
    v("scale", scale);
    v("ground_plane", ground_plane);
    v("doors", doors);
    v("finish", finish);
  }
  void Validate() const {
    if (!(scale > 0.0)) throw sim::Error("scale must be positive");
  }
};

}  // namespace bulletnav::bench
