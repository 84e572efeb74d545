// SPDX-License-Identifier: MIT
#include "agent/integer/integer_mapper.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "agent/integer/integer_encoder.h"
#include "agent/integer/integer_functions.h"
#include "sim/base/elementary.h"
#include "sim/base/error.h"
#include "sim/math/pose.h"

namespace bulletnav::agent {
namespace {

constexpr int kRanges = 64;     // along a ray, 5 cm each
constexpr int kBearings = 256;  // around the ring
constexpr int kStride = 4;      // pixels a column of stage one
constexpr int kWhole = 256;     // shares of a place
constexpr int kColumnBits = 3;  // of a column
constexpr int kShareOfColumn = 1 << kColumnBits;
constexpr int kLargestSum = 32767;
constexpr int kRayBits = 10;  // logits of rays count in units of 2^-10
constexpr double kRayStep = 1.0 / (1 << kRayBits);
constexpr int kLargestLogit = 16 << kRayBits;

int AsInt(std::size_t size) {
  return static_cast<int>(size);
}

/// Probabilities of logits from -kLargestLogit on.
const std::vector<float>& Sigmoids() {
  static const std::vector<float> table = [] {
    std::vector<float> values;
    values.reserve(2 * kLargestLogit + 1);
    for (int logit = -kLargestLogit; logit <= kLargestLogit; ++logit) {
      values.push_back(
          ShareToFloat(SigmoidOf(std::int64_t{logit} * (1 << (kLogitBits - kRayBits)))));
    }
    return values;
  }();
  return table;
}

float ProbabilityOf(int logit) {
  return Sigmoids()[static_cast<std::size_t>(std::clamp(logit, -kLargestLogit, kLargestLogit) +
                                             kLargestLogit)];
}

/// Bilinear, of one channel.
int Between(const std::int16_t* ring, const RingPlace& place, int channel) {
  const auto at = [&](int bearing, int range) {
    return int{ring[(bearing % kBearings * 2 + channel) * kRanges + range]};
  };
  const int farther = std::min(place.range + 1, kRanges - 1);
  const auto along = [&](int bearing) {
    return at(bearing, place.range) * (kWhole - place.range_share) +
           at(bearing, farther) * place.range_share;
  };
  const std::int64_t sum = std::int64_t{along(place.bearing)} * (kWhole - place.bearing_share) +
                           std::int64_t{along(place.bearing + 1)} * place.bearing_share;
  return static_cast<int>((sum + kWhole * kWhole / 2) >> 16);
}

LayerOutput FineOutput(std::vector<std::int16_t>* values, const std::vector<std::int32_t>& offsets,
                       int low, int high) {
  LayerOutput output;
  output.fine = values->data();
  output.fine_offsets = offsets.data();
  output.low = low;
  output.high = high;
  return output;
}

std::vector<std::int32_t> Rows(int count, int size) {
  return PixelOffsets({1, count, size, 0}, 1);
}

}  // namespace

std::vector<RingPlace> PlacesOnRing(int cols) {
  std::vector<RingPlace> places;
  constexpr int kSide = FreeSpace::kSide;
  places.reserve(std::size_t{kSide} * kSide);
  for (int row = 0; row < kSide; ++row) {
    for (int col = 0; col < kSide; ++col) {
      // In half cells, of which all middles are odd numbers away. No place is as near to a tie of
      // the roundings below as the last bits of atan2, in which processors may differ.
      const double x = 2 * col + 1 - kSide;
      const double y = 2 * row + 1 - kSide;
      const double range = std::clamp(0.5 * std::sqrt(x * x + y * y) - 0.5, 0.0, kRanges - 1.0);
      const double pixel = cols * (0.5 - sim::Atan2(y, x) / (2.0 * sim::kPi)) - 0.5;
      const double bearing = (pixel + 0.5 * kStride) * kBearings / cols - 0.5;
      const auto ranges = static_cast<int>(std::lround(range * kWhole));
      const auto bearings =
          static_cast<int>(std::lround((bearing + kBearings) * kWhole)) % (kBearings * kWhole);
      places.push_back({static_cast<std::int16_t>(bearings / kWhole),
                        static_cast<std::int16_t>(bearings % kWhole),
                        static_cast<std::int16_t>(ranges / kWhole),
                        static_cast<std::int16_t>(ranges % kWhole)});
    }
  }
  return places;
}

IntegerMapper::IntegerMapper(const QuantisedNet& net, int rows)
    : input_(rows, false),
      trunk_(TrunkOf(net, "trunk.", rows)),
      hidden_(net.Layer("hidden"), LayerWidth::k16,
              {net.Scale("levels"), 0, kLargestSum, net.Scale("hidden")}),
      rays_(net.Layer("rays"), LayerWidth::k16, {net.Scale("hidden"), 0, kLargest16, kRayStep}),
      columns_(4 * rows / kStride),
      places_(PlacesOnRing(4 * rows)) {
  levels_.reserve(kLevels);
  for (const int stage : {0, 1, 3}) AddLevel(net, stage);
  const int features = levels_[0].layer.padded_outputs();
  const bool is_whole = net.Layer("hidden").inputs == features &&
                        net.Layer("rays").inputs == hidden_.padded_outputs();
  if (!is_whole || columns_ * net.Layer("rays").outputs != 2 * kRanges * kBearings) {
    throw sim::Error("the mapper's layers do not fit together");
  }
  sums_.resize(levels_[0].values.size());
  values_.resize(static_cast<std::size_t>(columns_ * hidden_.padded_outputs()));
  ring_.resize(std::size_t{2} * kRanges * kBearings);
}

void IntegerMapper::AddLevel(const QuantisedNet& net, int stage) {
  const std::string name = "level" + std::to_string(stage + 1);
  const QuantisedLayer& layer = net.Layer(name);
  const PictureShape& shape = trunk_.bytes(stage).shape;
  if (layer.segments != shape.rows || layer.inputs != shape.channels ||
      layer.outputs % kOutputBlock != 0 || kShareOfColumn % (columns_ / shape.cols) != 0 ||
      (!levels_.empty() && layer.outputs != levels_[0].layer.padded_outputs())) {
    throw sim::Error("layer " + name + " is of another size");
  }
  PictureShape first_row = shape;
  first_row.rows = 1;
  Level level = {
      stage,
      DotLayer(layer, LayerWidth::k8, {trunk_.stage_scale(stage), 0, 255, net.Scale("levels")}),
      PixelOffsets(first_row, 1), shape.cols,
      std::vector<std::int16_t>(static_cast<std::size_t>(shape.cols * layer.outputs))};
  levels_.push_back(std::move(level));
}

void IntegerMapper::SumLevels() {
  const auto features = static_cast<std::size_t>(levels_[0].layer.padded_outputs());
  std::vector<std::int32_t> sum(features);
  for (int column = 0; column < columns_; ++column) {
    std::fill(sum.begin(), sum.end(), kShareOfColumn / 2);
    for (const Level& level : levels_) {
      const int times = columns_ / level.columns;
      const int next = column % times * (kShareOfColumn / times);
      const auto row = [&](int index) {
        return level.values.data() + static_cast<std::size_t>(index % level.columns) * features;
      };
      const std::int16_t* here = row(column / times);
      const std::int16_t* there = row(column / times + 1);
      for (std::size_t i = 0; i < features; ++i) {
        sum[i] += here[i] * (kShareOfColumn - next) + there[i] * next;
      }
    }
    std::int16_t* out = sums_.data() + static_cast<std::size_t>(column) * features;
    for (std::size_t i = 0; i < features; ++i) {
      const std::int32_t mean = sum[i] >> kColumnBits;
      out[i] = static_cast<std::int16_t>(std::clamp(mean, 0, kLargestSum));
    }
  }
}

FreeSpace IntegerMapper::Predict(const Panorama& panorama) {
  input_.Prepare(panorama, 0, trunk_.input());
  trunk_.Run(1);
  for (Level& level : levels_) {
    const Pictures& stage = trunk_.bytes(level.stage);
    level.layer.Run({stage.bytes.data(), level.in_offsets, stage.shape.row_stride()}, {},
                    FineOutput(&level.values, Rows(level.columns, level.layer.padded_outputs()),
                               -kLargestSum, kLargestSum));
  }
  SumLevels();
  const int features = levels_[0].layer.padded_outputs();
  const int hidden = hidden_.padded_outputs();
  hidden_.Run({sums_.data(), Rows(columns_, 2 * features), 0}, {},
              FineOutput(&values_, Rows(columns_, hidden), 0, kLargest16));
  const int answers = AsInt(ring_.size()) / columns_;
  rays_.Run({values_.data(), Rows(columns_, 2 * hidden), 0}, {},
            FineOutput(&ring_, Rows(columns_, answers), -kLargestSum, kLargestSum));
  FreeSpace space;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    space.explored[i] = ProbabilityOf(Between(ring_.data(), places_[i], 0));
    space.obstacle[i] = ProbabilityOf(Between(ring_.data(), places_[i], 1));
  }
  return space;
}

void IntegerMapper::Use(const IntegerKernels& kernels) {
  trunk_.Use(kernels);
  for (Level& level : levels_) level.layer.Use(kernels);
  hidden_.Use(kernels);
  rays_.Use(kernels);
}

}  // namespace bulletnav::agent
