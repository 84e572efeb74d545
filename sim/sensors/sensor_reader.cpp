// SPDX-License-Identifier: MIT
#include "sim/sensors/sensor_reader.h"

#include <algorithm>

namespace bulletnav::sim {

SensorReader::SensorReader(const SensorSet& set, const SensorScene& scene, const SensorNoise& noise)
    : scene_(scene), noise_(noise) {
  noise_.Validate();
  sensors_.reserve(set.sensors().size());
  for (const MountedSensor& mounted : set.sensors()) sensors_.push_back({mounted, nullptr, {}});
}

void SensorReader::Make(Made* made) const {
  const ConfiguredSensor& sensor = made->mounted.sensor;
  made->sensor = sensor.make(scene_);
  if (sensor.camera && !noise_.is_none()) made->noise.emplace(noise_, *sensor.camera);
}

void SensorReader::AddNoise(Made* made, const SensorInput& input,
                            std::span<const std::span<std::byte>> pictures) {
  if (!made->noise) return;
  std::span<std::uint8_t> color;
  std::span<float> depth;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const std::string& channel = made->mounted.sensor.arrays[i].name;
    if (channel == "color") color = ValuesIn<std::uint8_t>(pictures[i]);
    if (channel == "depth") depth = ValuesIn<float>(pictures[i]);
  }
  made->noise->Apply(input.noise(), color, depth);
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
    if (!made.sensor) Make(&made);
    input.sensor = made.mounted.name;
    made.sensor->Read(input, mine);
    AddNoise(&made, input, mine);
  }
}

}  // namespace bulletnav::sim
