// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "sim/base/error.h"
#include "sim/config/enum_names.h"

namespace bulletnav::sim {

/// What an array is made of.
enum class Element { kUint8, kInt32, kFloat32, kFloat64 };

template <>
struct EnumNames<Element> {
  static constexpr std::array kNames = {
      std::pair{"uint8", Element::kUint8}, std::pair{"int32", Element::kInt32},
      std::pair{"float32", Element::kFloat32}, std::pair{"float64", Element::kFloat64}};
};

/// The element that is a T.
template <class T>
constexpr Element ElementOf() {
  if constexpr (std::is_same_v<T, std::uint8_t>) {
    return Element::kUint8;
  } else if constexpr (std::is_same_v<T, std::int32_t>) {
    return Element::kInt32;
  } else if constexpr (std::is_same_v<T, float>) {
    return Element::kFloat32;
  } else {
    static_assert(std::is_same_v<T, double>, "no array is made of these");
    return Element::kFloat64;
  }
}

/// What an array of an observation looks like: row by row, without gaps.
struct ArraySpec {
  std::string name;
  std::vector<int> shape;
  Element element = Element::kFloat32;
  std::string units;  // "m", "m, m, rad"; empty where there are none

  /// Values in it.
  std::size_t size() const {
    std::size_t n = 1;
    for (const int length : shape) n *= static_cast<std::size_t>(length);
    return n;
  }
  std::size_t bytes() const {
    switch (element) {
      case Element::kUint8:
        return size();
      case Element::kInt32:
      case Element::kFloat32:
        return 4 * size();
      case Element::kFloat64:
        return 8 * size();
    }
    return 0;
  }
  bool operator==(const ArraySpec&) const = default;
};

/// An array in somebody else's memory.
class ArrayView {
 public:
  /// Of memory that holds what `spec` says; both must outlive the view.
  ArrayView(const ArraySpec& spec, std::span<const std::byte> bytes)
      : spec_(&spec), bytes_(bytes) {}

  const ArraySpec& spec() const { return *spec_; }
  std::span<const std::byte> bytes() const { return bytes_; }

  /// Throws Error if the array is not made of T.
  template <class T>
  std::span<const T> values() const {
    if (ElementOf<T>() != spec_->element) {
      throw Error("the array " + spec_->name + " holds " + std::string(NameOf(spec_->element)) +
                  ", not " + std::string(NameOf(ElementOf<T>())));
    }
    return {reinterpret_cast<const T*>(bytes_.data()), bytes_.size() / sizeof(T)};
  }

 private:
  const ArraySpec* spec_;
  std::span<const std::byte> bytes_;
};

}  // namespace bulletnav::sim
