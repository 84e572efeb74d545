// SPDX-License-Identifier: MIT
#include "agent/policy/learned_policy.h"

#include <algorithm>
#include <utility>

#include "agent/models/model_registry.h"
#include "agent/perception/one_thread.h"
#include "agent/policy/policy_file.h"
#include "agent/policy/policy_net.h"
#include "sim/base/check.h"

namespace bulletnav::agent {
namespace {

torch::Tensor TensorOf(std::span<const float> numbers) {
  torch::Tensor tensor = torch::empty({1, 1, static_cast<std::int64_t>(numbers.size())});
  std::copy(numbers.begin(), numbers.end(), tensor.data_ptr<float>());
  return tensor;
}

std::vector<float> VectorOf(const torch::Tensor& tensor) {
  const torch::Tensor flat = tensor.contiguous();
  return {flat.data_ptr<float>(), flat.data_ptr<float>() + flat.numel()};
}

/// `map`: none for goals.
torch::Tensor Encoded(PolicyNet* net, PolicyPictures* pictures, const Panorama& panorama,
                      std::span<const std::uint8_t> map) {
  torch::Tensor bytes = torch::zeros({1, net->picture_bytes()}, torch::kUInt8);
  std::uint8_t* data = bytes.data_ptr<std::uint8_t>();
  pictures->Write(panorama, {data, pictures->bytes()});
  if (net->config().map) std::copy(map.begin(), map.end(), data + pictures->bytes());
  return net->Encode(bytes);
}

}  // namespace

LearnedPolicy::LearnedPolicy(std::shared_ptr<PolicyNet> net)
    : net_(std::move(net)), pictures_(net_->config().rows) {}

LearnedPolicy::~LearnedPolicy() = default;

int LearnedPolicy::step_limit() const {
  return net_->config().step_limit;
}

bool LearnedPolicy::sees_map() const {
  return net_->config().map;
}

std::vector<float> LearnedPolicy::NoMemory() const {
  return std::vector<float>(static_cast<std::size_t>(net_->config().memory));
}

std::vector<float> LearnedPolicy::CodeOf(const Panorama& goal) {
  const torch::NoGradGuard no_grad;
  StayInThisThread();
  return VectorOf(Encoded(net_.get(), &pictures_, goal, {}));
}

std::array<float, 4> LearnedPolicy::Act(const PolicyQuestion& question,
                                        std::vector<float>* memory) {
  const torch::NoGradGuard no_grad;
  StayInThisThread();
  PolicyNet::Seen seen;
  seen.codes = Encoded(net_.get(), &pictures_, question.panorama, question.map).unsqueeze(0);
  seen.goals = TensorOf(question.goal);
  seen.numbers = TensorOf(question.numbers);
  const PolicyNet::Output output =
      net_->Run(seen, torch::zeros({1, 1}), TensorOf(*memory).squeeze(0));
  *memory = VectorOf(output.memory);
  const std::vector<float> probabilities = VectorOf(output.logits.softmax(-1));
  BULLETNAV_CHECK_EQ(probabilities.size(), std::size_t{4});
  return {probabilities[0], probabilities[1], probabilities[2], probabilities[3]};
}

namespace {

const ModelRegistration registration(kPolicyKey,
                                     [](const std::filesystem::path& weights, const Rig& rig) {
                                       const std::shared_ptr<PolicyNet> net = LoadPolicy(weights);
                                       RequirePolicyRig(rig, ReadTensorFile(weights), weights);
                                       net->eval();
                                       net->Fold();
                                       return std::make_shared<LearnedPolicy>(net);
                                     });

}  // namespace

}  // namespace bulletnav::agent
