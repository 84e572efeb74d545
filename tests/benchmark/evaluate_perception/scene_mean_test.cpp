// SPDX-License-Identifier: MIT
#include "benchmark/evaluate_perception/scene_mean.h"

#include <cmath>

#include <gtest/gtest.h>

namespace bulletnav::bench {
namespace {

TEST(SceneMean, IsTheMeanOfAllCases) {
  SceneMean mean;
  mean.NextScene();
  mean.Add(1.0);
  mean.Add(2.0);
  mean.NextScene();
  mean.Add(6.0);
  const MeanFigure figure = mean.Figure(1);
  EXPECT_EQ(figure.count, 3);
  EXPECT_DOUBLE_EQ(figure.value, 3.0);
  EXPECT_DOUBLE_EQ(figure.interval.low, 1.5);  // the first scene twice
  EXPECT_DOUBLE_EQ(figure.interval.high, 6.0);
}

TEST(SceneMean, IsAsSureAsScenesAgree) {
  SceneMean alike;
  SceneMean different;
  for (int scene = 0; scene < 10; ++scene) {
    alike.NextScene();
    different.NextScene();
    for (int i = 0; i < 100; ++i) {
      alike.Add(i % 2);
      different.Add(scene % 2);
    }
  }
  EXPECT_DOUBLE_EQ(alike.Figure(1).interval.low, alike.Figure(1).interval.high);
  EXPECT_LT(different.Figure(1).interval.low, 0.3);
  EXPECT_GT(different.Figure(1).interval.high, 0.7);
}

TEST(SceneMean, SaysNothingOfOneSceneOrOfNoCases) {
  SceneMean mean;
  mean.NextScene();
  EXPECT_TRUE(std::isnan(mean.Figure(1).value));
  mean.Add(0.5);
  EXPECT_DOUBLE_EQ(mean.Figure(1).value, 0.5);
  EXPECT_TRUE(std::isinf(mean.Figure(1).interval.high));
}

}  // namespace
}  // namespace bulletnav::bench
