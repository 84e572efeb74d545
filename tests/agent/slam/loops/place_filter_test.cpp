// SPDX-License-Identifier: MIT
#include "agent/slam/loops/place_filter.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {
namespace {

double Sum(const PlaceFilter& filter) {
  const auto places = filter.places();
  return std::accumulate(places.begin(), places.end(), filter.new_place());
}

TEST(PlaceFilter, ProbabilitiesSumToOne) {
  PlaceFilter filter({});
  sim::Rng rng(1, "likeness");
  for (std::size_t places = 0; places < 60; ++places) {
    std::vector<double> likeness(places);
    for (double& value : likeness) value = rng.Chance(0.3) ? rng.Uniform() : 0.0;
    filter.Update(likeness);
    EXPECT_NEAR(Sum(filter), 1.0, 1e-12);
  }
}

/// Two steps by hand: three places, of which nothing is known, then one that stands out.
TEST(PlaceFilter, FollowsTheFormula) {
  PlaceFilter filter({.new_after_new = 0.9, .new_after_old = 0.1, .moves = {0.6, 0.2}});
  filter.Update(std::vector<double>(3, 0.0));
  EXPECT_NEAR(filter.new_place(), 0.9, 1e-12);
  EXPECT_NEAR(filter.places()[1], 0.1 / 3.0, 1e-12);
  // Predicted: at the ends 0.9 of 1/30 goes 3 : 1, in the middle 1 : 3 : 1; 0.09 / 3 from new.
  const double end = 0.9 / 30.0 * (0.75 + 0.2) + 0.03;
  const double middle = 0.9 / 30.0 * (0.25 + 0.6 + 0.25) + 0.03;
  const double fresh = 0.9 * 0.9 + 0.1 * 0.1;
  const std::vector<double> likeness = {1.0, 1.0, 6.0};
  const double mean = 8.0 / 3.0;
  const double deviation = std::sqrt((2 * 25.0 / 9.0 + 100.0 / 9.0) / 3.0);
  const double last = end * (6.0 - deviation) / mean;
  const double at_new = fresh * (mean / deviation + 1.0);
  const double sum = end + middle + last + at_new;
  filter.Update(likeness);
  EXPECT_NEAR(filter.places()[0], end / sum, 1e-12);
  EXPECT_NEAR(filter.places()[1], middle / sum, 1e-12);
  EXPECT_NEAR(filter.places()[2], last / sum, 1e-12);
  EXPECT_NEAR(filter.new_place(), at_new / sum, 1e-12);
}

/// Places that follow on each other, seen again one by one, are believed; one look is not enough.
TEST(PlaceFilter, BelievesWhatKeepsStandingOut) {
  PlaceFilter filter({});
  std::vector<double> likeness(100, 0.1);
  for (int i = 0; i < 20; ++i) filter.Update(likeness);
  EXPECT_GT(filter.new_place(), 0.4);
  for (std::size_t place = 30; place < 40; ++place) {
    std::vector<double> seen = likeness;
    seen[place] = 5.0;
    filter.Update(seen);
  }
  const auto places = filter.places();
  const auto best = std::max_element(places.begin(), places.end()) - places.begin();
  EXPECT_EQ(best, 39);
  EXPECT_GT(places[39], 0.3);
  EXPECT_LT(filter.new_place(), 0.3);
}

TEST(PlaceFilter, BadSpecsAreRefused) {
  EXPECT_THROW(PlaceFilter({.new_after_new = 1.0}), sim::Error);
  EXPECT_THROW(PlaceFilter({.moves = {}}), sim::Error);
  EXPECT_THROW(PlaceFilter({.moves = {1.0, -0.1}}), sim::Error);
}

}  // namespace
}  // namespace bulletnav::agent
