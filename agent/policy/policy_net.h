// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "agent/models/safetensors.h"
#include "agent/perception/encoder.h"
#include "agent/policy/integer_sight.h"
#include "agent/policy/map_branch.h"
#include "agent/policy/policy_config.h"

namespace bulletnav::agent {

/// A recurrent policy on panoramas. Seen panorama and goal go through one encoder, the semantic
/// models' own (twelve codes of 90 degrees each), without normalisation by batches: a rollout and
/// its update must agree. Two fully connected layers join them with numbers (see
/// WritePolicyNumbers), a GRU remembers, and heads answer with actions and their value. At first
/// the policy stops in a fiftieth of the steps: one that chose evenly would end after four.
/// The same configuration and seed give the same weights on every machine.
class PolicyNet : public torch::nn::Module {
 public:
  struct Seen {
    torch::Tensor codes;    // [steps, lanes, code_size()], from Encode
    torch::Tensor goals;    // likewise
    torch::Tensor numbers;  // [steps, lanes, kPolicyNumbers]
  };
  struct Output {
    torch::Tensor logits;  // [steps, lanes, 4]
    torch::Tensor values;  // [steps, lanes]
    torch::Tensor memory;  // [lanes, memory], after the last step
  };
  static constexpr int kCodes = 12 * kCodeSize;  // of a panorama

  PolicyNet(const PolicyConfig& config, std::uint64_t seed);

  const PolicyConfig& config() const { return config_; }
  /// Bytes of PolicyPictures and, if it is shown a map, of PolicyMap after them.
  std::int64_t picture_bytes() const { return PictureBytes(config_); }
  static std::int64_t PictureBytes(const PolicyConfig& config);
  /// Numbers that Encode makes of them: kCodes, and the map's bytes as they are.
  std::int64_t code_size() const { return CodeSize(config_); }
  static std::int64_t CodeSize(const PolicyConfig& config);
  /// u8 [n, picture_bytes()] to [n, code_size()]. The map's part of a goal does not matter.
  torch::Tensor Encode(const torch::Tensor& pictures);
  /// `starts` [steps, lanes], 1 where an episode begins: the memory [lanes, memory] that comes in
  /// is then zero.
  Output Run(const Seen& seen, const torch::Tensor& starts, const torch::Tensor& memory);

  /// Products of codes [n, kCodes] with those of goals, each twelfth with each at all turns: [n, 4
  /// * 12 (i) * 12 (turn)]. Expects: kCorrelation.
  torch::Tensor Correlation(const torch::Tensor& codes, const torch::Tensor& goals);

  /// For inference only: see ConvNorm::Fold.
  void Fold();

  /// Sees with an encoder in integers from now on, which is not trained. Expects: codes of kCodes
  /// numbers (checked).
  void SeeWith(std::shared_ptr<IntegerSight> sight);
  const std::shared_ptr<IntegerSight>& sight() const { return sight_; }  // or null

 private:
  torch::Tensor EncodeInIntegers(const torch::Tensor& pictures) const;
  torch::Tensor Joined(const Seen& seen);

  PolicyConfig config_;
  std::shared_ptr<Encoder> encoder_;
  std::shared_ptr<IntegerSight> sight_;
  std::shared_ptr<Dense> whole_;         // of twelve codes together
  std::shared_ptr<Dense> source_match_;  // these two and the next: kCorrelation
  std::shared_ptr<Dense> goal_match_;
  std::shared_ptr<Dense> matches_;
  std::shared_ptr<MapBranch> map_;  // or null
  std::shared_ptr<Dense> joined_;
  std::shared_ptr<Dense> gru_in_;
  std::shared_ptr<Dense> gru_memory_;
  std::shared_ptr<Dense> policy_;
  std::shared_ptr<Dense> value_;
};

/// The encoder's input from pictures as of Encode: [n, 4, rows, cols] as of PrepareInput.
torch::Tensor PolicyInput(const PolicyConfig& config, const torch::Tensor& pictures);

/// A file of weights holds the configuration as YAML in its metadata under "policy". Loading takes
/// files of trained numbers and of integers; see RestorePolicy.
void SavePolicy(const PolicyNet& net, std::map<std::string, std::string> notes, StoredType type,
                const std::filesystem::path& file);
/// Throws FileError, also if the configuration is missing or bad.
std::shared_ptr<PolicyNet> LoadPolicy(const std::filesystem::path& file);
/// Takes the weights of a trained policy of the same shape, to go on from. A policy that is shown a
/// map may take one's that is not: its map counts for nothing at first. A policy with an encoder of
/// its own keeps it where the other has none. Throws FileError if the policy is of another shape,
/// or saw with another encoder in integers.
void TakePolicy(const std::filesystem::path& weights, PolicyNet* net);
/// Takes the encoder of a semantic model of the same width and rows; one of colour alone does not
/// heed depth at first. Throws FileError if it is of another shape.
void TakeEncoder(const std::filesystem::path& weights, PolicyNet* net);
/// What the setting rgb shows of pictures without a map, u8 [n, picture_bytes()]: no depth.
torch::Tensor WithoutDepth(const torch::Tensor& pictures);
/// The encoder in integers of a semantic model or a policy, for pictures of so many rows. Throws
/// FileError if the file has none.
std::shared_ptr<IntegerSight> LoadSight(const std::filesystem::path& weights, int rows);
/// Lets a policy see with a semantic model's encoder in integers, of the same rows. Throws
/// FileError if the file has none.
void TakeIntegerEncoder(const std::filesystem::path& weights, PolicyNet* net);

}  // namespace bulletnav::agent
