// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "agent/integer/integer_encoder.h"
#include "agent/integer/integer_heads.h"
#include "agent/models/encodes_together.h"

namespace bulletnav::agent {

/// A SemanticModel in integers: the same bits on every processor, whatever else is asked. One per
/// thread; all work is done in the calling thread.
class IntegerModel : public SemanticModel, public EncodesTogether {
 public:
  /// Of panoramas averaged down to `rows`. Throws Error if layers are missing or do not fit.
  IntegerModel(const QuantisedNet& net, int rows, bool uses_depth);

  std::vector<PanoramaCode> Encode(std::span<const Panorama> panoramas) override;
  void Expect(std::span<const Panorama> panoramas) override;
  std::array<float, kDirections> Explorable(const PanoramaCode& source) override;
  std::vector<PairPrediction> Compare(std::span<const PanoramaCode* const> sources,
                                      const PanoramaCode& goal) override;

  void Use(const IntegerKernels& kernels);

 private:
  std::size_t size_of_code() const;
  std::vector<PanoramaCode> EncodeAll(std::span<const Panorama> panoramas);
  /// What is needed of a source, or of a goal.
  void GetParts(const PanoramaCode& code, bool of_goal, IntegerParts* parts) const;

  IntegerEncoder encoder_;
  IntegerHeads heads_;
  std::vector<Panorama> expected_;
  std::vector<PanoramaCode> expected_codes_;  // empty until one of them is asked for
};

}  // namespace bulletnav::agent
