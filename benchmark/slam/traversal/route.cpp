// SPDX-License-Identifier: MIT
#include "benchmark/slam/traversal/route.h"

#include <algorithm>
#include <cmath>

namespace bulletnav::bench {
namespace {

constexpr int kDrawn = 200;
constexpr double kApart = 2.5;  // metres on foot between any two places, about one a room

/// Of places drawn at random, those that are far from all before them and can be walked to.
std::vector<Eigen::Vector3f> SpreadPlaces(const sim::NavmeshQuery& query,
                                          const Eigen::Vector3f& start, sim::Rng* rng) {
  std::vector<Eigen::Vector3f> places;
  places.reserve(kDrawn);
  for (int i = 0; i < kDrawn; ++i) {
    const Eigen::Vector3f place = query.RandomPoint(rng, 0);
    const auto is_far = [&](const Eigen::Vector3f& other) {
      return query.GeodesicDistance(place, other) >= kApart;
    };
    const bool is_reached = std::isfinite(query.GeodesicDistance(start, place));
    if (is_reached && std::all_of(places.begin(), places.end(), is_far)) places.push_back(place);
  }
  return places;
}

}  // namespace

Route::Route(const sim::NavmeshQuery& query, const Eigen::Vector3f& start, const sim::Rng& rng)
    : query_(query), rng_(rng.Fork("route")), places_(SpreadPlaces(query, start, &rng_)) {
  Eigen::Vector3f here = start;
  for (auto from = places_.begin(); from != places_.end(); ++from) {
    const auto nearest = std::min_element(from, places_.end(), [&](const auto& a, const auto& b) {
      return query_.GeodesicDistance(here, a) < query_.GeodesicDistance(here, b);
    });
    std::iter_swap(from, nearest);
    here = *from;
  }
}

Eigen::Vector3f Route::Next() {
  const std::size_t at = next_++;
  if (at < places_.size()) return places_[at];
  if (at < 2 * places_.size()) return places_[2 * places_.size() - 1 - at];
  return query_.RandomPoint(&rng_, 0);
}

}  // namespace bulletnav::bench
