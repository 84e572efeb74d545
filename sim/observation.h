// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/error.h"
#include "sim/math/pose.h"
#include "sim/sensors/array.h"

namespace bulletnav::sim {

/// What the body's sensors, other than its camera, read after a step.
struct Sensors {
  PlanarPose odometry;    // measured change of pose in this step, in the frame before it
  bool collided = false;  // the bumper: something was in the way
};

/// An array that a sensor has written.
struct NamedArray {
  ArraySpec spec;
  std::vector<std::byte> bytes;  // empty where the observation keeps the values elsewhere
};

/// What the body senses after a reset or a step: the arrays of its sensors, by name, as in
/// "panorama.depth" (see SensorSet). Those of the sensor called `panorama` are kept in color and
/// depth; `sensors` is there whatever the set.
struct Observation {
  static constexpr std::string_view kColor = "panorama.color";
  static constexpr std::string_view kDepth = "panorama.depth";

  std::vector<std::uint8_t> color;  // [rows, cols, 3], empty if there is none
  std::vector<float> depth;         // [rows, cols] metres, as above
  Sensors sensors;
  std::vector<NamedArray> arrays;  // of all sensors, in their order

  /// Lives as long as this. Throws Error for a name that is not there, with those that are.
  ArrayView array(std::string_view name) const {
    std::string known;
    for (const NamedArray& array : arrays) {
      if (array.spec.name == name) return {array.spec, BytesOf(array)};
      known += (known.empty() ? "" : ", ") + array.spec.name;
    }
    throw Error("no sensor wrote '" + std::string(name) + "'; there are: " + known);
  }
  /// Its values. Throws Error if it is not made of T.
  template <class T>
  std::span<const T> values(std::string_view name) const {
    return array(name).values<T>();
  }

 private:
  std::span<const std::byte> BytesOf(const NamedArray& array) const {
    if (array.spec.name == kColor) return std::as_bytes(std::span(color));
    if (array.spec.name == kDepth) return std::as_bytes(std::span(depth));
    return array.bytes;
  }
};

}  // namespace bulletnav::sim
