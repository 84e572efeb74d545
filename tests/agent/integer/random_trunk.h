// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "agent/integer/integer_trunk.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {

inline QuantisedLayer RandomLayer(int outputs, int kernel, int channels, sim::Rng* rng) {
  QuantisedLayer layer;
  layer.outputs = outputs;
  layer.segments = kernel;
  layer.inputs = kernel * channels;
  for (int i = 0; i < outputs * kernel * kernel * channels; ++i) {
    layer.weights.push_back(static_cast<std::int16_t>(rng->Between(-64, 64)));
  }
  for (int i = 0; i < outputs; ++i) {
    layer.scale.push_back(static_cast<float>(rng->Uniform(0.5, 1.5)));
    layer.bias.push_back(static_cast<float>(rng->Uniform(-20000.0, 20000.0)));
  }
  return layer;
}

/// Weights of the largest range, scales under which activations are neither all 0 nor all 255.
inline QuantisedTrunk RandomTrunk(int rows, int width, int halvings, std::uint64_t seed) {
  sim::Rng rng(seed, "random_trunk");
  QuantisedTrunk trunk;
  trunk.rows = rows;
  trunk.in_scale = 1.0f;
  trunk.stem = RandomLayer(width, 7, kInputChannels, &rng);
  trunk.stem_scale = 400.0f;
  double in = trunk.stem_scale;
  int channels = width;
  for (int i = 0; i < 8; ++i) {
    const int stage = i / 2;
    const int out = width << stage;
    QuantisedTrunk::Block block;
    block.stride = i % 2 == 0 && stage > 0 && stage <= halvings ? 2 : 1;
    block.first = RandomLayer(out, 3, channels, &rng);
    block.first_scale = static_cast<float>(in * 20.0 * channels / 4.0);
    block.second = RandomLayer(out, 3, out, &rng);
    block.second_scale = static_cast<float>(block.first_scale * 20.0 * out / 4.0);
    if (out != channels || block.stride != 1) {
      block.shortcut = RandomLayer(out, 1, channels, &rng);
      block.shortcut_scale = static_cast<float>(in * 0.5);
    } else {
      // What is kept would be next to nothing in such units.
      block.second_scale = static_cast<float>(in * 1.5);
      block.first_scale = static_cast<float>(in);
      for (float& scale : block.first.scale) scale *= 0.01f;
      for (float& scale : block.second.scale) scale *= 0.01f;
    }
    in = block.second_scale;
    channels = out;
    trunk.blocks.push_back(std::move(block));
  }
  return trunk;
}

}  // namespace bulletnav::agent
