// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>

#include "agent/models/free_space_model.h"

namespace bulletnav::agent {

/// A FreeSpaceModel with weights learned in the simulator, that sees colour alone. One per thread;
/// all work is done in the calling thread.
class LearnedMapper final : public FreeSpaceModel {
 public:
  /// Throws FileError if the weights cannot be used, Error if `rig` does not give what they take:
  /// 128 x 512 panoramas with colour.
  LearnedMapper(const std::filesystem::path& weights, const Rig& rig);
  ~LearnedMapper() override;

  /// Expects: a panorama as the rig said (checked).
  FreeSpace Predict(const Panorama& panorama) override;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;  // keeps torch out of this header
};

}  // namespace bulletnav::agent
