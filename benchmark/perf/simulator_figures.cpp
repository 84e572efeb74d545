// SPDX-License-Identifier: MIT
#include "benchmark/perf/simulator_figures.h"

#include <chrono>
#include <memory>
#include <optional>

#include <fmt/core.h>

#include "benchmark/perf/process.h"
#include "benchmark/perf/subdivide.h"
#include "sim/base/elementary.h"
#include "sim/base/error.h"
#include "sim/batch_simulator.h"
#include "sim/render/cpu/raycaster.h"
#include "sim/render/render_mesh.h"

namespace bulletnav::bench {
namespace {

using sim::Backend;

constexpr int kPoses = 48;
constexpr std::size_t kMillion = 1'000'000;

sim::PanoramaSpec Size(int cols) {
  sim::PanoramaSpec spec;
  spec.cols = cols;
  spec.rows = cols / 4;
  return spec;
}

/// Free places spread over the scene, always the same.
std::vector<sim::BodyPose> Poses(const sim::World& world) {
  world.RequireFloor();
  const sim::NavmeshQuery query(world.navmesh());
  sim::Rng rng(1, "bench");
  sim::CapsuleBody body(world.physics(), {});
  std::vector<sim::BodyPose> poses;
  while (poses.size() < kPoses) {
    const Eigen::Vector3f p = query.RandomPoint(&rng, 0);
    const auto pose = body.TryReset({p.cast<double>(), rng.Uniform(-sim::kPi, sim::kPi)});
    if (pose) poses.push_back(*pose);
  }
  return poses;
}

std::vector<sim::CameraPose> Cameras(const std::vector<sim::BodyPose>& poses) {
  std::vector<sim::CameraPose> cameras;
  for (const sim::BodyPose& pose : poses) {
    const Eigen::Vector3d eye =
        pose.position + Eigen::Vector3d(0, sim::BodySpec().camera_height, 0);
    cameras.push_back({eye.cast<float>(), static_cast<float>(pose.yaw)});
  }
  return cameras;
}

class SimulatorBench {
 public:
  SimulatorBench(const BenchScene& scene, const std::filesystem::path& program,
                 const std::function<void(const BenchFigure&)>& tell)
      : scene_(scene), program_(program), tell_(tell) {
    const sim::ImportedScene imported = sim::ImportScene(scene.file, scene.import);
    mesh_ = imported.mesh;
    name_ = scene.file.filename().string();
    sim::WorldOptions options;
    options.backend = Backend::kEmbree;
    world_ = std::make_shared<const sim::World>(name_, imported, options);
    poses_ = Poses(*world_);
    cameras_ = Cameras(poses_);
  }

  void Run() {
    Tell("triangles", static_cast<double>(mesh_.triangles.size()), "triangles", "", 1);
    const double one = Panoramas(world_->render_scene(), 512, "panoramas_512x128");
    Bound(one);
    const double two = Batch(2);
    Tell("panoramas_512x128_two_workers", two, "panoramas/s", "embree", 2);
    Tell("two_workers_over_one", two / Batch(1), "ratio", "embree", 2);
    Panoramas(world_->render_scene(), 256, "panoramas_256x64");
    sim::SceneMesh mesh = mesh_;
    Faster(&mesh);
    Steps();
    Egl();
    Million();
    Start();
  }

 private:
  void Tell(const std::string& name, double value, const std::string& unit,
            const std::string& backend, int workers) {
    tell_({name, value, unit, name_, backend, workers});
  }

  /// RGBD panoramas a second, one after the other on this thread.
  double Panoramas(const sim::RenderScene& scene, int cols, const std::string& name) {
    const sim::PanoramaSpec spec = Size(cols);
    const auto renderer = scene.MakeRenderer(spec);
    const auto n = static_cast<std::size_t>(renderer->preferred_batch());
    std::vector<std::uint8_t> color(3 * spec.pixels() * n);
    std::vector<float> depth(spec.pixels() * n);
    std::vector<sim::CameraPose> batch(n);
    std::size_t next = 0;
    const auto work = [&] {
      for (sim::CameraPose& camera : batch) camera = cameras_[next++ % cameras_.size()];
      renderer->Render(batch, color, depth);
    };
    const double rate = MedianRate(work, static_cast<int>(n));
    Tell(name, rate, "panoramas/s", BackendName(scene.backend()), 1);
    return rate;
  }

  static std::string BackendName(Backend backend) {
    return backend == Backend::kEgl ? "egl" : "embree";
  }

  /// Plain Embree on the same rays, depth only: sixteen rays a packet in 4 x 4 tiles.
  void Bound(double panoramas) {
    const sim::RenderMesh triangles(mesh_);
    const sim::Raycaster raycaster(triangles.corners);
    const sim::PanoramaSpec spec = Size(512);
    const sim::RayGrid grid(spec);
    std::vector<float> depth(spec.pixels());
    std::size_t next = 0;
    const double rate = MedianRate(
        [&] {
          CastAll(raycaster, grid, spec, cameras_[next++ % cameras_.size()], &depth);
        },
        1);
    Tell("embree_rays_512x128_depth_only", rate, "panoramas/s", "embree", 1);
    Tell("panoramas_over_embree_rays", panoramas / rate, "ratio", "embree", 1);
  }

