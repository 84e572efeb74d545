// SPDX-License-Identifier: MIT
#include <algorithm>

#include "sim/sensors/no_config.h"
#include "sim/sensors/sensor.h"

namespace bulletnav::sim {
namespace {

/// The measured motion of the last step, in the frame before it: x ahead, y to the left, yaw. Its
/// noise is the simulator's (SimulatorSpec::noise).
class Odometry final : public Sensor {
 public:
  static constexpr std::string_view kName = "odometry";
  using Config = NoSensorConfig;

  static std::vector<ArraySpec> Arrays(const Config& /*config*/) {
    return {{"motion", {3}, Element::kFloat64, "m, m, rad"}};
  }

  Odometry(const Config& /*config*/, const SensorScene& /*scene*/) {}

  void Read(const SensorInput& input, std::span<const std::span<std::byte>> out) override {
    const PlanarPose& motion = input.step.odometry;
    const std::array values = {motion.x, motion.y, motion.yaw};
    std::copy_n(values.begin(), ValuesIn<double>(out[0]).size(), ValuesIn<double>(out[0]).begin());
  }
};

const SensorRegistration<Odometry> registration;

}  // namespace
}  // namespace bulletnav::sim
