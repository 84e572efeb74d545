// SPDX-License-Identifier: MIT
#include "agent/policy/integer_policy.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "agent/integer/integer_functions.h"
#include "agent/models/semantic_model.h"
#include "agent/policy/policy_map.h"
#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr int kCorrelationBits = 40;
constexpr int kMemoryBits = 20;
constexpr int kGateShift = 6;  // from steps of 2^-10 to those of logits
constexpr int kLargestFine = 32767;
constexpr int kTurns = kPolicyMatches * kDirections * kDirections;

/// x / 2^bits, rounded to the nearest, halves up.
std::int64_t Rounded(std::int64_t x, int bits) {
  return (x + (std::int64_t{1} << (bits - 1))) >> bits;
}

std::int16_t Cut(std::int64_t value) {
  return static_cast<std::int16_t>(
      std::clamp<std::int64_t>(value, -kPolicyLargest, kPolicyLargest));
}

DotLayer Layer(const QuantisedNet& net, const std::string& name, double in, double out) {
  return {net.Layer(name), LayerWidth::k16, {in, 0, kPolicyLargest, out}};
}

void RequireSize(const QuantisedNet& net, const std::string& name, int inputs, int outputs) {
  const QuantisedLayer& layer = net.Layer(name);
  if (layer.segments == 1 && layer.inputs == inputs && layer.outputs == outputs) return;
  throw sim::Error("layer " + name + " does not fit the policy's configuration");
}

void RequireSizes(const PolicyConfig& config, const QuantisedNet& net, int codes) {
  const bool correlates = config.fusion == Fusion::kCorrelation;
  const int features = config.features;
  RequireSize(net, "whole", codes, features);
  const int parts =
      (correlates ? 4 : 3) * features + kPolicyNumbers + (config.map ? kMapFeatures : 0);
  RequireSize(net, "joined", parts, features);
  RequireSize(net, "gru_in", features, 3 * config.memory);
  RequireSize(net, "gru_memory", config.memory, 3 * config.memory);
  RequireSize(net, "policy_head", config.memory, 4);
  if (config.map) RequireSize(net, "map.whole", net.Layer("map.whole").inputs, kMapFeatures);
  if (!correlates) return;
  constexpr int kMatchValues = kPolicyMatches * kPolicyMatchSize;
  RequireSize(net, "source_match", codes / kDirections, kMatchValues);
  RequireSize(net, "goal_match", codes / kDirections, kMatchValues);
  RequireSize(net, "matches", kTurns, features);
}

}  // namespace

IntegerPolicy::IntegerPolicy(const PolicyConfig& config, const QuantisedNet& net)
    : config_(config),
      sight_(net, config.rows),
      pictures_(config.rows),
      bytes_(pictures_.bytes()),
      whole_(Layer(net, "whole", sight_.code_step(), net.Scale("whole"))),
      joined_(Layer(net, "joined", net.Scale("whole"), net.Scale("joined"))),
      gru_in_(Layer(net, "gru_in", net.Scale("joined"), kPolicyLogitStep)),
      gru_memory_(Layer(net, "gru_memory", kPolicyMemoryStep, kPolicyLogitStep)),
      head_(Layer(net, "policy_head", kPolicyMemoryStep, kPolicyLogitStep)),
      parts_(static_cast<std::size_t>(net.Layer("joined").inputs)),
      state_(static_cast<std::size_t>(config.memory)) {
  RequireSizes(config, net, sight_.code_size());
  if (config.map) map_.emplace(net, kPolicyLargest);
  if (config.fusion != Fusion::kCorrelation) return;
  const double code = sight_.code_step();
  source_match_ = Layer(net, "source_match", code, net.Scale("source_match"));
  goal_match_ = Layer(net, "goal_match", code, net.Scale("goal_match"));
  matches_ = Layer(net, "matches", net.Scale("correlation"), net.Scale("whole"));
  const double product = double{net.Scale("source_match")} * double{net.Scale("goal_match")} /
                         std::sqrt(double{kPolicyMatchSize});
  const double factor = std::ldexp(product / net.Scale("correlation"), kCorrelationBits);
  if (!(factor >= 1.0 && factor < std::ldexp(1.0, 34))) {
    throw sim::Error("the scale 'correlation' is out of range");
  }
  correlation_factor_ = static_cast<std::int64_t>(std::nearbyint(factor));
}

void IntegerPolicy::Use(const IntegerKernels& kernels) {
  for (DotLayer* layer : {&whole_, &joined_, &gru_in_, &gru_memory_, &head_}) layer->Use(kernels);
  for (auto* layer : {&source_match_, &goal_match_, &matches_}) {
    if (*layer) (*layer)->Use(kernels);
  }
  if (map_) map_->Use(kernels);
}

std::vector<float> IntegerPolicy::NoMemory() const {
  return std::vector<float>(static_cast<std::size_t>(config_.memory));
}

IntegerEncoder::Codes IntegerPolicy::See(const Panorama& panorama) {
  pictures_.Write(panorama, bytes_);
  return sight_.Codes(bytes_);
}

/// [kDirections, kPolicyMatches * kPolicyMatchSize]
IntegerPolicy::Values IntegerPolicy::Matches(DotLayer* layer,
                                             const IntegerEncoder::Codes& codes) const {
  Values all;
  Values one;
  const std::size_t size = codes.size() / kDirections;
  for (std::size_t i = 0; i < kDirections; ++i) {
    layer->RunOne(codes.data() + i * size, -kPolicyLargest, kPolicyLargest, &one);
    all.insert(all.end(), one.begin(), one.end());
  }
  return all;
}

