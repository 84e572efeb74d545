// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/slam_weights.h"

#include <filesystem>
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

/// What is learned from a descriptor, of the file that a config names, or null.
template <class Model>
std::shared_ptr<const Model> LoadPaired(const std::optional<std::string>& name,
                                        const char* trained_by, const SlamConfig& config) {
  if (!name) return nullptr;
  const fs::path file = FileOf(*name, trained_by);
  const agent::TensorFile weights = agent::ReadTensorFile(file);
  auto model = std::make_shared<const Model>(weights, file);
  RequirePair(weights, file, config, trained_by);
  return model;
}

}  // namespace

std::shared_ptr<const agent::SequenceModel> LoadSequences(const SlamConfig& config) {
  return LoadPaired<agent::SeqVlad>(config.sequences, kSequences, config);
}

std::shared_ptr<const agent::SequenceFilter> LoadFilter(const SlamConfig& config) {
  return LoadPaired<agent::SeqNetFilter>(config.filter, kFilter, config);
}

void CheckWeights(const SlamConfig& config) {
  if (config.descriptors) FileOf(*config.descriptors, kDescriptors);
  if (config.places) FileOf(*config.places, kPlaces);
  LoadSequences(config);
  LoadFilter(config);
}

}  // namespace bulletnav::bench
