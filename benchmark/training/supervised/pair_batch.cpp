// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/pair_batch.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "agent/models/semantic_model.h"
#include "agent/perception/model_config.h"
#include "sim/base/check.h"

namespace bulletnav::bench {
namespace {

using agent::kDirections;
using agent::kPanoramaCols;
using agent::kPanoramaRows;

/// What is `index` in the new frame was `index + twelfths` in the old one.
template <class T>
void TurnLabels(int twelfths, std::span<T> labels) {
  std::rotate(labels.begin(), labels.begin() + twelfths, labels.end());
}

/// Moves each row's pixels right by `columns`, around the end.
template <class T>
void RollRows(int columns, std::size_t channels, std::span<T> picture) {
  const std::size_t row = kPanoramaCols * channels;
  const auto keep =
      static_cast<std::ptrdiff_t>(static_cast<std::size_t>(kPanoramaCols - columns) * channels);
  for (std::size_t begin = 0; begin < picture.size(); begin += row) {
    const auto first = picture.begin() + static_cast<std::ptrdiff_t>(begin);
    std::rotate(first, first + keep, first + static_cast<std::ptrdiff_t>(row));
  }
}

template <class T>
std::span<T> Part(std::vector<T>* all, int index, std::size_t size) {
  return std::span<T>(*all).subspan(static_cast<std::size_t>(index) * size, size);
}

}  // namespace

void PairBatch::Check() const {
  const auto n = static_cast<std::size_t>(count);
  constexpr std::size_t kPixels = std::size_t{kPanoramaRows} * kPanoramaCols;
  BULLETNAV_CHECK_GT(count, 1);
  BULLETNAV_CHECK_EQ(color.size(), n * kPixels * 3);
  BULLETNAV_CHECK(depth.empty() || depth.size() == n * kPixels);
  BULLETNAV_CHECK_EQ(explorable.size(), n * kDirections);
  BULLETNAV_CHECK_EQ(same_node.size(), n * n);
  BULLETNAV_CHECK_EQ(direction.size(), n * n);
  BULLETNAV_CHECK_EQ(distance_score.size(), n * n);
  BULLETNAV_CHECK_EQ(scores.size(), n * n * kDirections);
}

void TurnPanorama(int index, int twelfths, PairBatch* batch) {
  BULLETNAV_CHECK(twelfths >= 0 && twelfths < kDirections);
  // The camera turns left, so that what it sees moves right.
  const int columns = static_cast<int>(std::lround(twelfths * double{kPanoramaCols} / kDirections));
  constexpr std::size_t kPixels = std::size_t{kPanoramaRows} * kPanoramaCols;
  RollRows(columns, 3, Part(&batch->color, index, 3 * kPixels));
  if (!batch->depth.empty()) RollRows(columns, 1, Part(&batch->depth, index, kPixels));
  TurnLabels(twelfths, Part(&batch->explorable, index, kDirections));
  for (int goal = 0; goal < batch->count; ++goal) {
    const int pair = index * batch->count + goal;
    std::int8_t& direction = batch->direction[static_cast<std::size_t>(pair)];
    if (direction >= 0) {
      direction = static_cast<std::int8_t>((direction + kDirections - twelfths) % kDirections);
    }
    TurnLabels(twelfths, Part(&batch->scores, pair, kDirections));
  }
}

}  // namespace bulletnav::bench
