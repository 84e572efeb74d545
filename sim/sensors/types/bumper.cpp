// SPDX-License-Identifier: MIT
#include <algorithm>

#include "sim/sensors/no_config.h"
#include "sim/sensors/sensor.h"

namespace bulletnav::sim {
namespace {

/// Whether something was in the way of the last step.
class Bumper final : public Sensor {
 public:
  static constexpr std::string_view kName = "bumper";
  using Config = NoSensorConfig;

  static std::vector<ArraySpec> Arrays(const Config& /*config*/) {
    return {{"collided", {1}, Element::kUint8, ""}};
  }

  Bumper(const Config& /*config*/, const SensorScene& /*scene*/) {}

  void Read(const SensorInput& input, std::span<const std::span<std::byte>> out) override {
    const std::uint8_t collided = input.step.collided ? 1 : 0;
    std::ranges::fill(ValuesIn<std::uint8_t>(out[0]), collided);
  }
};

const SensorRegistration<Bumper> registration;

}  // namespace
}  // namespace bulletnav::sim
