// SPDX-License-Identifier: MIT
#include <array>
#include <string>

#include "sim/base/error.h"
#include "sim/house/building/kind.h"

namespace bulletnav::sim::building {

std::span<const BuildingKind* const> AllKinds() {
  static const std::array kAll = {&Clinic(), &Hotel(), &Loft(),      &Office(),
                                  &School(), &Shop(),  &Warehouse(), &Workshop()};
  return kAll;
}

const BuildingKind& FindKind(std::string_view name) {
  std::string names = "home";
  for (const BuildingKind* kind : AllKinds()) {
    if (kind->name == name) return *kind;
    names.append(", ").append(kind->name);
  }
  throw Error("no kind of building is called '" + std::string(name) + "'; there are: " + names);
}

}  // namespace bulletnav::sim::building
