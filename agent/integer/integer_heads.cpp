// SPDX-License-Identifier: MIT
#include "agent/integer/integer_heads.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "agent/integer/integer_encoder.h"
#include "agent/integer/integer_functions.h"
#include "agent/integer/pictures.h"
#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr int kTurns = kDirections;
constexpr int kPairs = kDirections * kTurns;
constexpr int kReach = 1;  // a patch is matched with so many neighbours to each side
constexpr int kWindow = 2 * kReach + 1;
constexpr int kTorusRows = 2 * kDirections - 1;
constexpr int kTorusCols = kDirections + 2 * kReach;
constexpr int kProductZero = 128;
constexpr int kProductBits = 40;
constexpr int kAnswerBits = 32;
constexpr double kLargestFactor = 1u << 31;
constexpr std::int64_t kLargestLogit = std::int64_t{1} << 30;
constexpr int kMatchWords = IntegerHeads::kMatchSize / 2;
constexpr double kFineSteps = 1 << kFineBits;
constexpr int kLargestMean = 144 * 255 / 4;  // of sums of all turns and directions, over 4

/// `count` offsets, `apart` from each other.
std::vector<std::int32_t> Regular(int count, int apart, int first = 0) {
  std::vector<std::int32_t> offsets;
  offsets.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) offsets.push_back(first + i * apart);
  return offsets;
}

/// [i, r] offsets of what f says.
template <class F>
std::vector<std::int32_t> PairOffsets(const F& f) {
  std::vector<std::int32_t> offsets;
  offsets.reserve(kPairs);
  for (int i = 0; i < kDirections; ++i) {
    for (int r = 0; r < kTurns; ++r) offsets.push_back(f(i, r));
  }
  return offsets;
}

LayerOutput SignedOutput(std::vector<std::int16_t>* values, const std::int32_t* offsets,
                         int largest) {
  LayerOutput output;
  output.fine = values->data();
  output.fine_offsets = offsets;
  output.low = -largest;
  output.high = largest;
  return output;
}

const QuantisedLayer& LayerOf(const QuantisedNet& net, const std::string& name, int segments,
                              int inputs) {
  const QuantisedLayer& layer = net.Layer(name);
  if (layer.segments != segments || layer.inputs != inputs) {
    throw sim::Error("layer " + name + " is of another size");
  }
  return layer;
}

/// Steps of products for one of sums, in units of 2^-kProductBits.
std::int64_t ProductFactor(const QuantisedNet& net) {
  const double step = double{net.Scale("heads.source_match")} * net.Scale("heads.goal_match") /
                      std::sqrt(double{IntegerHeads::kMatchSize});
  const double factor = std::ldexp(step / net.Scale("heads.product"), kProductBits);
  if (!(factor < kLargestFactor)) throw sim::Error("scale heads.product is too small");
  return std::llrint(factor);
}

}  // namespace

IntegerAnswer::IntegerAnswer(const QuantisedNet& net, const std::string& name,
                             const LayerScales& in)
    : hidden_(net.Layer(name + "_hidden"), LayerWidth::k16,
              {in.in, in.zero, in.largest, net.Scale(name + "_hidden")}),
      bias_(0),
      factor_(0) {
  const QuantisedLayer& out = LayerOf(net, name + "_out", 1, hidden_.padded_outputs());
  const LayerScales scales = {net.Scale(name + "_hidden"), 0, kLargest16, kLogitStep};
  [[maybe_unused]] const DotLayer checked(out, LayerWidth::k16, scales);  // that sums fit
  if (out.outputs != 1) throw sim::Error("layer " + name + "_out is of another size");
  weights_ = out.weights;
  const double step = scales.in * out.scale.front();
  bias_ = std::llrint(out.bias.front() / step);
  const double factor = std::ldexp(step / kLogitStep, kAnswerBits);
  if (!(factor < kLargestFactor)) throw sim::Error("layer " + name + "_out's scale is too large");
  factor_ = std::llrint(factor);
}

