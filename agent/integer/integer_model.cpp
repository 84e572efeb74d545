// SPDX-License-Identifier: MIT
#include "agent/integer/integer_model.h"

#include <algorithm>
#include <iterator>

#include "agent/integer/integer_functions.h"
#include "sim/base/check.h"

namespace bulletnav::agent {
namespace {

constexpr int kMatchNumbers = IntegerHeads::kMatches * IntegerHeads::kMatchSize;

bool IsSameMemory(const Panorama& a, const Panorama& b) {
  return a.color.data() == b.color.data() && a.color.size() == b.color.size() &&
         a.depth.data() == b.depth.data() && a.depth.size() == b.depth.size();
}

}  // namespace

IntegerModel::IntegerModel(const QuantisedNet& net, int rows, bool uses_depth)
    : encoder_(net, rows, uses_depth),
      heads_(net, encoder_.code_size(), net.Scale("encoder.second")) {}

std::size_t IntegerModel::size_of_code() const {
  return static_cast<std::size_t>(kDirections * (1 + 2 * heads_.features() + 2 * kMatchNumbers));
}

void IntegerModel::Expect(std::span<const Panorama> panoramas) {
  expected_.assign(panoramas.begin(), panoramas.end());
  expected_codes_.clear();
}

std::vector<PanoramaCode> IntegerModel::Encode(std::span<const Panorama> panoramas) {
  if (panoramas.size() == 1) {
    const auto found = std::find_if(expected_.begin(), expected_.end(), [&](const Panorama& one) {
      return IsSameMemory(one, panoramas.front());
    });
    if (found != expected_.end()) {
      if (expected_codes_.empty()) expected_codes_ = EncodeAll(expected_);
      return {expected_codes_[static_cast<std::size_t>(found - expected_.begin())]};
    }
  }
  return EncodeAll(panoramas);
}

std::vector<PanoramaCode> IntegerModel::EncodeAll(std::span<const Panorama> panoramas) {
  const IntegerEncoder::Codes codes = encoder_.Encode(panoramas);
  std::vector<PanoramaCode> result;
  result.reserve(panoramas.size());
  const auto size = static_cast<std::size_t>(kDirections * encoder_.code_size());
  for (std::size_t i = 0; i < panoramas.size(); ++i) {
    const IntegerParts parts = heads_.Describe(std::span(codes).subspan(i * size, size));
    PanoramaCode code;
    code.reserve(size_of_code());
    for (const std::int32_t logit : parts.explorable) {
      code.push_back(ShareToFloat(SigmoidOf(logit)));
    }
    for (const auto* part :
         {&parts.source_sum, &parts.goal_sum, &parts.source_match, &parts.goal_match}) {
      std::copy(part->begin(), part->end(), std::back_inserter(code));
    }
    result.push_back(std::move(code));
  }
  return result;
}

std::array<float, kDirections> IntegerModel::Explorable(const PanoramaCode& source) {
  BULLETNAV_CHECK_EQ(source.size(), size_of_code());
  std::array<float, kDirections> probabilities{};
  std::copy_n(source.begin(), kDirections, probabilities.begin());
  return probabilities;
}

void IntegerModel::GetParts(const PanoramaCode& code, bool of_goal, IntegerParts* parts) const {
  BULLETNAV_CHECK_EQ(code.size(), size_of_code());
  const auto sums = static_cast<std::size_t>(kDirections * heads_.features());
  const auto matches = static_cast<std::size_t>(kDirections * kMatchNumbers);
  const auto get = [&](std::size_t first, std::size_t count, std::vector<std::int16_t>* out) {
    out->resize(count);
    const float* from = code.data() + kDirections + first;
    std::int16_t* to = out->data();
    for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<std::int16_t>(from[i]);
  };
  if (of_goal) {
    get(sums, sums, &parts->goal_sum);
    get(2 * sums + matches, matches, &parts->goal_match);
  } else {
    get(0, sums, &parts->source_sum);
    get(2 * sums, matches, &parts->source_match);
  }
}

std::vector<PairPrediction> IntegerModel::Compare(std::span<const PanoramaCode* const> sources,
                                                  const PanoramaCode& goal) {
  IntegerParts parts;
  GetParts(goal, true, &parts);
  heads_.SetGoal(parts);
  std::vector<PairPrediction> predictions;
  predictions.reserve(sources.size());
  for (const PanoramaCode* source : sources) {
    GetParts(*source, false, &parts);
    predictions.push_back(heads_.Compare(parts));
  }
  return predictions;
}

void IntegerModel::Use(const IntegerKernels& kernels) {
  encoder_.Use(kernels);
  heads_.Use(kernels);
}

}  // namespace bulletnav::agent
