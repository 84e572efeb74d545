// SPDX-License-Identifier: MIT
#include "agent/models/model_registry.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

#include <yaml-cpp/yaml.h>

#include "agent/models/safetensors.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

using Loaders = std::map<NumberForm, ModelLoader>;

/// Filled before main, or by SetMoreModelKinds' function, and only read after that.
std::map<std::string, Loaders, std::less<>>& Registered() {
  static std::map<std::string, Loaders, std::less<>> kinds;
  return kinds;
}

struct MoreKinds {
  std::mutex mutex;
  std::function<void()> take_in;
};

MoreKinds& More() {
  static MoreKinds more;
  return more;
}

const ModelLoader* FindLoader(const TensorFile& file) {
  for (const auto& [key, loaders] : Registered()) {
    if (!file.metadata.contains(key)) continue;
    const auto integers = loaders.find(NumberForm::kIntegers);
    if (integers != loaders.end() && HoldsIntegers(file)) return &integers->second;
    const auto trained = loaders.find(NumberForm::kTrained);
    if (trained != loaders.end()) return &trained->second;
  }
  return nullptr;
}

/// Whether there may be more kinds now than before.
bool TookInMore() {
  const std::lock_guard lock(More().mutex);
  if (!More().take_in) return false;
  std::exchange(More().take_in, nullptr)();
  return true;
}

/// Files written before there was an entry `frames` tell it by what was trained.
std::optional<std::int64_t> FramesOfOldFile(const TensorFile& file) {
  const auto step = file.metadata.find("step");
  const auto training = file.metadata.find("training");
  if (step == file.metadata.end() || training == file.metadata.end()) return std::nullopt;
  try {
    const YAML::Node plan = YAML::Load(training->second);
    return std::stoll(step->second) * plan["scenes"].as<std::int64_t>() *
           plan["panoramas"].as<std::int64_t>();
  } catch (const std::exception&) {
    return std::nullopt;  // of another program
  }
}

}  // namespace

bool HoldsIntegers(const TensorFile& file) {
  if (file.metadata.contains(kIntegerPart)) return false;
  return std::any_of(file.tensors.begin(), file.tensors.end(), [](const auto& entry) {
    return entry.first.starts_with(kIntegerPrefix);
  });
}

std::vector<std::string> ModelKinds() {
  std::vector<std::string> keys;
  for (const auto& [key, loaders] : Registered()) keys.push_back(key);
  return keys;
}

std::shared_ptr<Model> LoadModel(const std::filesystem::path& weights, const Rig& rig) {
  const TensorFile file = ReadTensorFile(weights);
  const ModelLoader* loader = FindLoader(file);
  if (loader == nullptr && TookInMore()) loader = FindLoader(file);
  if (loader != nullptr) return (*loader)(weights, rig);
  std::string known;
  for (const std::string& key : ModelKinds()) known += (known.empty() ? "" : ", ") + key;
  if (known.empty()) known = "none: it was built without learning";
  throw sim::FileError(weights, "",
                       "holds no kind of model that this program knows (" + known + ")");
}

std::optional<std::int64_t> FramesTrained(const std::filesystem::path& weights) {
  const TensorFile file = ReadTensorFile(weights);
  const auto frames = file.metadata.find("frames");
  if (frames == file.metadata.end()) return FramesOfOldFile(file);
  try {
    return std::stoll(frames->second);
  } catch (const std::exception&) {
    throw sim::FileError(weights, "", "its metadata's 'frames' is no number");
  }
}

void SetMoreModelKinds(std::function<void()> take_in) {
  More().take_in = std::move(take_in);
}

void internal::RegisterModel(std::string_view key, NumberForm form, ModelLoader loader) {
  if (!Registered()[std::string(key)].try_emplace(form, std::move(loader)).second) {
    throw sim::Error("two kinds of models are called '" + std::string(key) + "'");
  }
}

}  // namespace bulletnav::agent
