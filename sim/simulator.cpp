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

Simulator::Simulator(std::shared_ptr<const World> world, const SimulatorSpec& spec)
    : spec_(spec),
      body_(NotNull(std::move(world)), spec.body, NoiseModel(spec.noise)),
      renderer_(body_.world().render_scene().MakeRenderer(spec.panorama)) {
  if (spec.color) observation_.color.resize(3 * spec.panorama.pixels());
  if (spec.depth) observation_.depth.resize(spec.panorama.pixels());
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

const Observation& Simulator::Observe(const Sensors& sensors) {
  const CameraPose camera = body_.camera_pose();
  renderer_->Render({&camera, 1}, observation_.color, observation_.depth);
  observation_.sensors = sensors;
  return observation_;
}

}  // namespace bulletnav::sim
