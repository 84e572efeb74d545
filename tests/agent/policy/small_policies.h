// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "agent/policy/policy_input.h"
#include "agent/policy/policy_net.h"

namespace bulletnav::tests {

inline agent::PolicyConfig SmallPolicy(agent::Fusion fusion = agent::Fusion::kCorrelation) {
  agent::PolicyConfig config;
  config.width = 16;
  config.rows = 32;
  config.features = 32;
  config.memory = 32;
  config.fusion = fusion;
  config.precision = agent::Precision::kFloat32;
  return config;
}

/// The same with a map.
inline agent::PolicyConfig SmallMapPolicy() {
  agent::PolicyConfig config = SmallPolicy(agent::Fusion::kLate);
  config.map = true;
  return config;
}

/// A map of PolicyMap with some bits set.
inline std::vector<std::uint8_t> RandomMap(std::uint64_t seed) {
  sim::Rng rng(seed, "map");
  std::vector<std::uint8_t> bytes(agent::kPolicyMapBytes);
  const int dense = rng.Below(5);
  for (std::uint8_t& byte : bytes) {
    byte = static_cast<std::uint8_t>(rng.Below(256) & (rng.Below(6) < dense ? 255 : 0));
  }
  return bytes;
}

/// Panoramas of 128 x 512 with blocks of random colours and depths.
struct RandomPanorama {
  explicit RandomPanorama(std::uint64_t seed)
      : color(std::size_t{3} * 128 * 512), depth(128 * 512) {
    sim::Rng rng(seed, "panorama");
    std::vector<int> light(std::size_t{8} * 32);
    for (int& one : light) one = rng.Below(256);
    for (std::size_t row = 0; row < 128; ++row) {
      for (std::size_t col = 0; col < 512; ++col) {
        const int of_block = light[row / 16 * 32 + col / 16];
        const std::size_t pixel = row * 512 + col;
        for (std::size_t c = 0; c < 3; ++c) {
          color[3 * pixel + c] =
              static_cast<std::uint8_t>((of_block * (1 + static_cast<int>(c))) % 256);
        }
        depth[pixel] = static_cast<float>(of_block) / 32.0f;
      }
    }
  }
  agent::Panorama view() const { return {color, depth}; }

  std::vector<std::uint8_t> color;
  std::vector<float> depth;
};

/// Their bytes, u8 [n, bytes].
inline torch::Tensor BytesOf(const std::vector<RandomPanorama>& panoramas, int rows) {
  agent::PolicyPictures pictures(rows);
  torch::Tensor bytes = torch::empty(
      {static_cast<std::int64_t>(panoramas.size()), static_cast<std::int64_t>(pictures.bytes())},
      torch::kUInt8);
  for (std::size_t i = 0; i < panoramas.size(); ++i) {
    pictures.Write(panoramas[i].view(),
                   {bytes.data_ptr<std::uint8_t>() + i * pictures.bytes(), pictures.bytes()});
  }
  return bytes;
}

/// Bytes of pictures with other maps after them.
inline torch::Tensor WithMaps(const torch::Tensor& pictures) {
  std::vector<torch::Tensor> maps;
  for (std::int64_t i = 0; i < pictures.size(0); ++i) {
    const std::vector<std::uint8_t> map = RandomMap(static_cast<std::uint64_t>(40 + i));
    maps.push_back(torch::tensor(at::ArrayRef<std::uint8_t>(map.data(), map.size())));
  }
  return at::cat({pictures, at::stack(maps)}, 1);
}

inline std::vector<RandomPanorama> SomePanoramas(std::uint64_t seed, int count) {
  std::vector<RandomPanorama> panoramas;
  for (int i = 0; i < count; ++i)
    panoramas.emplace_back(100 * seed + static_cast<std::uint64_t>(i));
  return panoramas;
}

}  // namespace bulletnav::tests