  static void CastAll(const sim::Raycaster& raycaster, const sim::RayGrid& grid,
                      const sim::PanoramaSpec& spec, const sim::CameraPose& camera,
                      std::vector<float>* depth) {
    const float c = sim::Cos(camera.yaw);
    const float s = sim::Sin(camera.yaw);
    const auto cols = static_cast<std::size_t>(spec.cols);
    const std::size_t tiles_a_row = cols / 4;
    std::array<std::array<float, 16>, 3> rays{};
    std::array<sim::RayHit, 16> hits;
    for (std::size_t tile = 0; tile < spec.pixels() / 16; ++tile) {
      const std::size_t row = 4 * (tile / tiles_a_row);
      const std::size_t col = 4 * (tile % tiles_a_row);
      for (std::size_t i = 0; i < 16; ++i) {
        const std::size_t x = col + i % 4;
        rays[0][i] = grid.x[x] * c + grid.z[x] * s;
        rays[1][i] = grid.y[row + i / 4];
        rays[2][i] = grid.z[x] * c - grid.x[x] * s;
      }
      raycaster.CastPacket(camera.position, rays, &hits);
      for (std::size_t i = 0; i < 16; ++i) (*depth)[(row + i / 4) * cols + col + i % 4] = hits[i].t;
    }
  }

  /// Panoramas a second of a batch over some workers.
  double Batch(int workers) {
    constexpr int kLanes = 16;
    sim::SimulatorSpec spec;
    sim::BatchSimulator batch(std::vector(kLanes, world_), spec, workers);
    for (int lane = 0; lane < kLanes; ++lane) {
      batch.Reset(lane, poses_[static_cast<std::size_t>(lane)]);
    }
    std::vector<std::uint8_t> color(3 * spec.panorama.pixels() * kLanes);
    std::vector<float> depth(spec.panorama.pixels() * kLanes);
    return MedianRate(
        [&] {
          batch.Observe({color, depth});
        },
        kLanes, 0.5);
  }

  /// Whole steps: noise, sweep, odometry, RGBD panorama; and what of it is physics.
  void Steps() {
    sim::SimulatorSpec spec;
    sim::Simulator simulator(world_, spec);
    sim::SimulatedBody body(world_, spec.body, sim::NoiseModel(spec.noise));
    sim::Rng rng(2, "steps");
    int count = 0;
    const auto action = [&] {
      return rng.Chance(0.6) ? sim::Action::kMoveForward
                             : (rng.Chance(0.5) ? sim::Action::kTurnLeft : sim::Action::kTurnRight);
    };
    const auto pose = [&] {
      return poses_[static_cast<std::size_t>(count) / 50 % poses_.size()];
    };
    const double whole = MedianRate(
        [&] {
          if (count++ % 50 == 0) simulator.Reset(pose());
          simulator.Step(action());
        },
        1);
    count = 0;
    const double physics = MedianRate(
        [&] {
          if (count++ % 50 == 0) body.Reset(pose(), {});
          body.Step(action());
        },
        1);
    Tell("steps", whole, "steps/s", "embree", 1);
    Tell("step_without_panorama", 1e6 / physics, "us", "", 1);
    Tell("physics_share", 100.0 * whole / physics, "%", "embree", 1);
  }

  void Egl() {
    try {
      const auto scene = sim::MakeRenderScene(mesh_, Backend::kEgl);
      Panoramas(*scene, 512, "panoramas_512x128");
    } catch (const sim::RenderError& e) {
      fmt::print(stderr, "bulletnav: no EGL figures: {}\n", e.what());
    }
  }

  void Million() {
    sim::SceneMesh fine = Subdivided(mesh_, kMillion);
    const std::string name = name_;
    name_ +=
        fmt::format(" in {:.1f}M triangles", static_cast<double>(fine.triangles.size()) * 1e-6);
    Panoramas(*sim::MakeRenderScene(fine, Backend::kEmbree), 512, "panoramas_512x128");
    Faster(&fine);
    name_ = name;
  }

  /// With the finishes that leave out what can hardly be seen.
  void Faster(sim::SceneMesh* mesh) {
    mesh->back_faces = false;
    Both(*mesh, "no_back_faces");
    mesh->levels_of_detail = true;
    Both(*mesh, "no_back_faces_levels_of_detail");
  }

  void Both(const sim::SceneMesh& mesh, const std::string& finish) {
    const auto scene = sim::MakeRenderScene(mesh, Backend::kEmbree);
    Panoramas(*scene, 512, "panoramas_512x128_" + finish);
    Panoramas(*scene, 256, "panoramas_256x64_" + finish);
  }

  /// A process of its own: from its start to its first observation, and the memory it then holds.
  void Start() {
    std::vector<double> seconds;
    std::optional<FirstObservation> last;
    for (int run = 0; run < 5; ++run) {
      last = MeasureFirstObservation(program_, scene_.file, scene_.import);
      seconds.push_back(last->seconds);
    }
    Tell("first_observation", Median(seconds), "s", "embree", 1);
    Tell("memory", last->memory_mb, "MB", "embree", 1);
    Tell("memory_of_second_worker", last->second_worker_mb, "MB", "embree", 2);
  }

  BenchScene scene_;
  std::filesystem::path program_;
  const std::function<void(const BenchFigure&)>& tell_;
  sim::SceneMesh mesh_;
  std::string name_;
  std::shared_ptr<const sim::World> world_;
  std::vector<sim::BodyPose> poses_;
  std::vector<sim::CameraPose> cameras_;
};

}  // namespace

void MeasureSimulator(const BenchScene& scene, const std::filesystem::path& program,
                      const std::function<void(const BenchFigure&)>& tell) {
  SimulatorBench(scene, program, tell).Run();
}

}  // namespace bulletnav::bench
