// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agent/models/safetensors.h"
#include "agent/perception/mapper_config.h"
#include "agent/perception/trunk.h"

namespace bulletnav::agent {

/// The mapper of Active Neural SLAM, from colour to explored cells and obstacles, for a panorama.
/// As there, a ResNet18 comes first, here of any width. Its layers after that are ours: a column of
/// pixels looks along a ray on the floor, so that each column's features, of stages one, two and
/// four of the trunk and of all rows, go through the same fully connected layers, which answer for
/// 64 distances along the ray and the bearings around it. The ring of answers is then resampled
/// from distances and bearings to the cells of FreeSpace. A panorama turned by a quarter gives the
/// same map, turned by a quarter.
/// The same configuration and seed give the same weights on every machine.
class MapperNet : public torch::nn::Module {
 public:
  MapperNet(const MapperConfig& config, std::uint64_t seed);

  const MapperConfig& config() const { return config_; }
  /// From PrepareInput(config.seeing()) to logits [n, 2, 128 (y), 128 (x)]: explored, then obstacle
  /// if explored. Dropout only with a generator.
  torch::Tensor forward(const torch::Tensor& input, std::optional<at::Generator> dropout = {});
  /// For inference only: see ConvNorm::Fold.
  void Fold();

 private:
  static constexpr std::size_t kLevels = 3;  // stages of the trunk that are looked at

  /// Features of each of the columns of stage one.
  torch::Tensor Columns(const torch::Tensor& input);

  MapperConfig config_;
  std::shared_ptr<Trunk> trunk_;
  std::array<std::shared_ptr<Dense>, kLevels> levels_;
  std::shared_ptr<Dense> hidden_;
  std::shared_ptr<Dense> rays_;
  std::array<torch::Tensor, kLevels> spread_;  // [columns, columns of a level] shares
  torch::Tensor cells_;                        // [1, 128, 128, 2] where cells lie on the ring
};

/// A file of weights holds the configuration as YAML in its metadata under "mapper".
void SaveMapper(const MapperNet& net, std::map<std::string, std::string> notes, StoredType type,
                const std::filesystem::path& file);
/// Throws FileError, also if the configuration is missing or bad.
std::shared_ptr<MapperNet> LoadMapper(const std::filesystem::path& file);
/// As TakeNet, for a mapper.
void TakeMapper(const std::filesystem::path& file, MapperNet* net);

}  // namespace bulletnav::agent
