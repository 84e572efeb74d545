// SPDX-License-Identifier: MIT
#include "benchmark/report/trajectory_plot.h"

#include <gmock/gmock.h>

#include "benchmark/report/belief_layer.h"
#include "benchmark/report/palette.h"
#include "benchmark/report/side_column.h"
#include "benchmark/report/trajectory_layers.h"
#include "sim/base/files.h"
#include "tests/support/scenes.h"
#include "tests/support/svg.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/trajectories.h"

namespace bulletnav::bench {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// The room of MadeUpTrajectory.
const SceneMap& RoomMap() {
  static const SceneMap map = [] {
    const sim::SceneMesh mesh = tests::BoxRoom(4, 2.6f, 4);
    return MakeSceneMap(mesh, sim::Navmesh(mesh, {}), {});
  }();
  return map;
}

const MapPlace& Place() {
  static const MapPlace place(RoomMap(), {Canvas::Point(0, 0), Canvas::Point(500, 500)});
  return place;
}

template <class Draw>
sim::Image Layer(const Draw& draw) {
  Canvas canvas(500, 500, kWhite);
  draw(&canvas);
  return canvas.ToImage();
}

Paint At(const sim::Image& image, double x, double z) {
  const Canvas::Point p = Place().At(x, z);
  const std::uint8_t* c = image.at(static_cast<int>(p.x()), static_cast<int>(p.y()));
  return {c[0] / 255.0, c[1] / 255.0, c[2] / 255.0};
}

double Difference(const Paint& a, const Paint& b) {
  return std::max(
      {std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)});
}

TEST(TrajectoryLayers, TruePathHasTheColourOfItsTime) {
  const EpisodeTrajectory trajectory = tests::MadeUpTrajectory();
  const sim::Image image = Layer([&](Canvas* canvas) {
    DrawTruePath(trajectory, trajectory.steps.size(), Place(), canvas);
  });
  const auto steps = static_cast<double>(trajectory.steps.size() - 1);  // without the stop
  // In the middle of the fourth step's move, and of the second of those after eight and nine turns.
  EXPECT_LT(Difference(At(image, 1.0, -1.875), TimeColor(4 / steps)), 0.03);
  EXPECT_LT(Difference(At(image, 1.375, -3.0), TimeColor(19 / steps)), 0.03);
  EXPECT_LT(Difference(At(image, 2.0, -2.0), kWhite), 0.01);
}

TEST(TrajectoryLayers, PathIsDrawnUntilTheStepAskedFor) {
  const EpisodeTrajectory trajectory = tests::MadeUpTrajectory();
  const sim::Image image = Layer([&](Canvas* canvas) {
    DrawTruePath(trajectory, 4, Place(), canvas);
  });
  EXPECT_GT(Difference(At(image, 1.0, -1.875), kWhite), 0.3);
  EXPECT_LT(Difference(At(image, 1.0, -2.625), kWhite), 0.01);
}

TEST(TrajectoryLayers, CollisionsNearEachOtherHaveOneCross) {
  EpisodeTrajectory trajectory = tests::MadeUpTrajectory();
  const Canvas::Point first = Place().At(trajectory.steps[7].pose.position);
  EXPECT_THAT(CollisionMarks(trajectory, Place()), testing::ElementsAre(first));
  for (std::size_t i = 8; i < 17; ++i) trajectory.steps[i].collided = true;  // turns on the spot
  EXPECT_THAT(CollisionMarks(trajectory, Place()), testing::ElementsAre(first));
  trajectory.steps[24].collided = true;
  EXPECT_EQ(CollisionMarks(trajectory, Place()).size(), 2u);
}

TEST(TrajectoryLayers, MapOfTheAgentLiesAsSeenFromTheStart) {
  const EpisodeTrajectory trajectory = tests::MadeUpTrajectory();
  EpisodeTrajectory map_only = trajectory;
  map_only.belief.graph.reset();
  map_only.belief.target.reset();
  const sim::Image image = Layer([&](Canvas* canvas) {
    DrawBelief(map_only, Place(), canvas);
  });
  // Cell (2, 1) of half a metre lies 0.75 m ahead of the start and 0.25 m to its left, cell (2, 2)
  // 0.75 m to the left; the start looks along -z.
  const Paint obstacle = At(image, 0.75, -1.75);
  EXPECT_GT(Difference(obstacle, kWhite), 0.1);
  const Paint felt_wall = At(image, 0.25, -1.75);
  EXPECT_LT(Difference(felt_wall, MapPaint(agent::MapPicture::Kind::kFeltWall)), 0.1);
  EXPECT_GT(Difference(felt_wall, GraphPathStroke().paint), 0.3) << "not taken for the path";
  EXPECT_GT(Difference(felt_wall, obstacle), 0.3);
  EXPECT_LT(Difference(At(image, 1.75, -1.75), kWhite), 0.01) << "unknown";
}

