// SPDX-License-Identifier: MIT
#include <array>
#include <string>
#include <vector>

#include "sim/base/error.h"
#include "sim/config/yaml_reader.h"
#include "sim/house/building/kind.h"

namespace bulletnav::sim::building {

std::span<const BuildingKind* const> AllKinds() {
  static const std::array kAll = {&Office(), &Warehouse()};
  return kAll;
}

const BuildingKind& FindKind(std::string_view name) {
  std::vector<std::string> names = {"home"};
  for (const BuildingKind* kind : AllKinds()) {
    if (kind->name == name) return *kind;
    names.emplace_back(kind->name);
  }
  throw Error("no kind of building is called '" + std::string(name) + "'; did you mean '" +
              NearestWord(name, names) + "'?");
}

}  // namespace bulletnav::sim::building
