// SPDX-License-Identifier: MIT
#include "sim/grid/fast_marching.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/base/check.h"

namespace bulletnav::sim {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr int kDisc = 5;            // cells around the start with exact distances
constexpr double kMostAhead = 7.0;  // cells; what the queue can hold

bool HasBlockedRim(const Grid<CellState>& map) {
  const int last = map.size() - 1;
  for (int i = 0; i <= last; ++i) {
    for (const Cell& c : {Cell{i, 0}, Cell{i, last}, Cell{0, i}, Cell{last, i}}) {
      if (map[c] != CellState::kBlocked) return false;
    }
  }
  return true;
}

}  // namespace

FastMarching::FastMarching(int size) : settled_(size, kInfinity), tentative_(size, kInfinity) {}

void FastMarching::Start(const Grid<CellState>& map, const Query& query) {
  BULLETNAV_CHECK_EQ(map.size(), settled_.size());
  BULLETNAV_CHECK(HasBlockedRim(map));
  BULLETNAV_CHECK(query.from.x > 0 && query.from.y > 0);
  BULLETNAV_CHECK(query.from.x < map.size() - 1 && query.from.y < map.size() - 1);
  for (const std::size_t i : touched_) settled_[i] = tentative_[i] = kInfinity;
  touched_.clear();
  for (auto& bucket : buckets_) bucket.clear();
  queued_ = 0;
  bucket_ = 0;
  map_ = &map;
  through_unknown_ = query.through_unknown;
  OfferDisc(query.from);
}

/// The method's error comes from the first few cells, where the front is far from flat; so those
/// that the start sees get their true distance.
void FastMarching::OfferDisc(const Cell& from) {
  Offer(map_->index(from), 0.0f);
  for (int dy = -kDisc; dy <= kDisc; ++dy) {
    for (int dx = -kDisc; dx <= kDisc; ++dx) {
      const Cell cell{from.x + dx, from.y + dy};
      if (dx * dx + dy * dy > kDisc * kDisc || !map_->Contains(cell)) continue;
      if (cell == from || !IsPassable(map_->index(cell))) continue;
      const auto cost = LineCost(*map_, from, cell);
      if (cost && *cost < kMostAhead) Offer(map_->index(cell), static_cast<float>(*cost));
    }
  }
}

void FastMarching::Offer(std::size_t i, float distance) {
  if (distance >= tentative_[i]) return;
  if (tentative_[i] == kInfinity) touched_.push_back(i);
  tentative_[i] = distance;
  const auto bucket = std::max(bucket_, static_cast<std::int64_t>(distance * kBucketsPerCell));
  buckets_[static_cast<std::size_t>(bucket % kBuckets)].push_back(i);
  ++queued_;
}

void FastMarching::Run(const Grid<CellState>& map, const Query& query) {
  Start(map, query);
  while (Next()) {
  }
}

std::optional<Cell> FastMarching::Next() {
  while (queued_ > 0) {
    auto& bucket = buckets_[static_cast<std::size_t>(bucket_ % kBuckets)];
    if (bucket.empty()) {
      ++bucket_;
      continue;
    }
    const std::size_t i = bucket.back();
    bucket.pop_back();
    --queued_;
    if (settled_[i] != kInfinity) continue;  // came in again on a shorter way
    Visit(i);
    return map_->cell(i);
  }
  return std::nullopt;
}

void FastMarching::Visit(std::size_t i) {
  settled_[i] = tentative_[i];
  const auto row = static_cast<std::size_t>(map_->size());
  for (const std::size_t n : {i - 1, i + 1, i - row, i + row}) {
    if (settled_[n] == kInfinity && IsPassable(n)) Offer(n, Solve(n));
  }
}

/// Upwind solution of |grad T| = cost from the settled neighbours.
float FastMarching::Solve(std::size_t i) const {
  const auto row = static_cast<std::size_t>(map_->size());
  const float a = std::min(settled_[i - 1], settled_[i + 1]);
  const float b = std::min(settled_[i - row], settled_[i + row]);
  const float gap = std::fabs(a - b);
  const float cost = (*map_)[i] == CellState::kTight ? kTightCost : 1.0f;
  if (!(gap < cost)) return std::min(a, b) + cost;
  return 0.5f * (a + b + std::sqrt(2.0f * cost * cost - gap * gap));
}

}  // namespace bulletnav::sim
