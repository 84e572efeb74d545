// SPDX-License-Identifier: MIT
#include "sim/simulator.h"

#include "sim/base/error.h"

namespace bulletnav::sim {
namespace {

std::shared_ptr<const World> NotNull(std::shared_ptr<const World> world) {
  internal::RequireWorld(world, "Simulator");
  return world;
}

}  // namespace

SensorSet SimulatorSpec::AllSensors() const {
  return sensors.empty() ? SensorSet::Usual(panorama, color, depth) : sensors;
}

Simulator::Simulator(std::shared_ptr<const World> world, const SimulatorSpec& spec)
    : spec_(spec),
      body_(NotNull(std::move(world)), spec.body, NoiseModel(spec.noise)),
      sensors_(spec.AllSensors(), body_.world().sensor_scene(), spec.sensor_noise) {
  for (const ArraySpec& array : spec.AllSensors().arrays()) {
    NamedArray& added = observation_.arrays.emplace_back(NamedArray{array, {}});
    if (array.name == Observation::kColor) {
      observation_.color.resize(array.size());
    } else if (array.name == Observation::kDepth) {
      observation_.depth.resize(array.size());
    } else {
      added.bytes.resize(array.bytes());
    }
  }
}

const Observation& Simulator::Reset(const BodyPose& pose, const EpisodeKey& key) {
  body_.Reset(pose, key);
  return Observe({});
}

const Observation& Simulator::Step(Action action) {
  if (!body_.is_placed()) throw Error("Simulator::Step: call Reset first");
  internal::RequireAction(action, "Simulator::Step");
  return Observe(body_.Step(action));
}

std::span<std::byte> Simulator::MemoryOf(NamedArray* array) {
  if (array->spec.name == Observation::kColor) {
    return std::as_writable_bytes(std::span(observation_.color));
  }
  if (array->spec.name == Observation::kDepth) {
    return std::as_writable_bytes(std::span(observation_.depth));
  }
  return array->bytes;
}

const Observation& Simulator::Observe(const Sensors& sensors) {
  observation_.sensors = sensors;
  std::vector<std::span<std::byte>> out;
  out.reserve(observation_.arrays.size());
  for (NamedArray& array : observation_.arrays) out.push_back(MemoryOf(&array));
  sensors_.Read(body_.sensor_input(), out);
  return observation_;
}

}  // namespace bulletnav::sim