void IntegerAnswer::Run(const std::int16_t* in, std::span<const std::int32_t> in_offsets,
                        std::span<std::int32_t> logits) {
  const int pixels = static_cast<int>(in_offsets.size());
  const auto size = static_cast<std::size_t>(hidden_.padded_outputs());
  values_.resize(in_offsets.size() * size);
  LayerOutput hidden;
  hidden.fine = values_.data();
  hidden.high = kLargest16;
  const std::vector<std::int32_t> at = Regular(pixels, hidden_.padded_outputs());
  hidden.fine_offsets = at.data();
  hidden_.Run({in, in_offsets, 0}, {}, hidden);
  for (std::size_t pixel = 0; pixel < logits.size(); ++pixel) {
    const std::int16_t* values = values_.data() + pixel * size;
    std::int32_t sum = 0;
    for (std::size_t i = 0; i < size; ++i) sum += values[i] * weights_[i];
    constexpr std::int64_t kHalf = std::int64_t{1} << (kAnswerBits - 1);
    const std::int64_t logit = ((sum + bias_) * factor_ + kHalf) >> kAnswerBits;
    logits[pixel] =
        static_cast<std::int32_t>(std::clamp<std::int64_t>(logit, -kLargestLogit, kLargestLogit));
  }
}

void IntegerAnswer::Use(const IntegerKernels& kernels) {
  hidden_.Use(kernels);
}

IntegerHeads::IntegerHeads(const QuantisedNet& net, int code_size, double code_scale)
    : code_size_(code_size),
      explorable_(net, "heads.explorable", {code_scale, 0, kLargest16}),
      source_sum_(LayerOf(net, "heads.source_sum", 1, kDirections * code_size), LayerWidth::k16,
                  {code_scale, 0, kLargest16, net.Scale("heads.sum")}),
      goal_sum_(LayerOf(net, "heads.goal_sum", 1, kDirections * code_size), LayerWidth::k16,
                {code_scale, 0, kLargest16, net.Scale("heads.sum")}),
      source_match_(LayerOf(net, "heads.source_match", 1, code_size), LayerWidth::k16,
                    {code_scale, 0, kLargest16, net.Scale("heads.source_match")}),
      goal_match_(LayerOf(net, "heads.goal_match", 1, code_size), LayerWidth::k16,
                  {code_scale, 0, kLargest16, net.Scale("heads.goal_match")}),
      product_factor_(ProductFactor(net)),
      matches_(LayerOf(net, "heads.matches", kDirections, kWindow * kMatches), LayerWidth::k8,
               {net.Scale("heads.product"), kProductZero, 255,
                net.Scale("heads.matches") / kFineSteps, net.Scale("heads.sum")}),
      second_(LayerOf(net, "heads.second", 1, matches_.padded_outputs()), LayerWidth::k8,
              {net.Scale("heads.matches"), 0, 255, net.Scale("heads.second") / kFineSteps}),
      direction_(net, "heads.direction", {net.Scale("heads.second") / kTurns, 0, kTurns * 255}),
      score_(net, "heads.score", {net.Scale("heads.second") / kTurns, 0, kTurns * 255}),
      connection_(net, "heads.connection", {net.Scale("heads.second") / kTurns, 0, kLargestMean}),
      distance_(net, "heads.distance", {net.Scale("heads.second") / kTurns, 0, kLargestMean}),
      kernels_(SupportedIntegerKernels().front()),
      goal_words_(std::size_t{kMatches} * kMatchWords * kOutputBlock),
      products_(std::size_t{kMatches} * kDirections * kOutputBlock),
      torus_(std::size_t{kTorusRows} * kTorusCols * kMatches) {
  const auto size = static_cast<std::size_t>(features());
  const auto is_wide = [&](const char* name, int inputs) {
    return net.Layer(name).inputs == inputs;
  };
  if (source_sum_.padded_outputs() != features() || goal_sum_.padded_outputs() != features() ||
      matches_.padded_outputs() != features() ||
      source_match_.padded_outputs() != kMatches * kMatchSize ||
      goal_match_.padded_outputs() != kMatches * kMatchSize ||
      !is_wide("heads.explorable_hidden", 3 * code_size) ||
      !is_wide("heads.direction_hidden", 2 * features()) ||
      !is_wide("heads.score_hidden", 2 * features()) ||
      !is_wide("heads.connection_hidden", 4 * features()) ||
      !is_wide("heads.distance_hidden", 4 * features())) {
    throw sim::Error("the heads' layers do not fit together");
  }
  sums_.resize(kPairs * size);
  both_.resize(kPairs * size);
  directions_.resize(2 * kDirections * size);
  whole_.resize(4 * size);
  const int row = features();
  torus_offsets_ = PairOffsets([](int i, int r) {
    return (i * kTorusCols + r) * kMatches;
  });
  source_offsets_ = PairOffsets([&](int i, int) {
    return i * row;
  });
  goal_offsets_ = PairOffsets([&](int i, int r) {
    return (i + r) % kDirections * row;
  });
  pair_offsets_ = Regular(kPairs, row);
  direction_offsets_ = Regular(kDirections, 4 * row);
}

