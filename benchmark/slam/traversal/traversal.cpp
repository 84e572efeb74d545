// SPDX-License-Identifier: MIT
#include "benchmark/slam/traversal/traversal.h"

#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "agent/slam/verify/panorama_lens.h"
#include "benchmark/privileged/shortest_path.h"
#include "benchmark/slam/traversal/route.h"
#include "sim/base/check.h"
#include "sim/base/error.h"
#include "sim/sensors/cameras.h"
#include "sim/sensors/noise/picture_noise.h"
#include "sim/simulator.h"

namespace bulletnav::bench {
namespace {

constexpr const char* kCamera = "camera";
constexpr int kMostActionsToAPlace = 400;  // where physics does not let it through, it goes on
constexpr int kMostStarts = 100;

sim::SimulatorSpec SimulatorSpecOf(const TraversalSpec& spec) {
  sim::SimulatorSpec of;
  of.body = spec.body;
  of.noise = spec.noise;
  if (spec.panorama) {
    sim::PanoramaSensorConfig panorama;
    panorama.panorama = *spec.panorama;
    of.sensors.Add(kCamera, sim::PanoramaSensor(panorama));
    return of;
  }
  sim::PinholeSensorConfig camera;
  camera.camera = spec.camera;
  of.sensors.Add(kCamera, sim::PinholeSensor(camera));
  return of;
}

/// Leads the body by the places of a route.
class Driver {
 public:
  Driver(const TraversalSpec& spec, std::shared_ptr<const sim::World> world, Route* route)
      : agent_({}), route_(route) {
    truth_.world = std::move(world);
    truth_.body = spec.body;
  }

  sim::Action Next(const sim::BodyPose& pose) {
    truth_.pose = pose;
    while (true) {
      if (!has_goal_ || ++taken_ > kMostActionsToAPlace) Start();
      const sim::Action action = agent_.Act(truth_);
      if (action != sim::Action::kStop) return action;
      has_goal_ = false;
      // A route that comes by where the body stands already must still end.
      if (++passed_ > kMostStarts) return sim::Action::kTurnLeft;
    }
  }

  void Moved() { passed_ = 0; }

 private:
  void Start() {
    truth_.goal = {route_->Next().cast<double>(), 0.0};
    agent_.Reset(truth_);
    has_goal_ = true;
    taken_ = 0;
  }

  ShortestPathAgent agent_;
  Route* route_;
  GroundTruth truth_;
  bool has_goal_ = false;
  int taken_ = 0;
  int passed_ = 0;
};

/// Adds the noise of a traversal's camera to frames.
class Noise {
 public:
  Noise(const TraversalSpec& spec, const sim::Rng& rng) : rng_(rng.Fork("sensor_noise")) {
    const sim::SensorNoise noise = sim::NamedSensorNoise(spec.sensor_noise);
    if (noise.is_none()) return;
    noise_.emplace(noise,
                   spec.panorama ? sim::CameraSpec(*spec.panorama) : sim::CameraSpec(spec.camera));
  }

  bool is_none() const { return !noise_; }
  void Add(int step, std::span<std::uint8_t> color, std::span<float> ranges) {
    noise_->Apply(rng_.Fork("step", static_cast<std::uint64_t>(step)), color, ranges);
  }

 private:
  sim::Rng rng_;
  std::optional<sim::PictureNoise> noise_;
};

/// Of ranges along rays.
DepthPicture DepthOf(std::span<const float> ranges, const TraversalSpec& spec) {
  return spec.panorama ? Levelled(ranges, *spec.panorama) : AlongAxis(ranges, spec.camera);
}

TraversalFrame FrameOf(const sim::Observation& seen, const TraversalSpec& spec, int step,
                       Noise* noise) {
  TraversalFrame frame;
  frame.step = step;
  const auto [rows, cols] = spec.panorama ? sim::SizeOf(*spec.panorama) : sim::SizeOf(spec.camera);
  frame.color = sim::Image(cols, rows, 3);
  const auto color = seen.values<std::uint8_t>("camera.color");
  frame.color.pixels.assign(color.begin(), color.end());
  const auto exact = seen.values<float>("camera.depth");
  std::vector<float> ranges(exact.begin(), exact.end());
  if (!noise->is_none()) {
    frame.true_depth = DepthOf(exact, spec);
    noise->Add(step, frame.color.pixels, ranges);
  }
  frame.depth = DepthOf(ranges, spec);
  if (spec.panorama) frame.ranges = std::move(ranges);
  return frame;
}

/// A body that is led through one scene.
class SceneDrive {
 public:
  SceneDrive(const std::shared_ptr<const sim::World>& world, const TraversalSpec& spec)
      : world_(world),
        spec_(spec),
        simulator_(world, SimulatorSpecOf(spec)),
        query_(world->navmesh()) {}

