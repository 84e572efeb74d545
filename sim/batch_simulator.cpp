// SPDX-License-Identifier: MIT
#include "sim/batch_simulator.h"

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <map>
#include <numeric>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "sim/base/error.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::sim {

struct BatchSimulator::Impl {
  using Renderers = std::map<const RenderScene*, std::unique_ptr<Renderer>>;

  Impl(std::vector<std::shared_ptr<const World>> worlds, const SimulatorSpec& the_spec, int workers)
      : spec(the_spec), noise(the_spec.noise), pool(workers) {
    spec.panorama.Validate();
    for (auto& world : worlds) bodies.push_back(NewBody(std::move(world), "BatchSimulator"));
    renderers.resize(static_cast<std::size_t>(pool.workers()));
  }

  std::unique_ptr<SimulatedBody> NewBody(std::shared_ptr<const World> world,
                                         const char* call) const {
    internal::RequireWorld(world, call);
    return std::make_unique<SimulatedBody>(std::move(world), spec.body, noise);
  }

  SimulatedBody& body(int lane, const char* call) {
    if (lane < 0 || static_cast<std::size_t>(lane) >= bodies.size()) {
      throw Error(fmt::format("{}: there is no lane {}; there are {}", call, lane, bodies.size()));
    }
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
  void ForEachLane(std::span<const int> lanes,
                   const std::function<void(SimulatedBody&, std::size_t place)>& act,
                   const BatchObservations& out) {
    const bool draws = !out.color.empty() || !out.depth.empty();
    std::vector<char> together;
    for (const int lane : lanes) {
      together.push_back(draws && DrawsTogether(static_cast<std::size_t>(lane)) ? 1 : 0);
    }
    pool.ForEach(static_cast<int>(lanes.size()), [&](int place, int worker) {
      const auto i = static_cast<std::size_t>(place);
      act(*bodies[static_cast<std::size_t>(lanes[i])], i);
      if (together[i] == 0) Draw(static_cast<std::size_t>(lanes[i]), 1, worker, out);
    });
    if (draws) DrawTogether(lanes, out);
  }

  std::vector<int> AllLanes() const {
    std::vector<int> lanes(bodies.size());
    std::iota(lanes.begin(), lanes.end(), 0);
    return lanes;
  }

  /// Throws Error for what a caller cannot mean.
  void Check(const char* call, std::span<const int> lanes, const BatchObservations& out) {
    for (std::size_t i = 0; i < lanes.size(); ++i) {
      if (!body(lanes[i], call).is_placed()) {
        throw Error(
            fmt::format("{}: lane {} stands nowhere yet; call Reset first", call, lanes[i]));
      }
      if (i > 0 && lanes[i] <= lanes[i - 1]) {
        throw Error(fmt::format("{}: lanes must rise, and {} comes after {}", call, lanes[i],
                                lanes[i - 1]));
      }
    }
    const std::size_t pixels = spec.panorama.pixels() * bodies.size();
    CheckSize(call, "values for colour", out.color.size(), {0, 3 * pixels});
    CheckSize(call, "values for depth", out.depth.size(), {0, pixels});
  }

  static void CheckSize(const char* call, const char* what, std::size_t size,
                        std::initializer_list<std::size_t> fitting) {
    if (std::find(fitting.begin(), fitting.end(), size) != fitting.end()) return;
    throw Error(fmt::format("{}: got {} {}, {} fit", call, size, what, fmt::join(fitting, " or ")));
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
  impl_->body(lane, "BatchSimulator::Reset").Reset(pose, key);
}

void BatchSimulator::SetWorld(int lane, std::shared_ptr<const World> world) {
  constexpr const char* kCall = "BatchSimulator::SetWorld";
  impl_->body(lane, kCall);
  auto& slot = impl_->bodies[static_cast<std::size_t>(lane)];
  const std::unique_ptr<SimulatedBody> old =
      std::exchange(slot, impl_->NewBody(std::move(world), kCall));
  impl_->DropUnused(old->world());
}

void BatchSimulator::Step(std::span<const Action> actions, std::span<Sensors> sensors,
                          const BatchObservations& out) {
  Step(impl_->AllLanes(), actions, sensors, out);
}

void BatchSimulator::Step(std::span<const int> lanes, std::span<const Action> actions,
                          std::span<Sensors> sensors, const BatchObservations& out) {
  constexpr const char* kCall = "BatchSimulator::Step";
  impl_->Check(kCall, lanes, out);
  Impl::CheckSize(kCall, "actions", actions.size(), {lanes.size()});
  Impl::CheckSize(kCall, "sensors", sensors.size(), {lanes.size()});
  for (const Action action : actions) internal::RequireAction(action, kCall);
  impl_->ForEachLane(
      lanes,
      [&](SimulatedBody& body, std::size_t place) {
        sensors[place] = body.Step(actions[place]);
      },
      out);
}

void BatchSimulator::Observe(const BatchObservations& out) {
  Observe(impl_->AllLanes(), out);
}

void BatchSimulator::Observe(std::span<const int> lanes, const BatchObservations& out) {
  impl_->Check("BatchSimulator::Observe", lanes, out);
  impl_->ForEachLane(
      lanes, [](SimulatedBody&, std::size_t) {}, out);
}

void BatchSimulator::Render(int lane, const CameraPose& camera, const BatchObservations& out) {
  const RenderScene& scene = impl_->body(lane, "BatchSimulator::Render").world().render_scene();
  impl_->RendererOf(scene, 0).Render({&camera, 1}, out.color, out.depth);
}

const SimulatedBody& BatchSimulator::body(int lane) const {
  return impl_->body(lane, "BatchSimulator::body");
}

}  // namespace bulletnav::sim
