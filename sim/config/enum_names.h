// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <string_view>
#include <utility>

#include "sim/base/check.h"

namespace bulletnav::sim {

/// Names of an enum's values in files. Specialise next to the enum:
///   template <> struct EnumNames<Mode> {
///     static constexpr std::array kNames = {std::pair{"fast", Mode::kFast}, ...};
///   };
template <class E>
struct EnumNames;

/// The name of a value, as in EnumNames.
template <class E>
std::string_view NameOf(E value) {
  for (const auto& [name, enumerator] : EnumNames<E>::kNames) {
    if (enumerator == value) return name;
  }
  CHECK(false);
}

}  // namespace bulletnav::sim
