// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sim/sensors/noise/picture_noise.h"
#include "sim/sensors/sensor_set.h"

namespace bulletnav::sim {

/// Reads the sensors of bodies in one scene, one body after the other.
class SensorReader {
 public:
  /// The scene must outlive the reader. A sensor is made when it is first asked. Pictures of
  /// cameras get `noise`.
  SensorReader(const SensorSet& set, const SensorScene& scene, const SensorNoise& noise = {});

  /// Writes arrays in the order of SensorSet::arrays, each into memory of its size; an empty span:
  /// not wanted.
  void Read(SensorInput input, std::span<const std::span<std::byte>> out);

 private:
  struct Made {
    MountedSensor mounted;
    std::unique_ptr<Sensor> sensor;
    std::optional<PictureNoise> noise;  // of a camera, if there is any
    std::vector<std::uint8_t> glass;    // of its picture, if the noise asks and there is any
  };
  void Make(Made* made) const;
  static void ReadPictures(Made* made, SensorInput input,
                           std::span<const std::span<std::byte>> pictures);

  SensorScene scene_;
  SensorNoise noise_;
  std::vector<Made> sensors_;
};

}  // namespace bulletnav::sim
