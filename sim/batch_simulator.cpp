// SPDX-License-Identifier: MIT
#include "sim/batch_simulator.h"

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <map>
#include <numeric>
#include <optional>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "sim/base/error.h"
#include "sim/sensors/noise/picture_noise.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::sim {

namespace {

/// What a worker draws and reads with in one scene; made when first needed.
struct Tools {
  std::unique_ptr<Renderer> renderer;  // of panoramas
  std::unique_ptr<SensorReader> sensors;
};

}  // namespace

struct BatchSimulator::Impl {
  using ToolsByScene = std::map<const RenderScene*, Tools>;

  Impl(std::vector<std::shared_ptr<const World>> worlds, const SimulatorSpec& the_spec, int workers)
      : spec(the_spec),
        sensors(the_spec.AllSensors()),
        arrays(sensors.arrays()),
        noise(the_spec.noise),
        pool(workers) {
    if (const std::optional<PanoramaSpec> camera = sensors.panorama()) spec.panorama = *camera;
    spec.panorama.Validate();
    spec.sensor_noise.Validate();
    for (auto& world : worlds) bodies.push_back(NewBody(std::move(world), "BatchSimulator"));
    tools.resize(static_cast<std::size_t>(pool.workers()));
    if (spec.sensor_noise.is_none()) return;
    panorama_noise.assign(tools.size(), PictureNoise(spec.sensor_noise, spec.panorama));
    glass.resize(tools.size());
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
    auto& renderer = tools[static_cast<std::size_t>(worker)][&scene].renderer;
    if (!renderer) renderer = scene.MakeRenderer(spec.panorama);
    return *renderer;
  }

  SensorReader& SensorsOf(const World& world, int worker) {
    auto& reader = tools[static_cast<std::size_t>(worker)][&world.render_scene()].sensors;
    if (!reader) {
      reader = std::make_unique<SensorReader>(sensors, world.sensor_scene(), spec.sensor_noise);
    }
    return *reader;
  }

  /// Forgets what draws worlds that no lane is in; it must not outlive its world.
  void DropUnused(const World& leaving) {
    for (const auto& body : bodies) {
      if (&body->world() == &leaving) return;
    }
    for (ToolsByScene& mine : tools) mine.erase(&leaving.render_scene());
  }

  const RenderScene& scene(std::size_t lane) const { return bodies[lane]->world().render_scene(); }

  /// Draws lanes [first, first + n) of one world.
  void Draw(std::size_t first, std::size_t n, int worker, const BatchObservations& out) {
    if (out.color.empty() && out.depth.empty()) return;
    const std::size_t pixels = spec.panorama.pixels();
    std::vector<CameraPose> cameras;
    for (std::size_t i = first; i < first + n; ++i) cameras.push_back(bodies[i]->camera_pose());
    const std::span<std::uint8_t> seen_glass =
        out.depth.empty() ? std::span<std::uint8_t>() : GlassOf(scene(first), n, worker);
    RendererOf(scene(first), worker)
        .Draw(
            cameras,
            {out.color.empty() ? out.color : out.color.subspan(3 * pixels * first, 3 * pixels * n),
             out.depth.empty() ? out.depth : out.depth.subspan(pixels * first, pixels * n),
             {},
             seen_glass});
    if (panorama_noise.empty()) return;
    for (std::size_t i = 0; i < n; ++i) {
      AddNoise(first + i, worker, out,
               seen_glass.empty() ? seen_glass : seen_glass.subspan(pixels * i, pixels));
    }
  }

  /// Memory for which pixels of n panoramas show glass; empty if the noise does not ask or there is
  /// none.
  std::span<std::uint8_t> GlassOf(const RenderScene& scene, std::size_t n, int worker) {
    if (panorama_noise.empty() || !panorama_noise[0].asks_for_glass() || !scene.has_glass()) {
      return {};
    }
    std::vector<std::uint8_t>& memory = glass[static_cast<std::size_t>(worker)];
    memory.resize(n * spec.panorama.pixels());
    return memory;
  }

  /// To a lane's panorama, as its SensorReader would.
  void AddNoise(std::size_t lane, int worker, const BatchObservations& out,
                std::span<const std::uint8_t> seen_glass) {
    const std::size_t pixels = spec.panorama.pixels();
    SensorInput input = bodies[lane]->sensor_input();
    input.sensor = "panorama";
    panorama_noise[static_cast<std::size_t>(worker)].Apply(
        input.noise(),
        out.color.empty() ? out.color : out.color.subspan(3 * pixels * lane, 3 * pixels),
        out.depth.empty() ? out.depth : out.depth.subspan(pixels * lane, pixels), seen_glass);
  }

