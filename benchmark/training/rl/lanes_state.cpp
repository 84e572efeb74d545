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

std::vector<std::int64_t> Shape(const std::vector<float>& numbers) {
  return {static_cast<std::int64_t>(numbers.size())};
}

}  // namespace

void AppendLanes(const PolicyTask& task, const Actor& actor, agent::TensorFile* content) {
  std::vector<float> of_task = task.State();
  std::vector<float> of_actor = actor.State();
  content->tensors[kTask] = {Shape(of_task), std::move(of_task)};
  content->tensors[kActor] = {Shape(of_actor), std::move(of_actor)};
  content->tensors[kHidden] = agent::ToStored(actor.hidden());
}

void SetLanes(const agent::TensorFile& content, const std::filesystem::path& file, PolicyTask* task,
              Actor* actor) {
  task->SetState(Need(content, kTask, Shape(task->State()), file).values);
  actor->SetState(Need(content, kActor, Shape(actor->State()), file).values,
                  agent::FromStored(Need(content, kHidden, actor->hidden().sizes().vec(), file)));
}

}  // namespace bulletnav::bench
