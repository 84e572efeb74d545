// SPDX-License-Identifier: MIT
#include <cmath>

#include "sim/base/error.h"
#include "sim/config/yaml_reader.h"
#include "sim/config/yaml_writer.h"
#include "sim/scene/doors.h"

namespace bulletnav::sim {
namespace {

/// The share as YAML has it.
struct Share {
  double open_share = 1.0;
  std::uint64_t seed = 0;

  template <class V>
  void Visit(V& v) {
    v.Required("open_share", open_share);
    v("seed", seed);
  }
  void Validate() const { DoorSpec{.open_share = open_share, .seed = seed}.Validate(); }
};

}  // namespace

void DoorSpec::Validate() const {
  if (open_share && !(*open_share >= 0.0 && *open_share <= 1.0)) {
    throw Error("open_share must be from 0 to 1");
  }
}

std::string DoorSpec::ToYaml() const {
  if (!open_share) return std::string(NameOf(state));
  YamlWriter writer;
  writer.Write(Share{*open_share, seed});
  return writer.text();
}

void ReadYaml(const YamlNode& node, DoorSpec& value) {
  value = {};
  if (!node.yaml().IsMap()) {
    YamlReader::Read(node, value.state);
    return;
  }
  Share share;
  YamlReader::Read(node, share);
  value.open_share = share.open_share;
  value.seed = share.seed;
}

}  // namespace bulletnav::sim
