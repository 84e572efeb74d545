// SPDX-License-Identifier: MIT
#pragma once
#include "agent/perception/encoder.h"
#include "benchmark/training/supervised/data_config.h"
#include "benchmark/training/supervised/pair_batch.h"

namespace bulletnav::bench {

/// What a model sees at all points of all scenes of a config, for agent::Quantise: PrepareInput of
/// their panoramas, scene after scene. Labels scenes that are not yet. Throws sim::Error, see
/// LabelScene.
torch::Tensor CalibrationInput(const DataConfig& config, const agent::ModelConfig& model);
/// Likewise, of batches number 0 on, some 400 panoramas.
torch::Tensor CalibrationInput(const BatchSource& batches, const agent::ModelConfig& model);

}  // namespace bulletnav::bench
