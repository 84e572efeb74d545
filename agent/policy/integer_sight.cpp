// SPDX-License-Identifier: MIT
#include "agent/policy/integer_sight.h"

#include <utility>

#include "agent/models/semantic_model.h"

namespace bulletnav::agent {
namespace {

constexpr const char* kEncoder = "encoder.";

QuantisedNet EncoderOf(const QuantisedNet& net) {
  QuantisedNet encoder;
  for (const auto& [name, layer] : net.layers) {
    if (name.starts_with(kEncoder)) encoder.layers[name] = layer;
  }
  for (const auto& [name, scale] : net.scales) {
    if (name.starts_with(kEncoder)) encoder.scales[name] = scale;
  }
  return encoder;
}

}  // namespace

IntegerSight::IntegerSight(const QuantisedNet& net, int rows)
    : net_(EncoderOf(net)), rows_(rows), step_(net_.Scale("encoder.second")) {
  std::unique_ptr<IntegerEncoder> first = Take();
  code_size_ = kDirections * first->code_size();
  idle_.push_back(std::move(first));
}

IntegerSight::~IntegerSight() = default;

std::unique_ptr<IntegerEncoder> IntegerSight::Take() {
  {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      std::unique_ptr<IntegerEncoder> encoder = std::move(idle_.back());
      idle_.pop_back();
      return encoder;
    }
  }
  return std::make_unique<IntegerEncoder>(net_, rows_, true);
}

IntegerEncoder::Codes IntegerSight::Codes(std::span<const std::uint8_t> pictures) {
  std::unique_ptr<IntegerEncoder> encoder = Take();
  IntegerEncoder::Codes codes = encoder->EncodePictures(pictures);
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(encoder));
  return codes;
}

}  // namespace bulletnav::agent
