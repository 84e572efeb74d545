// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/slam_weights.h"

#include <optional>
#include <string>

#include "agent/models/safetensors.h"
#include "agent/slam/descriptors/descriptor_config.h"
#include "agent/slam/descriptors/seqnet_filter.h"
#include "agent/slam/descriptors/seqvlad.h"
#include "benchmark/base/file_hash.h"
#include "benchmark/base/shipped_file.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

// What trains the weights that a config names.
constexpr const char* kDescriptors = "place.yaml";
constexpr const char* kPlaces = "nts_rgbd_wide.yaml";
constexpr const char* kSequences = "seqvlad.yaml, or seqvlad_lengths.yaml";
constexpr const char* kFilter = "seqnet.yaml";

/// The file. Throws sim::FileError if it is not there.
fs::path FileOf(const std::string& name, const std::string& trained_by) {
  const auto file = FindShipped(name);
  if (file) return *file;
  throw sim::FileError(name, "",
                       "is not there; train it: ./bulletnav train configs/train/" + trained_by);
}

/// Weights that were learned from a descriptor are of no use with another one. Files that do not
/// say which it was are taken.
void RequirePair(const agent::TensorFile& weights, const fs::path& file, const SlamConfig& config,
                 const std::string& trained_by) {
  const auto hash = weights.metadata.find(agent::kDescriptorHashKey);
  if (hash == weights.metadata.end() || !config.descriptors) return;
  if (hash->second == FileHash(FileOf(*config.descriptors, kDescriptors))) return;
  throw sim::FileError(file, "",
                       "was trained on another descriptor than " + *config.descriptors +
                           "; train it on that one: configs/train/" + trained_by);
}

}  // namespace

std::shared_ptr<const agent::SequenceModel> LoadSequences(const SlamConfig& config) {
  if (!config.sequences) return nullptr;
  const fs::path file = FileOf(*config.sequences, kSequences);
  const agent::TensorFile weights = agent::ReadTensorFile(file);
  auto model = std::make_shared<const agent::SeqVlad>(weights, file);
  RequirePair(weights, file, config, kSequences);
  return model;
}

std::shared_ptr<const agent::SequenceFilter> LoadFilter(const SlamConfig& config) {
  if (!config.filter) return nullptr;
  const fs::path file = FileOf(*config.filter, kFilter);
  const agent::TensorFile weights = agent::ReadTensorFile(file);
  auto filter = std::make_shared<const agent::SeqNetFilter>(weights, file);
  RequirePair(weights, file, config, kFilter);
  return filter;
}

void CheckWeights(const SlamConfig& config) {
  if (config.descriptors) FileOf(*config.descriptors, kDescriptors);
  if (config.places) FileOf(*config.places, kPlaces);
  LoadSequences(config);
  LoadFilter(config);
}

}  // namespace bulletnav::bench
