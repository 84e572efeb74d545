// SPDX-License-Identifier: MIT
#include "sim/batch_simulator.h"

#include <functional>
#include <map>
#include <numeric>

#include "sim/base/check.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::sim {

struct BatchSimulator::Impl {
  using Renderers = std::map<const RenderScene*, std::unique_ptr<Renderer>>;

  Impl(std::vector<std::shared_ptr<const World>> worlds, const SimulatorSpec& the_spec, int workers)
      : spec(the_spec), noise(the_spec.noise), pool(workers) {
    spec.panorama.Validate();
    for (auto& world : worlds) bodies.push_back(NewBody(std::move(world)));
    renderers.resize(static_cast<std::size_t>(pool.workers()));
  }

  std::unique_ptr<SimulatedBody> NewBody(std::shared_ptr<const World> world) const {
    return std::make_unique<SimulatedBody>(std::move(world), spec.body, noise);
  }

  SimulatedBody& body(int lane) {
    BULLETNAV_CHECK(lane >= 0 && static_cast<std::size_t>(lane) < bodies.size());
    return *bodies[static_cast<std::size_t>(lane)];
  }

  Renderer& RendererOf(const RenderScene& scene, int worker) {
    auto& renderer = renderers[static_cast<std::size_t>(worker)][&scene];
    if (!renderer) renderer = scene.MakeRenderer(spec.panorama);
    return *renderer;
  }

  /// Forgets the renderers of worlds that no lane is in; they must not outlive their world.
  void DropUnused(const World& leaving) {
    for (const auto& body : bodies) {
      if (&body->world() == &leaving) return;
    }
    for (Renderers& mine : renderers) mine.erase(&leaving.render_scene());
  }

  const RenderScene& scene(std::size_t lane) const { return bodies[lane]->world().render_scene(); }

  /// Draws lanes [first, first + n) of one world.
  void Draw(std::size_t first, std::size_t n, int worker, const BatchObservations& out) {
    if (out.color.empty() && out.depth.empty()) return;
    const std::size_t pixels = spec.panorama.pixels();
    std::vector<CameraPose> cameras;
    for (std::size_t i = first; i < first + n; ++i) cameras.push_back(bodies[i]->camera_pose());
    RendererOf(scene(first), worker)
        .Render(
            cameras,
            out.color.empty() ? out.color : out.color.subspan(3 * pixels * first, 3 * pixels * n),
            out.depth.empty() ? out.depth : out.depth.subspan(pixels * first, pixels * n));
  }

  bool DrawsTogether(std::size_t lane) { return RendererOf(scene(lane), 0).preferred_batch() > 1; }

  /// Runs of neighbouring lanes in one world, in one call each.
  void DrawTogether(std::span<const int> lanes, const BatchObservations& out) {
    for (std::size_t i = 0; i < lanes.size();) {
      const auto first = static_cast<std::size_t>(lanes[i]);
      std::size_t n = 1;
      while (i + n < lanes.size() && lanes[i + n] == lanes[i] + static_cast<int>(n) &&
             &scene(first + n) == &scene(first)) {
        ++n;
      }
      if (DrawsTogether(first)) Draw(first, n, 0, out);
      i += n;
    }
  }

  /// Lets some lanes act, then draws what they see. `act` gets the place among `lanes`.
  void ForEachLane(std::span<const int> lanes, const std::function<void(std::size_t place)>& act,
                   const BatchObservations& out) {
    CheckSizes(out);
    const bool draws = !out.color.empty() || !out.depth.empty();
    std::vector<char> together;
    for (const int lane : lanes) {
      body(lane);  // throws if there is none
      together.push_back(draws && DrawsTogether(static_cast<std::size_t>(lane)) ? 1 : 0);
    }
    pool.ForEach(static_cast<int>(lanes.size()), [&](int place, int worker) {
      const auto i = static_cast<std::size_t>(place);
      act(i);
      if (together[i] == 0) Draw(static_cast<std::size_t>(lanes[i]), 1, worker, out);
    });
    if (draws) DrawTogether(lanes, out);
  }

  std::vector<int> AllLanes() const {
    std::vector<int> lanes(bodies.size());
    std::iota(lanes.begin(), lanes.end(), 0);
    return lanes;
  }

  void CheckSizes(const BatchObservations& out) const {
    const std::size_t pixels = spec.panorama.pixels() * bodies.size();
    BULLETNAV_CHECK(out.color.empty() || out.color.size() == 3 * pixels);
    BULLETNAV_CHECK(out.depth.empty() || out.depth.size() == pixels);
  }

  SimulatorSpec spec;
  NoiseModel noise;
  WorkerPool pool;
  std::vector<std::unique_ptr<SimulatedBody>> bodies;
  std::vector<Renderers> renderers;  // one set a worker
};

BatchSimulator::BatchSimulator(std::vector<std::shared_ptr<const World>> worlds,
                               const SimulatorSpec& spec, int workers)
    : impl_(std::make_unique<Impl>(std::move(worlds), spec, workers)) {}

BatchSimulator::~BatchSimulator() {
  // Renderers before the worlds that the bodies hold.
  impl_->renderers.clear();
}

int BatchSimulator::lanes() const {
  return static_cast<int>(impl_->bodies.size());
}

void BatchSimulator::Reset(int lane, const BodyPose& pose, const EpisodeKey& key) {
  impl_->body(lane).Reset(pose, key);
}

void BatchSimulator::SetWorld(int lane, std::shared_ptr<const World> world) {
  BULLETNAV_CHECK(lane >= 0 && lane < lanes());
  auto& slot = impl_->bodies[static_cast<std::size_t>(lane)];
  const std::unique_ptr<SimulatedBody> old = std::exchange(slot, impl_->NewBody(std::move(world)));
  impl_->DropUnused(old->world());
}

void BatchSimulator::Step(std::span<const Action> actions, std::span<Sensors> sensors,
                          const BatchObservations& out) {
  Step(impl_->AllLanes(), actions, sensors, out);
}

void BatchSimulator::Step(std::span<const int> lanes, std::span<const Action> actions,
                          std::span<Sensors> sensors, const BatchObservations& out) {
  BULLETNAV_CHECK_EQ(actions.size(), lanes.size());
  BULLETNAV_CHECK_EQ(sensors.size(), lanes.size());
  impl_->ForEachLane(
      lanes,
      [&](std::size_t place) {
        sensors[place] = impl_->body(lanes[place]).Step(actions[place]);
      },
      out);
}

void BatchSimulator::Observe(const BatchObservations& out) {
  Observe(impl_->AllLanes(), out);
}

void BatchSimulator::Observe(std::span<const int> lanes, const BatchObservations& out) {
  impl_->ForEachLane(
      lanes, [](std::size_t) {}, out);
}

void BatchSimulator::Render(int lane, const CameraPose& camera, const BatchObservations& out) {
  const RenderScene& scene = impl_->body(lane).world().render_scene();
  impl_->RendererOf(scene, 0).Render({&camera, 1}, out.color, out.depth);
}

const SimulatedBody& BatchSimulator::body(int lane) const {
  return impl_->body(lane);
}

}  // namespace bulletnav::sim