IntegerParts IntegerHeads::Describe(std::span<const std::int16_t> codes) {
  BULLETNAV_CHECK_EQ(codes.size(), static_cast<std::size_t>(kDirections * code_size_));
  // Twice around, and one before: windows are stretches of memory.
  std::vector<std::int16_t> ring;
  ring.reserve(2 * codes.size() + static_cast<std::size_t>(code_size_));
  ring.insert(ring.end(), codes.end() - code_size_, codes.end());
  ring.insert(ring.end(), codes.begin(), codes.end());
  ring.insert(ring.end(), codes.begin(), codes.end());
  const int bytes = 2 * code_size_;
  const std::vector<std::int32_t> before = Regular(kDirections, bytes);
  const std::vector<std::int32_t> here = Regular(kDirections, bytes, bytes);
  IntegerParts parts;
  explorable_.Run(ring.data(), before, parts.explorable);
  const auto run = [&](DotLayer* layer, int largest, std::vector<std::int16_t>* out) {
    out->resize(static_cast<std::size_t>(kDirections * layer->padded_outputs()));
    const std::vector<std::int32_t> at = Regular(kDirections, layer->padded_outputs());
    layer->Run({ring.data(), here, 0}, {}, SignedOutput(out, at.data(), largest));
  };
  run(&source_sum_, 32767, &parts.source_sum);
  run(&goal_sum_, 32767, &parts.goal_sum);
  run(&source_match_, kLargest16, &parts.source_match);
  run(&goal_match_, kLargest16, &parts.goal_match);
  return parts;
}

void IntegerHeads::SetGoal(const IntegerParts& goal) {
  goal_sums_ = goal.goal_sum;
  std::fill(goal_words_.begin(), goal_words_.end(), 0);
  for (std::size_t patch = 0; patch < kDirections; ++patch) {
    for (std::size_t word = 0; word < std::size_t{kMatches} * kMatchWords; ++word) {
      std::memcpy(&goal_words_[word * kOutputBlock + patch],
                  &goal.goal_match[(patch * kMatches * kMatchWords + word) * 2],
                  sizeof(std::int32_t));
    }
  }
}

void IntegerHeads::MatchWithGoal(const IntegerParts& source) {
  static const std::vector<std::int32_t> offsets = Regular(kDirections, 2 * kMatches * kMatchSize);
  constexpr std::size_t kBlock = std::size_t{kDirections} * kOutputBlock;
  for (std::size_t match = 0; match < kMatches; ++match) {
    kernels_->dot16({.in = reinterpret_cast<const std::uint8_t*>(source.source_match.data()) +
                           2 * match * kMatchSize,
                     .offsets = offsets.data(),
                     .pixels = kDirections,
                     .segments = 1,
                     .segment_stride = 0,
                     .steps = kMatchWords,
                     .weights = goal_words_.data() + match * kMatchWords * kOutputBlock,
                     .blocks = 1,
                     .sums = products_.data() + match * kBlock});
  }
  std::array<std::array<std::array<std::uint8_t, kMatches>, kDirections>, kDirections> bytes{};
  constexpr std::int64_t kHalf = std::int64_t{1} << (kProductBits - 1);
  for (std::size_t match = 0; match < kMatches; ++match) {
    for (std::size_t a = 0; a < kDirections; ++a) {
      for (std::size_t b = 0; b < kDirections; ++b) {
        const std::int64_t sum = products_[match * kBlock + a * kOutputBlock + b];
        const std::int64_t steps = (sum * product_factor_ + kHalf) >> kProductBits;
        bytes[a][b][match] =
            static_cast<std::uint8_t>(std::clamp<std::int64_t>(steps + kProductZero, 0, 255));
      }
    }
  }
  std::uint8_t* out = torus_.data();
  for (int row = 0; row < kTorusRows; ++row) {
    const int a = row % kDirections;
    for (int col = 0; col < kTorusCols; ++col, out += kMatches) {
      const int b = (a + col - kReach + kDirections) % kDirections;
      std::memcpy(out, bytes[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)].data(),
                  kMatches);
    }
  }
}

