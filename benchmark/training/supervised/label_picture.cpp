// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/label_picture.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "benchmark/base/scene_names.h"
#include "benchmark/report/marks.h"
#include "benchmark/report/palette.h"
#include "benchmark/report/scene_map.h"
#include "benchmark/training/supervised/near_map.h"
#include "benchmark/training/supervised/scene_panoramas.h"
#include "sim/base/elementary.h"
#include "sim/base/files.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using agent::kDirections;
using sim::Cell;
using Point = Canvas::Point;

constexpr double kWidth = 1040.0;
constexpr double kMargin = 8.0;
constexpr double kPanorama = 256.0;  // height of both panoramas
constexpr double kBottom = 560.0;    // height of the maps
constexpr double kNear = 393.0;      // width of the map of obstacles
constexpr Paint kNo = kVermillion;

/// Where a picture's parts lie, from the top down.
constexpr double kGoalTop = kMargin + kPanorama + kMargin;
constexpr double kMapTop = kGoalTop + kPanorama + kMargin;
constexpr double kHeight = kMapTop + kBottom + kMargin;

std::size_t ColumnOf(const sim::RayGrid& rays, double bearing) {
  std::size_t best = 0;
  double least = HUGE_VAL;
  for (std::size_t c = 0; c < rays.x.size(); ++c) {
    const double here = sim::Atan2(-double{rays.x[c]}, -double{rays.z[c]});
    const double off = std::abs(sim::WrapAngle(here - bearing));
    if (off < least) best = c;
    least = std::min(least, off);
  }
  return best;
}

std::uint8_t Grey(sim::CellState state) {
  if (state == sim::CellState::kUnknown) return 170;
  return state == sim::CellState::kBlocked ? 70 : 240;
}

/// A goal in another room if there is one.
int ChooseGoal(const SceneSamples& samples, int source) {
  const int n = samples.count();
  for (int k = 0; k < n; ++k) {
    const int goal = (source + n / 2 + k) % n;
    if (samples.pair(source, goal).same_node == 0) return goal;
  }
  return source;
}

/// Draws one scene's pictures.
class LabelPictures {
 public:
  LabelPictures(const LabelledScene& scene, const DataConfig& config)
      : samples_(scene.samples),
        config_(config),
        imported_(sim::ImportScene(scene.file, config.import.options())),
        render_scene_(sim::MakeRenderScene(imported_.drawn_mesh(), sim::Backend::kEmbree)),
        panoramas_(*render_scene_, config),
        map_(MakeSceneMap(imported_.mesh, sim::Navmesh(imported_.mesh, config.navmesh),
                          std::nullopt)),
        near_(config) {}

  sim::Image Draw(int source) {
    Canvas canvas(static_cast<int>(kWidth), static_cast<int>(kHeight), kWhite);
    const int goal = ChooseGoal(samples_, source);
    DrawPanorama(source, kMargin, &canvas);
    DrawDirections(source, &canvas);
    DrawPanorama(goal, kGoalTop, &canvas);
    Caption("goal", kGoalTop, &canvas);
    Caption(fmt::format("point {}", source), kMargin, &canvas);
    DrawMap(source, goal, &canvas);
    DrawNearMap(source, &canvas);
    return canvas.ToImage();
  }

 private:
  double zoom() const { return (kWidth - 2.0 * kMargin) / config_.panorama.cols; }

  void DrawPanorama(int sample, double top, Canvas* canvas) {
    sim::Image image(config_.panorama.cols, config_.panorama.rows, 3);
    panoramas_.Render(samples_.poses, {&sample, 1}, image.pixels, {});
    const double upwards = kPanorama / config_.panorama.rows;
    canvas->Picture(
        image, Eigen::Translation2d(kMargin, top) * Eigen::AlignedScaling2d(zoom(), upwards), true);
  }

  static void Caption(const std::string& text, double top, Canvas* canvas) {
    canvas->Text({kMargin + 6.0, top + 12.0}, text,
                 {.size = 13.0, .paint = kInk, .bold = true, .align = Align::kLeft, .halo = true});
  }

