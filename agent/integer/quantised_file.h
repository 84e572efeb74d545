// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "agent/integer/quantised_layer.h"
#include "agent/models/model_registry.h"
#include "agent/models/safetensors.h"
#include "sim/base/error.h"

namespace bulletnav::agent {

/// Names after kIntegerPrefix. Of layer NAME: integer.NAME.weight, .scale and .bias; of a scale:
/// integer.NAME.step. Takes out what was there of the kind, and puts `net` in.
void SetQuantised(const QuantisedNet& net, TensorFile* content);

/// Writes the weights of `file` to `out`, which may be the same, with `net` in them; floats as
/// narrow as they were, and without those of these names. Throws FileError.
void AddQuantised(const QuantisedNet& net, const std::filesystem::path& file,
                  const std::filesystem::path& out, std::span<const std::string> without = {});

/// The entry of a file's metadata that says so if the trained weights were left out.
inline constexpr const char* kIntegersAlone = "integers_alone";

/// Writes `file` to `out` without the trained weights that its integers were made from (arrays of
/// two dimensions and more): a third to a half of the bytes, and the same answers, but nothing can
/// be trained on from it. Throws FileError if `file` has no whole network in integers.
void KeepIntegersAlone(const std::filesystem::path& file, const std::filesystem::path& out);

/// Throws FileError naming `file` if there is none, or it is not whole: integers that are not of 8
/// or 16 bits, shapes that do not agree, numbers that are not finite.
QuantisedNet ReadQuantised(const TensorFile& content, const std::filesystem::path& file);

/// What `make` makes of a file's integers; the Error that it throws becomes a FileError with what
/// there is to be done, as "quantise it again".
template <class Make>
auto MadeOfIntegers(const std::filesystem::path& file, const char* remedy, const Make& make) {
  try {
    return make();
  } catch (const sim::Error& error) {
    throw sim::FileError(file, kIntegerPrefix,
                         std::string("cannot be used: ") + error.what() + "; " + remedy);
  }
}

}  // namespace bulletnav::agent