  /// Reads the arrays that are wanted of one lane. `wanted`: of all lanes, see Wanted.
  void Read(std::size_t lane, int worker, std::span<const std::span<std::byte>> wanted) {
    if (wanted.empty()) return;
    std::vector<std::span<std::byte>> mine(wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const std::size_t bytes = wanted[i].size() / bodies.size();
      mine[i] = wanted[i].subspan(lane * bytes, bytes);
    }
    SensorsOf(bodies[lane]->world(), worker).Read(bodies[lane]->sensor_input(), mine);
  }

  /// The memory for each of the sensors' arrays, empty where it is not wanted; nothing at all if
  /// none is.
  std::vector<std::span<std::byte>> Wanted(std::span<const BatchArray> out) const {
    if (out.empty()) return {};
    std::vector<std::span<std::byte>> wanted(arrays.size());
    for (const BatchArray& array : out) wanted[IndexOf(array.name)] = array.bytes;
    return wanted;
  }

  /// Where an array is among those of the sensors. Throws Error if nowhere.
  std::size_t IndexOf(const std::string& name) const {
    const auto named = [&](const ArraySpec& array) {
      return array.name == name;
    };
    const auto found = std::find_if(arrays.begin(), arrays.end(), named);
    if (found != arrays.end()) return static_cast<std::size_t>(found - arrays.begin());
    std::vector<std::string> known;
    for (const ArraySpec& array : arrays) known.push_back(array.name);
    throw Error(fmt::format("no sensor writes '{}'; there are: {}", name, fmt::join(known, ", ")));
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
    const std::vector<std::span<std::byte>> wanted = Wanted(out.arrays);
    std::vector<char> together;
    together.reserve(lanes.size());
    for (const int lane : lanes) {
      together.push_back(draws && DrawsTogether(static_cast<std::size_t>(lane)) ? 1 : 0);
    }
    pool.ForEach(static_cast<int>(lanes.size()), [&](int place, int worker) {
      const auto i = static_cast<std::size_t>(place);
      const auto lane = static_cast<std::size_t>(lanes[i]);
      act(*bodies[lane], i);
      if (together[i] == 0) Draw(lane, 1, worker, out);
      Read(lane, worker, wanted);
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
    for (const BatchArray& array : out.arrays) {
      const std::size_t bytes = arrays[IndexOf(array.name)].bytes() * bodies.size();
      CheckSize(call, ("bytes for " + array.name).c_str(), array.bytes.size(), {0, bytes});
    }
  }

  static void CheckSize(const char* call, const char* what, std::size_t size,
                        std::initializer_list<std::size_t> fitting) {
    if (std::find(fitting.begin(), fitting.end(), size) != fitting.end()) return;
    throw Error(fmt::format("{}: got {} {}, {} fit", call, size, what, fmt::join(fitting, " or ")));
  }

  SimulatorSpec spec;
  SensorSet sensors;
  std::vector<ArraySpec> arrays;  // of the sensors
  NoiseModel noise;
  WorkerPool pool;
  std::vector<std::unique_ptr<SimulatedBody>> bodies;
  std::vector<ToolsByScene> tools;               // of each worker
  std::vector<PictureNoise> panorama_noise;      // of each worker, if there is any
  std::vector<std::vector<std::uint8_t>> glass;  // of each worker's panoramas, see GlassOf
};

BatchSimulator::BatchSimulator(std::vector<std::shared_ptr<const World>> worlds,
                               const SimulatorSpec& spec, int workers)
    : impl_(std::make_unique<Impl>(std::move(worlds), spec, workers)) {}

BatchSimulator::~BatchSimulator() {
  // What draws goes before the worlds that the bodies hold.
  impl_->tools.clear();
}

int BatchSimulator::lanes() const {
  return static_cast<int>(impl_->bodies.size());
}

const std::vector<ArraySpec>& BatchSimulator::arrays() const {
  return impl_->arrays;
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
                          std::span<Sensors> sensors, const BatchObservations& out,
                          const AfterMotion& after) {
  constexpr const char* kCall = "BatchSimulator::Step";
  impl_->Check(kCall, lanes, out);
  Impl::CheckSize(kCall, "actions", actions.size(), {lanes.size()});
  Impl::CheckSize(kCall, "sensors", sensors.size(), {lanes.size()});
  for (const Action action : actions) internal::RequireAction(action, kCall);
  impl_->ForEachLane(
      lanes,
      [&](SimulatedBody& body, std::size_t place) {
        sensors[place] = body.Step(actions[place]);
        if (after) after(place, sensors[place]);
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

void BatchSimulator::Render(int lane, const CameraPose& camera, const BatchObservations& out,
                            std::span<std::uint8_t> glass) {
  const RenderScene& scene = impl_->body(lane, "BatchSimulator::Render").world().render_scene();
  impl_->RendererOf(scene, 0).Draw({&camera, 1}, {out.color, out.depth, {}, glass});
}

const SimulatedBody& BatchSimulator::body(int lane) const {
  return impl_->body(lane, "BatchSimulator::body");
}

}  // namespace bulletnav::sim
