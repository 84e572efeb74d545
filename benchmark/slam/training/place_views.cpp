// SPDX-License-Identifier: MIT
#include "benchmark/slam/training/place_views.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include "agent/slam/descriptors/shrink_picture.h"
#include "benchmark/slam/training/depth_view.h"
#include "benchmark/slam/truth/covisibility.h"
#include "sim/base/elementary.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

constexpr int kStands = 600;      // points of the floor that views are taken from
constexpr int kTries = 16;        // for a view
constexpr int kTriesAPlace = 12;  // for a place
constexpr double kNearest = 0.7;  // metres from a view to what it looks at
constexpr double kFarthest = 4.5;
constexpr double kStorey = 0.6;       // metres of height between floors of one storey, at most
constexpr double kAside = 0.35;       // radians that a view looks beside it
constexpr double kTurned = M_PI / 2;  // that is a view from another side
constexpr float kLeastDepth = 0.8f;   // mean metres of a first view: no picture of a wall alone

struct View {
  sim::BodyPose pose;
  DepthThumbnail seen;
};

class ViewMaker {
 public:
  ViewMaker(const sim::World& world, const sim::RenderScene* changed, const PlaceDataConfig& config)
      : config_(config),
        rng_(sim::MixSeed(config.seed, world.id()), "places"),
        query_(world.navmesh()),
        depth_(world.render_scene(), config),
        plain_(world.render_scene().MakeRenderer(config.camera)),
        changed_(changed != nullptr ? changed->MakeRenderer(config.camera) : nullptr) {
    sim::Rng stands = rng_.Fork("stands");
    for (int i = 0; i < kStands; ++i) {
      stands_.push_back(query_.RandomPoint(&stands, 0).cast<double>());
    }
  }

  PlaceViews Make() {
    std::vector<View> views;
    PlaceViews made;
    for (int place = 0; place < config_.places; ++place) {
      for (int i = 0; i < kTriesAPlace; ++i) {
        sim::Rng rng = rng_.Fork("place", static_cast<std::uint64_t>(place) * kTriesAPlace +
                                              static_cast<std::uint64_t>(i));
        const std::vector<View> found = Place(&rng);
        if (found.empty()) continue;
        views.insert(views.end(), found.begin(), found.end());
        ++made.places;
        break;
      }
    }
    if (made.places == 0) throw sim::Error("no place can be seen from several sides");
    made.views = config_.views;
    made.rows = kViewRows;
    made.cols = kViewCols;
    Compare(views, &made);
    Draw(&made);
    return made;
  }

 private:
  View See(const sim::BodyPose& pose) { return {pose, depth_.See(pose)}; }

  /// All views of a place, or none.
  std::vector<View> Place(sim::Rng* rng) {
    std::vector<View> views;
    views.push_back(See({rng->Pick(stands_), rng->Uniform(-M_PI, M_PI)}));
    const std::optional<Eigen::Vector3d> target = Target(views.front(), rng);
    if (!target) return {};
    for (int i = 1; i < config_.views; ++i) {
      // One of them is to be from the other side.
      std::optional<View> other = Other(views.front(), *target, i == 1, rng);
      if (!other && i == 1) other = Other(views.front(), *target, false, rng);
      if (!other) return {};
      views.push_back(std::move(*other));
    }
    // So that pictures in either look are from all sides.
    rng->Shuffle(views);
    return views;
  }

  /// A point that a view sees, to look at it from elsewhere.
  static std::optional<Eigen::Vector3d> Target(const View& view, sim::Rng* rng) {
    const std::vector<Eigen::Vector3f>& points = view.seen.points;
    float sum = 0.0f;
    for (const Eigen::Vector3f& point : points) sum += point.x();
    if (points.empty() || sum < kLeastDepth * static_cast<float>(points.size())) return {};
    const Eigen::Vector3d point = rng->Pick(points).cast<double>();
    return view.pose.position + point.x() * view.pose.forward() + point.y() * view.pose.left();
  }

  std::optional<View> Other(const View& first, const Eigen::Vector3d& target, bool is_turned,
                            sim::Rng* rng) {
    for (int i = 0; i < kTries; ++i) {
      const std::optional<sim::BodyPose> pose = Stand(target, rng);
      if (!pose) return {};
      const double turn = std::abs(sim::WrapAngle(pose->yaw - first.pose.yaw));
      if (is_turned && turn < kTurned) continue;
      View view = See(*pose);
      const sim::PlanarPose motion = sim::RelativePose(first.pose, view.pose);
      if (Covisibility(first.seen, view.seen, motion) >= kSamePlace) return view;
    }
    return {};
  }

  /// Somewhere around, looking at it.
  std::optional<sim::BodyPose> Stand(const Eigen::Vector3d& target, sim::Rng* rng) const {
    for (int i = 0; i < 20 * kTries; ++i) {
      const Eigen::Vector3d& stand = rng->Pick(stands_);
      const double dx = target.x() - stand.x();
      const double dz = target.z() - stand.z();
      const double distance = std::hypot(dx, dz);
      const bool is_near = distance >= kNearest && distance <= kFarthest &&
                           std::abs(target.y() - stand.y()) <= kStorey;
      if (!is_near) continue;
      const double yaw = sim::Atan2(-dx, -dz) + rng->Uniform(-kAside, kAside);
      return sim::BodyPose{stand, sim::WrapAngle(yaw)};
    }
    return {};
  }

  void Compare(const std::vector<View>& views, PlaceViews* made) const {
    const std::size_t count = views.size();
    made->shared.assign(count * count, 255);
    for (std::size_t a = 0; a < count; ++a) {
      made->poses.push_back(views[a].pose);
      for (std::size_t b = 0; b < a; ++b) {
        const sim::PlanarPose motion = sim::RelativePose(views[a].pose, views[b].pose);
        const bool is_level =
            std::abs(views[a].pose.position.y() - views[b].pose.position.y()) <= kStorey;
        const double share = is_level ? Covisibility(views[a].seen, views[b].seen, motion) : 0.0;
        const auto byte = static_cast<std::uint8_t>(std::lround(255.0 * share));
        made->shared[a * count + b] = byte;
        made->shared[b * count + a] = byte;
      }
    }
  }

  void Draw(PlaceViews* made) {
    std::vector<std::uint8_t> color(config_.camera.pixels() * 3);
    for (std::size_t i = 0; i < made->poses.size(); ++i) {
      sim::Renderer& renderer = changed_ && i % 2 == 1 ? *changed_ : *plain_;
      const sim::CameraPose eye = EyeAt(made->poses[i], config_.body);
      renderer.Render({&eye, 1}, color, {});
      const auto small = agent::ShrinkPicture(color, config_.camera.cols, config_.camera.rows,
                                              kViewRows, kViewCols);
      made->pictures.insert(made->pictures.end(), small.begin(), small.end());
    }
  }

  const PlaceDataConfig& config_;
  sim::Rng rng_;
  sim::NavmeshQuery query_;
  DepthEye depth_;
  std::unique_ptr<sim::Renderer> plain_;
  std::unique_ptr<sim::Renderer> changed_;  // null: nothing changes
  std::vector<Eigen::Vector3d> stands_;
};

}  // namespace

PlaceViews MakePlaceViews(const sim::World& world, const sim::RenderScene* changed,
                          const PlaceDataConfig& config) {
  world.RequireFloor();
  return ViewMaker(world, changed, config).Make();
}

}  // namespace bulletnav::bench
