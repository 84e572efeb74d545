// SPDX-License-Identifier: MIT
#include "benchmark/privileged/way_out.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <set>
#include <tuple>

#include "sim/base/error.h"
#include "sim/noise/noise_model.h"
#include "sim/physics/capsule_body.h"

namespace bulletnav::bench {
namespace {

constexpr int kHeadings = 18;
constexpr int kMostExpansions = 600;
constexpr double kSamePlace = 0.1;   // metres
constexpr double kLeastMove = 0.12;  // metres; less is a wall
constexpr double kGain = 0.5;        // metres

class Search {
 public:
  Search(const GroundTruth& truth, const sim::NavmeshQuery& query)
      : truth_(truth), query_(query), body_(truth.world->physics(), truth.body) {}

  std::vector<Eigen::Vector3d> Run() {
    const double enough = Left(truth_.pose.position) - kGain;
    Add(truth_.pose.position, -1, 0.0);
    for (int i = 0; i < kMostExpansions && !queue_.empty(); ++i) {
      const int best = std::get<1>(queue_.top());
      queue_.pop();
      if (Left(places_[static_cast<std::size_t>(best)].position) <= enough) return WayTo(best);
      Expand(best);
    }
    return {};
  }

 private:
  struct Place {
    Eigen::Vector3d position;
    int parent;
    double walked;
  };

  double Left(const Eigen::Vector3d& p) const {
    return query_.GeodesicDistance(p.cast<float>(), truth_.goal.position.cast<float>());
  }

  void Add(const Eigen::Vector3d& position, int parent, double walked) {
    const auto cell = [](double v) {
      return static_cast<int>(std::floor(v / kSamePlace));
    };
    if (!seen_.insert({cell(position.x()), cell(position.y()), cell(position.z())}).second) return;
    places_.push_back({position, parent, walked});
    queue_.push({walked + Left(position), static_cast<int>(places_.size()) - 1});
  }

  void Expand(int from) {
    const Place place = places_[static_cast<std::size_t>(from)];
    const double step = sim::NominalMotion(sim::Action::kMoveForward).x;
    for (int k = 0; k < kHeadings; ++k) {
      const double yaw = truth_.pose.yaw + 2.0 * sim::kPi * k / kHeadings;
      if (!body_.TryReset({place.position, yaw})) return;
      body_.Move({step, 0.0, 0.0});
      const double moved = (body_.pose().position - place.position).norm();
      if (moved >= kLeastMove) Add(body_.pose().position, from, place.walked + moved);
    }
  }

  std::vector<Eigen::Vector3d> WayTo(int place) const {
    std::vector<Eigen::Vector3d> way;
    for (int i = place; i > 0; i = places_[static_cast<std::size_t>(i)].parent) {
      way.push_back(places_[static_cast<std::size_t>(i)].position);
    }
    std::reverse(way.begin(), way.end());
    return way;
  }

  using Entry = std::tuple<double, int>;
  const GroundTruth& truth_;
  const sim::NavmeshQuery& query_;
  sim::CapsuleBody body_;
  std::vector<Place> places_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
  std::set<std::array<int, 3>> seen_;
};

}  // namespace

std::vector<Eigen::Vector3d> FindWayOut(const GroundTruth& truth, const sim::NavmeshQuery& query) {
  return Search(truth, query).Run();
}

}  // namespace bulletnav::bench
