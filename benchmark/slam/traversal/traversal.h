// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "benchmark/slam/io/tum.h"
#include "sim/image/image.h"
#include "sim/math/pose.h"
#include "sim/noise/noise_model.h"
#include "sim/physics/body_spec.h"
#include "sim/render/projection.h"
#include "sim/world.h"

namespace bulletnav::bench {

/// A drive through a scene with one level camera.
struct TraversalSpec {
  sim::BodySpec body;
  sim::PinholeSpec camera;
  std::optional<sim::PanoramaSpec> panorama;            // seen instead of the camera; cylindrical
  sim::NoiseMode noise = sim::NoiseMode::kAnsReleased;  // of motion and odometry
  std::string sensor_noise = "none";                    // of pictures, see sim::NamedSensorNoise
  int actions = 700;
  std::uint64_t seed = 1;

  /// Throws sim::Error for bad cameras, a camera that is not level, other panoramas, noise that is
  /// not known, and no actions.
  void Validate() const;
};

/// The scene that is driven through as it is from a frame on.
struct ChangedScene {
  std::shared_ptr<const sim::World> world;  // null: it stays as it was
  int from_step = 0;
  /// Furniture stands elsewhere: the body goes on by the floor that is free now, from the first
  /// frame on in which it stands on it. Else the geometry is the same, and so is the body's way.
  bool is_refurnished = false;
};

struct TraversalFrame {
  int step = 0;  // actions taken before it
  sim::Image color;
  DepthPicture depth;             // along the camera's axis; 0 from the camera's limit on
  std::vector<float> ranges;      // of panoramas, whose `depth` is level: along the rays
  DepthPicture true_depth;        // `depth` without noise, for measuring only; empty: it has none
  sim::BodyPose true_pose;        // for measuring only
  sim::PlanarPose dead_reckoned;  // odometry added up, from the first frame's body
};

/// Drives and calls `take` with the first frame and that after each action, `actions` + 1 in all.
/// The route goes by places spread over the largest floor, nearest first, then by the same places
/// the other way round, so that they are seen from other headings, then to places at random.
/// The driver knows the truth, as the shortest_path agent does; frames have noise in odometry.
/// Deterministic: a function of world and spec. Throws sim::Error if there is nowhere to stand.
/// Source: Sharma et al., "Hierarchical Unsupervised Topological SLAM", 2023, section IV; the route
/// is ours.
void Traverse(const std::shared_ptr<const sim::World>& world, const TraversalSpec& spec,
              const std::function<void(const TraversalFrame&)>& take);
/// Likewise; frames from `changed.from_step` on show its world. Costs two simulators.
/// Throws sim::Error also if that world's geometry is another though it is not refurnished, so that
/// the body moves otherwise, and if it is refurnished so that the body never finds room there.
void Traverse(const std::shared_ptr<const sim::World>& world, const ChangedScene& changed,
              const TraversalSpec& spec, const std::function<void(const TraversalFrame&)>& take);

/// Of a camera's pictures.
Intrinsics IntrinsicsOf(const sim::PinholeSpec& camera);

/// Turns distances along rays into depth along the camera's axis; what lies at the camera's limit
/// or beyond becomes 0, none. Expects: as many values as pixels (checked).
DepthPicture AlongAxis(std::span<const float> ranges, const sim::PinholeSpec& camera);
/// Likewise of a cylindrical panorama: into level distances.
DepthPicture Levelled(std::span<const float> ranges, const sim::PanoramaSpec& panorama);

}  // namespace bulletnav::bench
