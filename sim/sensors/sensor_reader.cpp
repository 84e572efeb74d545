// SPDX-License-Identifier: MIT
#include "sim/sensors/sensor_reader.h"

#include <algorithm>

namespace bulletnav::sim {

SensorReader::SensorReader(const SensorSet& set, const SensorScene& scene) : scene_(scene) {
  sensors_.reserve(set.sensors().size());
  for (const MountedSensor& mounted : set.sensors()) sensors_.push_back({mounted, nullptr});
}

void SensorReader::Read(SensorInput input, std::span<const std::span<std::byte>> out) {
  std::size_t first = 0;
  for (Made& made : sensors_) {
    const auto mine = out.subspan(first, made.mounted.sensor.arrays.size());
    first += mine.size();
    const bool is_wanted = std::any_of(mine.begin(), mine.end(), [](std::span<std::byte> array) {
      return !array.empty();
    });
    if (!is_wanted) continue;
    if (!made.sensor) made.sensor = made.mounted.sensor.make(scene_);
    input.sensor = made.mounted.name;
    made.sensor->Read(input, mine);
  }
}

}  // namespace bulletnav::sim
