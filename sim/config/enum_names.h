// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <string_view>
#include <utility>

#include "sim/base/check_failed.h"

namespace bulletnav::sim {

/// Names of an enum's values in files. Specialise next to the enum, outside all other namespaces:
///   template <>
///   struct bulletnav::sim::EnumNames<bulletnav::agent::Mode> {
///     static constexpr std::array kNames = {std::pair{"fast", bulletnav::agent::Mode::kFast},
///     ...};
///   };
template <class E>
struct EnumNames;

/// The name of a value, as in EnumNames.
template <class E>
std::string_view NameOf(E value) {
  for (const auto& [name, enumerator] : EnumNames<E>::kNames) {
    if (enumerator == value) return name;
  }
  internal::CheckFailed(__FILE__, __LINE__, "the enum has a name for each value", {});
}

}  // namespace bulletnav::sim
