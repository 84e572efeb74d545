// SPDX-License-Identifier: MIT
// The exploration policy: what it is shown, how goals come of what it says, and its integers.
#include <cmath>

#include <gmock/gmock.h>

#include "agent/integer/quantised_file.h"
#include "agent/models/model_registry.h"
#include "agent/policy/exploration_view.h"
#include "agent/policy/integer_exploration.h"
#include "agent/policy/quantise_exploration.h"
#include "sim/base/error.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::agent {
namespace {

using ::testing::HasSubstr;

/// Sees a random patch around the body.
class RandomView final : public ViewWindow {
 public:
  RandomView() : ViewWindow(65) {}
  void Project(const Panorama& /*panorama*/, double /*x*/, double /*y*/, double /*yaw*/) override {
    Clear();
    for (std::size_t i = 0; i < seen_.values().size(); ++i) {
      seen_[i] = rng_.Chance(0.5) ? 1 : 0;
      obstacle_points_[i] = rng_.Chance(0.05) ? 3 : 0;
    }
  }

 private:
  sim::Rng rng_{3, "view"};
};

MetricMap SomeMap(const sim::PlanarPose& pose) {
  MetricMap map(MapSpec{}, std::make_unique<RandomView>(), sim::PlanarPose{});
  map.Clear({});
  map.MarkTrack({}, pose);
  map.Update({}, pose);
  return map;
}

TEST(ExplorationView, IsTheLargestOfTheCellsOfEachPixel) {
  const sim::PlanarPose pose{1.3, -0.7, 0.4};
  const MetricMap map = SomeMap(pose);
  std::vector<std::uint8_t> view(kExplorationBytes);
  WriteExplorationView(map, pose, view);
  const sim::Cell here = map.CellAt({pose.x, pose.y});
  const auto what = [&](const sim::Cell& cell) {
    if (!map.states().Contains(cell)) return 0;
    const bool is_here = std::abs(cell.x - here.x) <= 1 && std::abs(cell.y - here.y) <= 1;
    return (map.IsObstacle(cell) ? 1 : 0) + (map.IsExplored(cell) ? 2 : 0) + (is_here ? 4 : 0) +
           (map.IsTrack(cell) ? 8 : 0);
  };
  for (int y = 0; y < kExplorationSide; ++y) {
    for (int x = 0; x < kExplorationSide; ++x) {
      int expected = 0;
      for (int i = 0; i < 16; ++i) {
        expected |= what({4 * x + i % 4, 4 * y + i / 4}) << 4;
        if (i < 4) {
          expected |= what({here.x - kExplorationSide + 2 * x + i % 2,
                            here.y - kExplorationSide + 2 * y + i / 2});
        }
      }
      ASSERT_EQ(view[static_cast<std::size_t>(y * kExplorationSide + x)], expected)
          << x << " " << y;
    }
  }
}

TEST(ExplorationView, HeadingsFallIntoBinsOfFiveDegrees) {
  EXPECT_EQ(HeadingBin(0.01), kHeadings / 2);
  EXPECT_EQ(HeadingBin(sim::DegToRad(-179.0)), 0);
  EXPECT_EQ(HeadingBin(sim::DegToRad(179.0)), kHeadings - 1);
  EXPECT_EQ(HeadingBin(sim::DegToRad(-87.0)), HeadingBin(sim::DegToRad(273.0)));
}

TEST(ExplorationView, GoalsLieInTheWindowAroundTheBody) {
  const sim::PlanarPose pose{1.3, -0.7, 0.4};
  const MetricMap map = SomeMap(pose);
  const Point middle = GoalAt(map, pose, SharesOf({0, 0}));
  EXPECT_NEAR(middle.x, pose.x, 0.06);
  EXPECT_NEAR(middle.y, pose.y, 0.06);
  const Point corner = GoalAt(map, pose, SharesOf({kMostGoalSteps, -kMostGoalSteps}));
  EXPECT_NEAR(corner.x, pose.x + 6.0, 0.1);
  EXPECT_NEAR(corner.y, pose.y - 6.0, 0.1);
}

TEST(ExplorationView, OtherMapsAreRefused) {
  MapSpec small;
  small.size = 13.0;
  EXPECT_THROW(RequireExplorationMap(small), sim::Error);
  EXPECT_NO_THROW(RequireExplorationMap({}));
}

TEST(Goals, AtRandomFillTheWindowEvenly) {
  sim::Rng rng(1, "goals");
  double sum = 0.0;
  double square = 0.0;
  constexpr int kDraws = 4000;
  for (int i = 0; i < kDraws; ++i) {
    const double share = SharesOf(DrawAnyGoal(&rng))[0];
    sum += share / kDraws;
    square += (share - 0.5) * (share - 0.5) / kDraws;
  }
  EXPECT_NEAR(sum, 0.5, 0.02);
  EXPECT_NEAR(square, 1.0 / 12.0, 0.005);
}

std::shared_ptr<ExplorationNet> DecidedNet() {
  auto net = std::make_shared<ExplorationNet>(
      ExplorationConfig{.features = 32, .heading_size = 4, .precision = Precision::kFloat32}, 4);
  const torch::NoGradGuard no_grad;
  net->named_parameters()["mean.weight"].mul_(100.0);
  net->named_parameters()["log_deviation"].fill_(-0.5);
  net->eval();
  return net;
}

/// Blobs, as maps have them.
std::vector<std::uint8_t> SomeView(std::uint64_t seed) {
  sim::Rng rng(seed, "blobs");
  std::vector<std::uint8_t> view(kExplorationBytes);
  for (int i = 0; i < 40; ++i) {
    const int x = rng.Below(100), y = rng.Below(100), size = 4 + rng.Below(16);
    const int bits = rng.Below(256);
    for (int k = 0; k < size * size; ++k) {
      std::uint8_t& pixel =
          view[static_cast<std::size_t>((y + k / size) * kExplorationSide + x + k % size)];
      pixel = static_cast<std::uint8_t>(pixel | bits);
    }
  }
  return view;
}

QuantisedNet QuantisedOf(ExplorationNet* net) {
  torch::Tensor views =
      torch::empty({12, static_cast<std::int64_t>(kExplorationBytes)}, torch::kUInt8);
  for (std::int64_t i = 0; i < 12; ++i) {
    const std::vector<std::uint8_t> view = SomeView(static_cast<std::uint64_t>(i));
    std::copy(view.begin(), view.end(), views[i].data_ptr<std::uint8_t>());
  }
  return Quantise(net, views);
}

constexpr std::array kLogDeviations = {-0.5f, -0.5f};

TEST(IntegerExploration, SaysWhatTheTrainedOneSays) {
  const std::shared_ptr<ExplorationNet> net = DecidedNet();
  IntegerExploration integers(net->config(), QuantisedOf(net.get()), kLogDeviations);
  LearnedExploration floats(net);
  double apart = 0.0;
  double spread = 0.0;
  double first = 0.0;
  for (int i = 0; i < 6; ++i) {
    const std::vector<std::uint8_t> view = SomeView(100 + static_cast<std::uint64_t>(i));
    const GoalDistribution exact = floats.Ask(view, 11 * i);
    const GoalDistribution close = integers.Ask(view, 11 * i);
    if (i == 0) first = exact.mean[0];
    for (std::size_t k = 0; k < 2; ++k) {
      apart = std::max(apart, std::fabs(exact.mean[k] - close.mean[k]));
      EXPECT_NEAR(close.deviation[k], exact.deviation[k], 1e-6);
    }
    spread = std::max(spread, std::fabs(exact.mean[0] - first));
  }
  EXPECT_GT(spread, 0.3);  // or there was nothing to say
  EXPECT_LT(apart, 0.1 * spread);
}

TEST(IntegerExploration, HasTheSameBitsWithAllKernels) {
  const std::shared_ptr<ExplorationNet> net = DecidedNet();
  const QuantisedNet quantised = QuantisedOf(net.get());
  const std::vector<std::uint8_t> view = SomeView(100);
  IntegerExploration fastest(net->config(), quantised, kLogDeviations);
  const std::array<double, 2> expected = fastest.Ask(view, 30).mean;
  for (const IntegerKernels* kernels : SupportedIntegerKernels()) {
    IntegerExploration policy(net->config(), quantised, kLogDeviations);
    policy.Use(*kernels);
    EXPECT_EQ(policy.Ask(view, 30).mean, expected) << kernels->name;
  }
}

TEST(IntegerExploration, FilesAreLoadedByTheirKindAndBadOnesRefused) {
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "policy.safetensors";
  const std::shared_ptr<ExplorationNet> net = DecidedNet();
  SaveExploration(*net, {}, StoredType::kFloat32, file);
  const std::vector<std::uint8_t> view = SomeView(100);
  const auto ask = [&] {
    const auto model = LoadModel(file, {});
    return dynamic_cast<ExplorationPolicy&>(*model).Ask(view, 30).mean;
  };
  EXPECT_EQ(ask(), LearnedExploration(net).Ask(view, 30).mean);
  const QuantisedNet quantised = QuantisedOf(net.get());
  AddQuantised(quantised, file, file);
  EXPECT_EQ(ask(), IntegerExploration(net->config(), quantised, kLogDeviations).Ask(view, 30).mean);
  // Of another shape than it says.
  TensorFile content = ReadTensorFile(file);
  std::string& config = content.metadata["exploration"];
  config.replace(config.find("32"), 2, "48");
  WriteTensorFile(file, content);
  try {
    LoadModel(file, {});
    FAIL();
  } catch (const sim::FileError& e) {
    EXPECT_THAT(e.what(), HasSubstr("does not fit the policy's configuration"));
  }
}

}  // namespace
}  // namespace bulletnav::agent
