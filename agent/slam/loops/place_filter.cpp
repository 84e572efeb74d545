// SPDX-License-Identifier: MIT
#include "agent/slam/loops/place_filter.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

struct Spread {
  double mean = 0.0;
  double deviation = 0.0;
};

Spread SpreadOf(std::span<const double> likeness) {
  Spread spread;
  if (likeness.empty()) return spread;
  const auto count = static_cast<double>(likeness.size());
  spread.mean = std::accumulate(likeness.begin(), likeness.end(), 0.0) / count;
  for (const double value : likeness) {
    spread.deviation += (value - spread.mean) * (value - spread.mean);
  }
  spread.deviation = std::sqrt(spread.deviation / count);
  return spread;
}

}  // namespace

void PlaceFilterSpec::Validate() const {
  const auto is_share = [](double value) {
    return value > 0.0 && value < 1.0;
  };
  if (!is_share(new_after_new) || !is_share(new_after_old)) {
    throw sim::Error("new_after_new and new_after_old must lie between 0 and 1");
  }
  if (moves.empty() || !(moves.front() > 0.0) ||
      std::any_of(moves.begin(), moves.end(), [](double value) {
        return !(value >= 0.0);
      })) {
    throw sim::Error("expected moves that are not negative, the first above 0");
  }
}

PlaceFilter::PlaceFilter(const PlaceFilterSpec& spec) : spec_(spec) {
  spec_.Validate();
}

void PlaceFilter::Predict(std::size_t places) {
  const std::size_t known = places_.size();
  const double old_mass = std::accumulate(places_.begin(), places_.end(), 0.0);
  std::vector<double> moved(places, 0.0);
  for (std::size_t from = 0; from < known; ++from) {
    if (places_[from] == 0.0) continue;
    const std::size_t low = from + 1 - std::min(from + 1, spec_.moves.size());
    const std::size_t high = std::min(places, from + spec_.moves.size());
    double reachable = 0.0;
    for (std::size_t to = low; to < high; ++to) {
      reachable += spec_.moves[to > from ? to - from : from - to];
    }
    const double share = places_[from] * (1.0 - spec_.new_after_old) / reachable;
    for (std::size_t to = low; to < high; ++to) {
      moved[to] += share * spec_.moves[to > from ? to - from : from - to];
    }
  }
  if (places > 0) {
    const double any = new_place_ * (1.0 - spec_.new_after_new) / static_cast<double>(places);
    for (double& place : moved) place += any;
    new_place_ = new_place_ * spec_.new_after_new + old_mass * spec_.new_after_old;
  }
  places_ = std::move(moved);
}

void PlaceFilter::Update(std::span<const double> likeness) {
  BULLETNAV_CHECK(likeness.size() >= places_.size());
  Predict(likeness.size());
  const Spread spread = SpreadOf(likeness);
  // Only what stands out counts: a deviation above the mean. The less there is of that, the surer
  // the place is new.
  if (spread.deviation > 0.0) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (likeness[i] < spread.mean + spread.deviation) continue;
      places_[i] *= (likeness[i] - spread.deviation) / spread.mean;
    }
    new_place_ *= spread.mean / spread.deviation + 1.0;
  }
  const double sum = std::accumulate(places_.begin(), places_.end(), new_place_);
  for (double& place : places_) place /= sum;
  new_place_ /= sum;
}

}  // namespace bulletnav::agent