  void DrawDirections(int source, Canvas* canvas) const {
    const sim::RayGrid rays(config_.panorama);
    for (int i = 0; i < kDirections; ++i) {
      const double column = static_cast<double>(ColumnOf(rays, BearingOf(i)));
      const double x = kMargin + zoom() * (column + 0.5);
      const Paint& paint = samples_.IsExplorable(source, i) ? kGreen : kNo;
      canvas->Line({x, kMargin + 24.0}, {x, kMargin + kPanorama}, 2.0, paint.WithAlpha(0.8));
      canvas->Text({x, kMargin + 12.0}, std::to_string(i),
                   {.size = 13.0, .paint = paint, .bold = true, .halo = true});
    }
  }

  void DrawMap(int source, int goal, Canvas* canvas) const {
    const double left = kMargin + kNear + kMargin;
    const MapPlace place(map_, {Point(left, kMapTop), Point(kWidth - kMargin, kMapTop + kBottom)});
    DrawSceneMap(map_, place, canvas);
    for (int other = 0; other < samples_.count(); ++other) {
      const Point at = place.At(samples_.poses[static_cast<std::size_t>(other)].position);
      const bool is_same = samples_.pair(source, other).same_node != 0;
      canvas->Disc(at, is_same ? 3.0 : 1.5, (is_same ? kBlue : kInk).WithAlpha(0.5));
    }
    const sim::BodyPose& pose = samples_.poses[static_cast<std::size_t>(source)];
    for (int i = 0; i < kDirections; ++i) {
      const Point at = place.At(samples_.FarPoint(source, i).position);
      const double score = double{samples_.pair(source, goal).far_score(i)};
      canvas->Line(place.At(pose.position), at, 1.5,
                   samples_.IsExplorable(source, i) ? kGreen : kNo.WithAlpha(0.5));
      canvas->Disc(at, 7.0, TimeColor(score));
      canvas->Text(at + Point(0.0, -13.0), fmt::format("{}: {:.2f}", i, score), 10.0, kInk);
    }
    const Eigen::Vector3d ahead = pose.forward();
    DrawStart(place.At(pose.position), sim::Atan2(ahead.z(), ahead.x()), canvas);
    DrawGoal(place.At(samples_.poses[static_cast<std::size_t>(goal)].position), "", canvas);
  }

  /// Ahead is up.
  void DrawNearMap(int source, Canvas* canvas) {
    std::vector<float> depth(config_.panorama.pixels());
    panoramas_.Render(samples_.poses, {&source, 1}, {}, depth);
    near_.Project(depth);
    const int size = near_.states().size();
    sim::Image image(size, size, 3);
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        std::fill_n(image.at(size - 1 - y, size - 1 - x), 3, Grey(near_.states()[{x, y}]));
      }
    }
    const double scale = kNear / size;
    const Point corner(kMargin, kMapTop);
    canvas->Picture(image, Eigen::Translation2d(corner) * Eigen::Scaling(scale), false);
    const Point middle = corner + Point::Constant(0.5 * kNear);
    for (int i = 0; i < kDirections; ++i) {
      const double bearing = BearingOf(i);
      const Point along = Point(-sim::Sin(bearing), -sim::Cos(bearing)) * scale / near_.cell();
      const Paint& paint = near_.IsExplorable(i) ? kGreen : kNo;
      canvas->Line(middle, middle + along * near_.Reach(i), 1.0, paint);
      canvas->Disc(middle + along * near_.Reach(i), 4.0, paint);
      canvas->Ring(middle + along * agent::kNodeRadius, 5.0, {1.5, paint, {}});
      canvas->Text(middle + along * (agent::kNodeRadius - 0.25), std::to_string(i), 11.0, kInk);
    }
  }

  const SceneSamples& samples_;
  const DataConfig& config_;
  sim::ImportedScene imported_;
  std::unique_ptr<const sim::RenderScene> render_scene_;
  ScenePanoramas panoramas_;
  SceneMap map_;
  NearMap near_;
};

}  // namespace

std::vector<fs::path> DrawLabels(const LabelledScene& scene, const DataConfig& config, int count,
                                 const fs::path& folder) {
  sim::MakeFolder(folder);
  LabelPictures pictures(scene, config);
  std::string name = LongSceneName(scene.file.string());
  std::replace(name.begin(), name.end(), '/', '-');
  std::vector<fs::path> files;
  for (int source = 0; source < count; ++source) {
    files.push_back(folder / fmt::format("{}-{:03}.png", name, source));
    sim::WritePng(files.back(), pictures.Draw(source));
  }
  return files;
}

}  // namespace bulletnav::bench
