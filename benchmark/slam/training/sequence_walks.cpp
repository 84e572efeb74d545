// SPDX-License-Identifier: MIT
#include "benchmark/slam/training/sequence_walks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "agent/slam/topology/clusters.h"
#include "benchmark/slam/training/depth_view.h"
#include "benchmark/slam/training/place_views.h"
#include "sim/base/elementary.h"
#include "sim/math/rng.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {
namespace {

constexpr double kStep = 0.25;  // metres
constexpr double kTurn = 10.0 * M_PI / 180.0;
constexpr double kFarthest = 12.0;  // metres between frames that may see the same
constexpr int kStarts = 3;          // of clustering
constexpr int kShortest = 3;        // frames of a sequence

/// Poses along a path, turning on the spot at its corners.
class Walker {
 public:
  Walker(const sim::NavmeshQuery& query, int frames, const sim::Rng& rng)
      : query_(query), frames_(frames), rng_(rng) {}

  std::vector<sim::BodyPose> Walk() {
    poses_.push_back({query_.RandomPoint(&rng_, 0).cast<double>(), rng_.Uniform(-M_PI, M_PI)});
    while (!IsDone()) {
      const auto path =
          query_.FindPath(poses_.back().position.cast<float>(), query_.RandomPoint(&rng_, 0));
      if (!path || path->points.size() < 2) continue;
      for (std::size_t i = 1; i < path->points.size() && !IsDone(); ++i) {
        GoTo(path->points[i].cast<double>());
      }
    }
    return std::move(poses_);
  }

 private:
  bool IsDone() const { return static_cast<int>(poses_.size()) >= frames_; }

  void GoTo(const Eigen::Vector3d& corner) {
    const Eigen::Vector3d start = poses_.back().position;
    const double dx = corner.x() - start.x();
    const double dz = corner.z() - start.z();
    const double length = std::hypot(dx, dz);
    if (length < 1e-3) return;
    const double yaw = sim::Atan2(-dx, -dz);
    while (!IsDone()) {
      const double left = sim::WrapAngle(yaw - poses_.back().yaw);
      if (std::abs(left) < kTurn) break;
      poses_.push_back({start, sim::WrapAngle(poses_.back().yaw + std::copysign(kTurn, left))});
    }
    const int steps = std::max(1, static_cast<int>(std::lround(length / kStep)));
    for (int i = 1; i <= steps && !IsDone(); ++i) {
      poses_.push_back({start + (corner - start) * i / steps, yaw});
    }
  }

  const sim::NavmeshQuery& query_;
  int frames_;
  sim::Rng rng_;
  std::vector<sim::BodyPose> poses_;
};

void FindCovisible(const std::vector<sim::BodyPose>& poses, DepthEye* eye, SequenceWalk* walk) {
  std::vector<DepthThumbnail> seen;
  seen.reserve(poses.size());
  for (const sim::BodyPose& pose : poses) seen.push_back(eye->See(pose));
  walk->is_covisible.assign(poses.size() * poses.size(), 1);
  for (std::size_t a = 0; a < poses.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const sim::PlanarPose motion = sim::RelativePose(poses[a], poses[b]);
      const bool is_near = std::hypot(motion.x, motion.y) <= kFarthest;
      const bool is = is_near && Covisibility(seen[a], seen[b], motion) >= kSamePlace;
      walk->is_covisible[a * poses.size() + b] = is ? 1 : 0;
      walk->is_covisible[b * poses.size() + a] = is ? 1 : 0;
    }
  }
}

std::vector<agent::Sequence> CutIntoSequences(
    const std::vector<agent::PictureDescriptor>& descriptors, const sim::Rng& rng) {
  const auto size = static_cast<Eigen::Index>(descriptors.front().size());
  Eigen::MatrixXf points(static_cast<Eigen::Index>(descriptors.size()), size);
  for (Eigen::Index row = 0; row < points.rows(); ++row) {
    for (Eigen::Index i = 0; i < size; ++i) {
      points(row, i) =
          static_cast<float>(
              descriptors[static_cast<std::size_t>(row)][static_cast<std::size_t>(i)]) /
          agent::kDescriptorUnit;
    }
  }
  sim::Rng clusters = rng.Fork("clusters");
  const agent::Clusters found = agent::ClusterByElbow(points, {.starts = kStarts}, &clusters);
  return agent::SequencesOf(found.group, kShortest);
}

}  // namespace

double ShareCovisible(const SequenceWalk& walk, const Window& a, const Window& b) {
  int found = 0;
  for (int i = a.first; i < a.first + a.count; ++i) {
    const auto row =
        walk.is_covisible.begin() + static_cast<std::ptrdiff_t>(i) * walk.frames + b.first;
    if (std::find(row, row + b.count, 1) != row + b.count) ++found;
  }
  return a.count == 0 ? 0.0 : static_cast<double>(found) / a.count;
}

SequenceWalk MakeSequenceWalk(const sim::World& world, const PlaceDataConfig& data,
                              const WalkSpec& spec, agent::PictureDescriber* describer) {
  world.RequireFloor();
  const sim::NavmeshQuery query(world.navmesh());
  const sim::Rng rng(sim::MixSeed(spec.seed, world.id()), "sequence walk");
  const std::vector<sim::BodyPose> poses = Walker(query, spec.frames, rng.Fork("way")).Walk();
  SequenceWalk walk;
  walk.frames = static_cast<int>(poses.size());
  const auto renderer = world.render_scene().MakeRenderer(data.camera);
  std::vector<std::uint8_t> color(data.camera.pixels() * 3);
  for (const sim::BodyPose& pose : poses) {
    const sim::CameraPose eye = EyeAt(pose, data.body);
    renderer->Render({&eye, 1}, color, {});
    walk.descriptors.push_back(describer->Describe(color, data.camera.cols, data.camera.rows));
    const std::vector<std::uint8_t> cells = describer->Cells();
    walk.frame_bytes = cells.size();
    walk.cells.insert(walk.cells.end(), cells.begin(), cells.end());
  }
  walk.sequences = CutIntoSequences(walk.descriptors, rng);
  DepthEye depth(world.render_scene(), data);
  FindCovisible(poses, &depth, &walk);
  return walk;
}

std::vector<SequenceWalk> MakeSequenceWalks(const PlaceDataConfig& data, int scenes, int runs,
                                            int frames, const std::filesystem::path& descriptor,
                                            const std::function<void()>& on_scene) {
  std::vector<std::filesystem::path> files = ScenesOf(data);
  if (scenes > 0 && scenes < static_cast<int>(files.size())) {
    files.resize(static_cast<std::size_t>(scenes));
  }
  std::vector<SequenceWalk> walks(files.size() * static_cast<std::size_t>(runs));
  sim::WorkerPool pool(0);
  pool.ForEach(static_cast<int>(files.size()), [&](int task, int /*worker*/) {
    const auto describer = agent::LoadPictureDescriber(descriptor);
    const auto world =
        sim::World::Load(files[static_cast<std::size_t>(task)],
                         {data.import.options(), data.navmesh, sim::Backend::kEmbree});
    for (int run = 0; run < runs; ++run) {
      const WalkSpec spec = {frames, sim::MixSeed(data.seed, static_cast<std::uint64_t>(run))};
      walks[static_cast<std::size_t>(task) * static_cast<std::size_t>(runs) +
            static_cast<std::size_t>(run)] = MakeSequenceWalk(*world, data, spec, describer.get());
    }
    if (on_scene) on_scene();
  });
  return walks;
}

}  // namespace bulletnav::bench
