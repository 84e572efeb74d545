// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "agent/integer/dot_layer.h"
#include "agent/integer/integer_trunk.h"
#include "agent/slam/descriptors/descriptor_config.h"
#include "agent/slam/descriptors/gem.h"
#include "agent/slam/retrieval/picture_descriptor.h"

namespace bulletnav::agent {

/// Describes flat pictures: the trunk, GeM over the cells of its last stage, one layer, length 1.
/// All in whole numbers, without torch: the same bytes on every processor. Layers "out" and those
/// of the trunk after "trunk.", scales of both and "exponent", GeM's. Not for several threads at
/// once.
class PictureDescriber {
 public:
  /// Throws Error if layers are missing or do not fit.
  PictureDescriber(const QuantisedNet& net, const DescriptorConfig& config);

  const DescriptorConfig& config() const { return config_; }

  /// Of an RGB picture [height, width, 3]. Throws sim::Error for one that is smaller than the
  /// network's, or has another number of bytes.
  PictureDescriptor Describe(std::span<const std::uint8_t> rgb, int width_px, int height_px);
  /// Of one that ShrinkPicture made. Expects: its size (checked).
  PictureDescriptor DescribeShrunk(std::span<const std::uint8_t> picture);

  /// What stage three of the trunk saw in the last picture: [cells, 4 * width] bytes.
  std::vector<std::uint8_t> Cells() const;

  void Use(const IntegerKernels& kernels);

 private:
  DescriptorConfig config_;
  IntegerTrunk trunk_;
  Gem gem_;
  DotLayer out_;
};

/// From a file of weights. Throws FileError if there is none, or it cannot be used.
std::unique_ptr<PictureDescriber> LoadPictureDescriber(const std::filesystem::path& weights);

}  // namespace bulletnav::agent