TEST(TrajectoryPlot, SvgIsSoundAndTheSameEachTime) {
  const EpisodeTrajectory trajectory = tests::MadeUpTrajectory();
  TrajectoryPlotSpec spec;
  spec.belief = true;
  const std::string svg = ToSvg(TrajectoryPlot(RoomMap(), trajectory, spec));
  EXPECT_EQ(tests::SvgProblem(svg), "");
  EXPECT_EQ(ToSvg(TrajectoryPlot(RoomMap(), trajectory, spec)), svg);
  EXPECT_NE(ToSvg(TrajectoryPlot(RoomMap(), trajectory)), svg);
}

TEST(TrajectoryPlot, LongTitlesTakeMoreLines) {
  Canvas measure(1, 1, kWhite);
  const auto height = [&](const std::string& title) {
    SideColumn column({0.0, 0.0}, &measure);
    column.Title(title);
    return column.bottom();
  };
  const std::string longer = "Neural Topological SLAM without its score function, noise doubled";
  EXPECT_EQ(height("Random"), height("Neural Topological SLAM (NTS)"));
  EXPECT_GT(height(longer), height("Random"));
  EXPECT_GT(height(longer + ", " + longer), height(longer));
  EXPECT_EQ(height(std::string(150, 'x')), height("Random")) << "one word is made smaller";
}

TEST(TrajectoryPlot, PicturesAreTheSameEachTime) {
  const EpisodeTrajectory trajectory = tests::MadeUpTrajectory();
  EXPECT_EQ(ToImage(TrajectoryPlot(RoomMap(), trajectory)).pixels,
            ToImage(TrajectoryPlot(RoomMap(), trajectory)).pixels);
}

TEST(TrajectoryPlot, EpisodeWithoutStepsIsDrawn) {
  EpisodeTrajectory trajectory = tests::MadeUpTrajectory();
  trajectory.steps.clear();
  trajectory.shortest_path.clear();
  EXPECT_EQ(tests::SvgProblem(ToSvg(TrajectoryPlot(RoomMap(), trajectory))), "");
}

TEST(TrajectoryPlot, BothKindsOfFilesAreWrittenUnderAnyName) {
  const tests::TemporaryFolder folder;
  WriteFigure(TrajectoryPlot(RoomMap(), tests::MadeUpTrajectory()), folder.path() / "a-0.5");
  EXPECT_THAT(sim::ReadTextFile(folder.path() / "a-0.5.svg"), HasSubstr("<svg"));
  EXPECT_GT(sim::DecodeImage(sim::ReadFile(folder.path() / "a-0.5.png")).width, 500);
}

TEST(TrajectoryPlot, OutcomeSaysWhatBecameOfIt) {
  EpisodeTrajectory trajectory = tests::MadeUpTrajectory();
  EXPECT_THAT(OutcomeLines(trajectory), Contains("house, episode 12 (easy)"));
  EXPECT_THAT(OutcomeLines(trajectory), Contains("success, SPL 0.62"));
  EXPECT_THAT(OutcomeLines(trajectory), Contains("25 steps, 1 collision"));
  EXPECT_THAT(OutcomeLines(trajectory), Contains("walked 4.0 m, shortest 2.5 m"));
  trajectory.result.goals[0]["success"] = false;
  EXPECT_THAT(OutcomeLines(trajectory), Contains("failed, 0.2 m from the goal"));
  trajectory.result.goals.push_back(trajectory.result.goals[0]);
  trajectory.result.goals[1]["success"] = true;
  EXPECT_THAT(OutcomeLines(trajectory), Contains(HasSubstr("1 of 2 goals")));
  EXPECT_THAT(OutcomeLines(trajectory), Contains("walked 8.0 m in all"));
  EXPECT_THAT(OutcomeLines(trajectory), Contains("to goals reached 4.0 m, shortest 2.5 m"));
  trajectory.result.failure = "threw: no map";
  EXPECT_THAT(OutcomeLines(trajectory), Contains("failed: threw: no map"));
}

}  // namespace
}  // namespace bulletnav::bench
