// SPDX-License-Identifier: MIT
#include "sim/sensors/cameras.h"

namespace bulletnav::sim {
namespace {

/// Everything around the body.
class Panorama final : public Sensor {
 public:
  static constexpr std::string_view kName = "panorama";
  using Config = PanoramaSensorConfig;

  static CameraSpec Camera(const Config& config) { return config.panorama; }
  static std::vector<ArraySpec> Arrays(const Config& config) {
    return CameraChannels::Arrays(config.panorama, config.channels);
  }

  Panorama(const Config& config, const SensorScene& scene)
      : camera_(scene.render, config.panorama, config.channels) {}

  void Read(const SensorInput& input, std::span<const std::span<std::byte>> out) override {
    camera_.Read(input.eye, out, input.glass);
  }

 private:
  CameraReader camera_;
};

const SensorRegistration<Panorama> registration;

}  // namespace

ConfiguredSensor PanoramaSensor(const PanoramaSensorConfig& config) {
  return Configure<Panorama>(config);
}

}  // namespace bulletnav::sim
