// SPDX-License-Identifier: MIT
#include "sim/sensors/sensor_reader.h"

#include <algorithm>

namespace bulletnav::sim {

SensorReader::SensorReader(const SensorSet& set, const SensorScene& scene, const SensorNoise& noise)
    : scene_(scene), noise_(noise) {
  noise_.Validate();
  sensors_.reserve(set.sensors().size());
  for (const MountedSensor& mounted : set.sensors()) sensors_.push_back({mounted, nullptr, {}, {}});
}

void SensorReader::Make(Made* made) const {
  const ConfiguredSensor& sensor = made->mounted.sensor;
  made->sensor = sensor.make(scene_);
  if (!sensor.camera || noise_.is_none()) return;
  made->noise.emplace(noise_, *sensor.camera);
  const bool has_glass = made->noise->asks_for_glass() && scene_.render.has_glass();
  if (has_glass) made->glass.resize(SizeOf(*sensor.camera).pixels());
}

/// With their noise.
void SensorReader::ReadPictures(Made* made, SensorInput input,
                                std::span<const std::span<std::byte>> pictures) {
  std::span<std::uint8_t> color;
  std::span<float> depth;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const std::string& channel = made->mounted.sensor.arrays[i].name;
    if (channel == "color") color = ValuesIn<std::uint8_t>(pictures[i]);
    if (channel == "depth") depth = ValuesIn<float>(pictures[i]);
  }
  if (!depth.empty()) input.glass = made->glass;
  made->sensor->Read(input, pictures);
  made->noise->Apply(input.noise(), color, depth, input.glass);
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
    if (made.noise) {
      ReadPictures(&made, input, mine);
    } else {
      made.sensor->Read(input, mine);
    }
  }
}

}  // namespace bulletnav::sim