  /// At the first place of the floor where it fits.
  void Begin(sim::Rng* rng) {
    for (int i = 0; i < kMostStarts; ++i) {
      const Eigen::Vector3d place = query_.RandomPoint(rng, 0).cast<double>();
      const double yaw = rng->Uniform(-M_PI, M_PI);
      if (Place({place, yaw}, 0)) return Lead(*rng);
    }
    throw sim::Error("the body found nowhere to stand; is it too large for this scene?");
  }

  /// Where it stood in another scene; false if it does not fit there, or would be shut in.
  bool GoOnFrom(const sim::BodyPose& pose, const sim::Rng& rng) {
    if (!IsFree(pose) || !Place(pose, 1)) return false;
    Lead(rng.Fork("refurnished"));
    return true;
  }

  sim::Action Step() {
    const sim::Action action = driver_->Next(pose());
    seen_ = &simulator_.Step(action);
    driver_->Moved();
    return action;
  }

  const sim::Observation& seen() const { return *seen_; }
  const sim::BodyPose& pose() const { return simulator_.body().true_pose(); }

 private:
  /// `episode`: whose noise of motion it is.
  bool Place(const sim::BodyPose& pose, std::uint64_t episode) {
    try {
      seen_ = &simulator_.Reset(pose, {spec_.seed, episode});
      return true;
    } catch (const sim::PoseError&) {
      return false;
    }
  }

  /// On the largest floor, not in a cupboard say.
  bool IsFree(const sim::BodyPose& pose) const {
    constexpr float kNear = 0.05f;  // metres, a cell of the navmesh
    const Eigen::Vector3f here = pose.position.cast<float>();
    const auto floor = query_.Snap(here);
    if (!floor || query_.IslandOf(here) != 0) return false;
    return std::hypot(floor->x() - here.x(), floor->z() - here.z()) < kNear;
  }

  void Lead(const sim::Rng& rng) {
    route_.emplace(query_, pose().position.cast<float>(), rng);
    driver_.emplace(spec_, world_, &*route_);
  }

  std::shared_ptr<const sim::World> world_;
  const TraversalSpec& spec_;
  sim::Simulator simulator_;
  sim::NavmeshQuery query_;
  const sim::Observation* seen_ = nullptr;
  std::optional<Route> route_;
  std::optional<Driver> driver_;
};

/// The same body in another look of the scene.
class OtherLook {
 public:
  OtherLook(const std::shared_ptr<const sim::World>& world, const TraversalSpec& spec,
            const sim::BodyPose& start)
      : simulator_(world, SimulatorSpecOf(spec)), seen_(&simulator_.Reset(start, {spec.seed, 0})) {}

  void Follow(sim::Action action, const sim::BodyPose& there) {
    seen_ = &simulator_.Step(action);
    constexpr double kClose = 1e-3;
    if ((simulator_.body().true_pose().position - there.position).norm() > kClose) {
      throw sim::Error(
          "the changed look of the scene has another geometry; change colours and light alone");
    }
  }
  const sim::Observation& seen() const { return *seen_; }