void IntegerHeads::SumTurns(const IntegerParts& source) {
  KeptValues kept;
  kept.values = source.source_sum.data();
  kept.offsets = source_offsets_.data();
  kept.values2 = goal_sums_.data();
  kept.offsets2 = goal_offsets_.data();
  LayerOutput output;
  output.bytes = sums_.data();
  output.byte_offsets = pair_offsets_.data();
  matches_.Run({torus_.data(), torus_offsets_, kTorusCols * kMatches}, kept, output);
  output.bytes = both_.data();
  second_.Run({sums_.data(), pair_offsets_, 0}, {}, output);
}

void IntegerHeads::GatherTurns() {
  const auto size = static_cast<std::size_t>(features());
  std::fill(whole_.begin(), whole_.end(), std::int16_t{0});
  std::vector<std::int32_t> sums(2 * size, 0);
  for (std::size_t i = 0; i < kDirections; ++i) {
    std::int16_t* most = directions_.data() + 2 * i * size;
    std::int16_t* sum = most + size;
    std::fill_n(most, 2 * size, std::int16_t{0});
    for (std::size_t r = 0; r < kTurns; ++r) {
      const std::uint8_t* in = both_.data() + (i * kTurns + r) * size;
      for (std::size_t f = 0; f < size; ++f) {
        most[f] = std::max<std::int16_t>(most[f], in[f]);
        sum[f] = static_cast<std::int16_t>(sum[f] + in[f]);
      }
    }
    // In the units of sums: a sum is the mean of kTurns, so many times as large.
    for (std::size_t f = 0; f < size; ++f) most[f] = static_cast<std::int16_t>(most[f] * kTurns);
    for (std::size_t f = 0; f < 2 * size; ++f) {
      whole_[f] = std::max(whole_[f], most[f]);
      sums[f] += most[f];
    }
  }
  for (std::size_t f = 0; f < 2 * size; ++f) {
    whole_[2 * size + f] = static_cast<std::int16_t>((sums[f] + 2) / 4);
  }
}

PairPrediction IntegerHeads::Answer() {
  static constexpr std::array<std::int32_t, 1> kOne = {0};
  std::array<std::int32_t, 1> logit{};
  std::array<std::int32_t, kDirections> logits{};
  PairPrediction prediction;
  connection_.Run(whole_.data(), kOne, logit);
  prediction.same_node = ShareToFloat(SigmoidOf(logit[0]));
  distance_.Run(whole_.data(), kOne, logit);
  prediction.distance = static_cast<float>(kNodeRadius) * ShareToFloat(SigmoidOf(-logit[0]));
  direction_.Run(directions_.data(), direction_offsets_, logits);
  SoftmaxOf(logits, prediction.direction);
  score_.Run(directions_.data(), direction_offsets_, logits);
  for (std::size_t i = 0; i < kDirections; ++i) {
    prediction.score[i] = ShareToFloat(SigmoidOf(logits[i]));
  }
  return prediction;
}

PairPrediction IntegerHeads::Compare(const IntegerParts& source) {
  BULLETNAV_CHECK(!goal_sums_.empty());
  MatchWithGoal(source);
  SumTurns(source);
  GatherTurns();
  return Answer();
}

void IntegerHeads::Use(const IntegerKernels& kernels) {
  kernels_ = &kernels;
  for (DotLayer* layer :
       {&source_sum_, &goal_sum_, &source_match_, &goal_match_, &matches_, &second_}) {
    layer->Use(kernels);
  }
  for (IntegerAnswer* answer : {&explorable_, &direction_, &score_, &connection_, &distance_}) {
    answer->Use(kernels);
  }
}

}  // namespace bulletnav::agent
