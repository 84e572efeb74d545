// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/lanes_state.h"

#include <string>
#include <utility>
#include <vector>

#include "agent/perception/weights.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

constexpr const char* kTask = "lanes.task";
constexpr const char* kActor = "lanes.actor";
constexpr const char* kHidden = "lanes.hidden";

const agent::TensorFile::Tensor& Need(const agent::TensorFile& content, const std::string& name,
                                      const std::vector<std::int64_t>& shape,
                                      const std::filesystem::path& file) {
  const auto found = content.tensors.find(name);
  if (found == content.tensors.end() || found->second.shape != shape) {
    throw sim::FileError(file, name,
                         "is missing: this is no checkpoint of this training; remove it");
  }
  return found->second;
}

torch::Tensor TensorOf(const std::vector<float>& numbers) {
  return at::tensor(at::ArrayRef<float>(numbers.data(), numbers.size()), torch::kFloat32);
}

std::vector<float> NumbersOf(const torch::Tensor& tensor) {
  const torch::Tensor flat = tensor.contiguous();
  return {flat.data_ptr<float>(), flat.data_ptr<float>() + flat.numel()};
}

/// Of all processes, one after the other: states are lane after lane.
agent::TensorFile::Tensor All(const torch::Tensor& own, Peers* peers) {
  if (peers == nullptr) return agent::ToStored(own);
  return agent::ToStored(peers->Gather(own).flatten(0, 1));
}

/// The part of this process, of the shape of `own`.
torch::Tensor Part(const agent::TensorFile& content, const std::string& name,
                   const std::filesystem::path& file, const torch::Tensor& own, Peers* peers) {
  std::vector<std::int64_t> shape = own.sizes().vec();
  const std::int64_t size = shape.front();
  shape.front() *= peers == nullptr ? 1 : peers->size();
  const torch::Tensor all = agent::FromStored(Need(content, name, shape, file));
  return all.narrow(0, size * (peers == nullptr ? 0 : peers->rank()), size);
}

}  // namespace

void AppendLanes(const LanesRef& lanes, agent::TensorFile* content) {
  content->tensors[kTask] = All(TensorOf(lanes.task->State()), lanes.peers);
  content->tensors[kActor] = All(TensorOf(lanes.actor->State()), lanes.peers);
  content->tensors[kHidden] = All(lanes.actor->hidden(), lanes.peers);
}

void SetLanes(const agent::TensorFile& content, const std::filesystem::path& file,
              const LanesRef& lanes) {
  const auto part = [&](const char* name, const torch::Tensor& own) {
    return Part(content, name, file, own, lanes.peers);
  };
  lanes.task->SetState(NumbersOf(part(kTask, TensorOf(lanes.task->State()))));
  const std::vector<float> actor = NumbersOf(part(kActor, TensorOf(lanes.actor->State())));
  lanes.actor->SetState(actor, part(kHidden, lanes.actor->hidden()));
}

}  // namespace bulletnav::bench