 private:
  sim::Simulator simulator_;
  const sim::Observation* seen_;
};

}  // namespace

void TraversalSpec::Validate() const {
  body.Validate();
  camera.Validate();
  if (camera.pitch_deg != 0.0) throw sim::Error("a traversal's camera must be level: pitch_deg 0");
  if (panorama) {
    panorama->Validate();
    if (panorama->projection != sim::Projection::kCylindrical) {
      throw sim::Error("a traversal's panorama must be cylindrical");
    }
  }
  sim::RequireSensorNoise(sensor_noise);
  if (actions < 1) throw sim::Error("a traversal needs at least one action");
}

void Traverse(const std::shared_ptr<const sim::World>& world, const TraversalSpec& spec,
              const std::function<void(const TraversalFrame&)>& take) {
  Traverse(world, {}, spec, take);
}

void Traverse(const std::shared_ptr<const sim::World>& world, const ChangedScene& changed,
              const TraversalSpec& spec, const std::function<void(const TraversalFrame&)>& take) {
  spec.Validate();
  world->RequireFloor();
  sim::Rng rng(sim::MixSeed(spec.seed, world->id()), "traversal");
  auto drive = std::make_unique<SceneDrive>(world, spec);
  drive->Begin(&rng);
  std::optional<OtherLook> other;
  std::unique_ptr<SceneDrive> next;  // until the body goes on there
  if (changed.world && changed.is_refurnished) {
    changed.world->RequireFloor();
    next = std::make_unique<SceneDrive>(changed.world, spec);
  } else if (changed.world) {
    other.emplace(changed.world, spec, drive->pose());
  }
  Noise noise(spec, rng);
  sim::PlanarPose dead_reckoned;
  for (int step = 0;; ++step) {
    if (next && step >= changed.from_step && next->GoOnFrom(drive->pose(), rng)) {
      drive = std::exchange(next, nullptr);
    }
    const bool is_changed = other && step >= changed.from_step;
    TraversalFrame frame = FrameOf(is_changed ? other->seen() : drive->seen(), spec, step, &noise);
    frame.true_pose = drive->pose();
    frame.dead_reckoned = dead_reckoned;
    take(frame);
    if (step == spec.actions) break;
    const sim::Action action = drive->Step();
    if (other) other->Follow(action, drive->pose());
    dead_reckoned = sim::Compose(dead_reckoned, drive->seen().sensors.odometry);
  }
  if (next) throw sim::Error("the body found no room in the refurnished scene");
}

Intrinsics IntrinsicsOf(const sim::PinholeSpec& camera) {
  const double fx = camera.cols / 2.0 / camera.tan_x();
  const double fy = camera.rows / 2.0 / camera.tan_y();
  return {fx, fy, (camera.cols - 1) / 2.0, (camera.rows - 1) / 2.0};
}

DepthPicture AlongAxis(std::span<const float> ranges, const sim::PinholeSpec& camera) {
  BULLETNAV_CHECK(ranges.size() == camera.pixels());
  const Intrinsics k = IntrinsicsOf(camera);
  DepthPicture depth{camera.cols, camera.rows, {}};
  depth.metres.reserve(ranges.size());
  for (int row = 0; row < camera.rows; ++row) {
    for (int col = 0; col < camera.cols; ++col) {
      const float range = ranges[depth.metres.size()];
      const double length = std::hypot((col - k.cx) / k.fx, (row - k.cy) / k.fy, 1.0);
      depth.metres.push_back(range < camera.max_depth_m ? static_cast<float>(range / length)
                                                        : 0.0f);
    }
  }
  return depth;
}

DepthPicture Levelled(std::span<const float> ranges, const sim::PanoramaSpec& panorama) {
  BULLETNAV_CHECK(ranges.size() == panorama.pixels());
  DepthPicture depth{panorama.cols, panorama.rows, {}};
  depth.metres.reserve(ranges.size());
  const auto lens = agent::PanoramaLens::Of(panorama.rows, panorama.cols);
  for (int row = 0; row < panorama.rows; ++row) {
    const double length = std::hypot(1.0, lens.first_slope - row * lens.row);
    for (int col = 0; col < panorama.cols; ++col) {
      const float range = ranges[depth.metres.size()];
      depth.metres.push_back(range < panorama.max_depth_m ? static_cast<float>(range / length)
                                                          : 0.0f);
    }
  }
  return depth;
}

}  // namespace bulletnav::bench