/// The features of the goal, then its matches.
std::vector<float> IntegerPolicy::CodeOf(const Panorama& goal) {
  const IntegerEncoder::Codes codes = See(goal);
  Values there;
  whole_.RunOne(codes.data(), 0, kPolicyLargest, &there);
  std::vector<float> code(there.begin(), there.end());
  if (!goal_match_) return code;
  const Values matches = Matches(&*goal_match_, codes);
  code.insert(code.end(), matches.begin(), matches.end());
  return code;
}

/// out[match, i, r] of the source's twelfth i with the goal's i + r.
void IntegerPolicy::Correlate(const Values& source, std::span<const float> goal,
                              std::int16_t* out) const {
  constexpr std::size_t kRow = std::size_t{kPolicyMatches} * kPolicyMatchSize;
  constexpr std::size_t kPairs = std::size_t{kDirections} * kDirections;
  const Values other(goal.begin(), goal.end());
  for (std::size_t number = 0; number < kPolicyMatches * kPairs; ++number) {
    const std::size_t match = number / kPairs * kPolicyMatchSize;
    const std::size_t i = number % kPairs / kDirections;
    const std::size_t turned = (i + number % kDirections) % kDirections;
    const std::int16_t* a = source.data() + i * kRow + match;
    const std::int64_t sum = std::inner_product(
        a, a + kPolicyMatchSize, other.data() + turned * kRow + match, std::int64_t{0});
    *out++ = Cut(Rounded(sum * correlation_factor_, kCorrelationBits));
  }
}

void IntegerPolicy::Join(const IntegerEncoder::Codes& codes, const PolicyQuestion& question) {
  const auto features = static_cast<std::size_t>(config_.features);
  Values part;
  whole_.RunOne(codes.data(), 0, kPolicyLargest, &part);
  const auto there = question.goal.first(features);
  auto out = std::copy(part.begin(), part.end(), parts_.begin());
  out = std::transform(there.begin(), there.end(), out, [](float value) {
    return static_cast<std::int16_t>(value);
  });
  out = std::transform(part.begin(), part.end(), there.begin(), out, [](std::int16_t a, float b) {
    return Cut(Rounded(std::int64_t{a} * static_cast<std::int64_t>(b), 12));
  });
  out = std::transform(question.numbers.begin(), question.numbers.end(), out, [](float number) {
    const double steps =
        std::clamp(double{number} / kPolicyNumberStep, -1.0 * kPolicyLargest, 1.0 * kPolicyLargest);
    return static_cast<std::int16_t>(std::nearbyint(steps));
  });
  if (matches_) {
    Values turns(kTurns);
    Correlate(Matches(&*source_match_, codes), question.goal.subspan(features), turns.data());
    matches_->RunOne(turns.data(), 0, kPolicyLargest, &part);
    out = std::copy(part.begin(), part.end(), out);
  }
  if (!map_) return;
  const std::span<const std::int16_t> mapped = map_->Run(question.map);
  std::copy(mapped.begin(), mapped.end(), out);
}

void IntegerPolicy::Remember(std::vector<float>* memory) {
  constexpr double kWhole = 1 << kMemoryBits;
  const auto size = static_cast<std::size_t>(config_.memory);
  const auto steps_of = [&](float value) {
    return static_cast<std::int64_t>(std::nearbyint(double{value} * kWhole));
  };
  const auto to_state = [](std::int64_t steps) {
    return Cut(Rounded(steps * kPolicyLargest, kMemoryBits));
  };
  for (std::size_t i = 0; i < size; ++i) state_[i] = to_state(steps_of((*memory)[i]));
  gru_in_.RunOne(inside_.data(), -kLargestFine, kLargestFine, &in_);
  gru_memory_.RunOne(state_.data(), -kLargestFine, kLargestFine, &kept_);
  const auto logit = [](std::int64_t steps) {
    return steps << kGateShift;
  };
  for (std::size_t i = 0; i < size; ++i) {
    const std::int64_t reset = SigmoidOf(logit(std::int64_t{in_[i]} + kept_[i]));
    const std::int64_t update = SigmoidOf(logit(std::int64_t{in_[size + i]} + kept_[size + i]));
    const std::int64_t remembered = Rounded(reset * logit(kept_[2 * size + i]), kShareBits);
    const std::int64_t sum = logit(in_[2 * size + i]) + remembered;
    // tanh(x) = 2 sigmoid(2 x) - 1
    const std::int64_t fresh =
        Rounded(2 * SigmoidOf(2 * sum) - (std::int64_t{1} << kShareBits), kShareBits - kMemoryBits);
    const std::int64_t before = steps_of((*memory)[i]);
    const std::int64_t after = fresh + Rounded(update * (before - fresh), kShareBits);
    (*memory)[i] = static_cast<float>(static_cast<double>(after) / kWhole);
    state_[i] = to_state(after);
  }
}

std::array<float, 4> IntegerPolicy::Act(const PolicyQuestion& question,
                                        std::vector<float>* memory) {
  BULLETNAV_CHECK_EQ(memory->size(), static_cast<std::size_t>(config_.memory));
  BULLETNAV_CHECK_EQ(question.numbers.size(), std::size_t{kPolicyNumbers});
  Join(See(question.panorama), question);
  joined_.RunOne(parts_.data(), 0, kPolicyLargest, &inside_);
  Remember(memory);
  Values answer;
  head_.RunOne(state_.data(), -kLargestFine, kLargestFine, &answer);
  std::array<std::int32_t, 4> logits{};
  for (std::size_t i = 0; i < logits.size(); ++i) logits[i] = answer[i] * (1 << kGateShift);
  std::array<float, 4> probabilities{};
  SoftmaxOf(logits, probabilities);
  return probabilities;
}

}  // namespace bulletnav::agent
