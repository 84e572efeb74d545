// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>

#include "agent/integer/integer_encoder.h"
#include "agent/observation.h"
#include "agent/slam/retrieval/picture_descriptor.h"

namespace bulletnav::agent {

/// Describes panoramas of 128 x 512 by the codes that the encoder of a semantic model makes of
/// their patches, see DescribeCodes: no network of its own, and which way the body looks does not
/// count. In whole numbers: the same bytes on every processor. Not for several threads at once.
class PanoramaDescriber {
 public:
  /// Throws Error if layers are missing or do not fit.
  PanoramaDescriber(const QuantisedNet& net, int rows, bool uses_depth);

  int size() const { return encoder_.code_size(); }
  /// Expects: colour and, if the model takes it, depth, of the right size (checked).
  PictureDescriptor Describe(const Panorama& panorama);

 private:
  IntegerEncoder encoder_;
};

/// From a semantic model's file of weights. Throws FileError if there is none, or it has no encoder
/// in integers.
std::unique_ptr<PanoramaDescriber> LoadPanoramaDescriber(const std::filesystem::path& weights);

}  // namespace bulletnav::agent
