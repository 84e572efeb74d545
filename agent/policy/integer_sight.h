// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "agent/integer/integer_encoder.h"
#include "agent/integer/quantised_layer.h"

namespace bulletnav::agent {

/// What a policy sees with an encoder in integers that is not trained on: a semantic model's. The
/// same on every processor. For any number of threads.
class IntegerSight {
 public:
  /// `net`: a semantic model's, or its encoder alone. Throws Error if layers are missing or do not
  /// fit pictures of so many rows.
  IntegerSight(const QuantisedNet& net, int rows);
  ~IntegerSight();
  IntegerSight(const IntegerSight&) = delete;
  IntegerSight& operator=(const IntegerSight&) = delete;
  IntegerSight(IntegerSight&&) = delete;
  IntegerSight& operator=(IntegerSight&&) = delete;

  int code_size() const { return code_size_; }  // of a picture
  double code_step() const { return step_; }    // real value of a step of codes
  /// Bytes of PolicyPictures, one or several, to codes [pictures, code_size].
  IntegerEncoder::Codes Codes(std::span<const std::uint8_t> pictures);

  /// The encoder alone.
  const QuantisedNet& net() const { return net_; }

 private:
  std::unique_ptr<IntegerEncoder> Take();

  QuantisedNet net_;
  int rows_;
  int code_size_;
  double step_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<IntegerEncoder>> idle_;
};

}  // namespace bulletnav::agent
