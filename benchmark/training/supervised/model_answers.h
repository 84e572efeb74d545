// SPDX-License-Identifier: MIT
#pragma once
#include "agent/models/free_space_model.h"
#include "agent/models/semantic_model.h"
#include "agent/perception/heads.h"
#include "benchmark/training/supervised/nts_loss.h"
#include "benchmark/training/supervised/pair_batch.h"

namespace bulletnav::bench {

/// What a model that acts says about a batch, in the form of the outputs of a net: its
/// probabilities as logits.
struct ModelAnswers {
  torch::Tensor explorable;  // [panoramas, 12]
  agent::PairOutputs pairs;  // [n, ...]
};
ModelAnswers AnswersOf(agent::SemanticModel* model, const PairBatch& batch,
                       const LabelledPairs& pairs);

/// [panoramas, 2, 128, 128], explored, then obstacle.
torch::Tensor AnswersOf(agent::FreeSpaceModel* model, const PairBatch& batch);

}  // namespace bulletnav::bench
