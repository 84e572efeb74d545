// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "agent/models/model.h"
#include "agent/models/safetensors.h"
#include "agent/observation.h"

namespace bulletnav::agent {

/// Makes a model from a file of weights, for bodies with this rig. Throws FileError if the weights
/// cannot be used, Error if the rig does not give what the model takes. Called from any thread; the
/// model is for one thread.
using ModelLoader =
    std::function<std::shared_ptr<Model>(const std::filesystem::path& weights, const Rig& rig)>;

/// What a model works with: the numbers that were trained, or the integers beside them.
enum class NumberForm { kTrained, kIntegers };

/// In a file of weights, names of what a network in integers needs start so; the others are the
/// trained numbers, which it is made from.
inline constexpr const char* kIntegerPrefix = "integer.";

/// The entry of a file's metadata that says so if its integers are but a part of the network, such
/// as an encoder that was not trained: it works with the trained numbers.
inline constexpr const char* kIntegerPart = "integer_part";

/// Whether weights hold a whole network in integers beside the trained one.
bool HoldsIntegers(const TensorFile& weights);

/// Keys of all registered kinds of models, in alphabetical order.
std::vector<std::string> ModelKinds();

/// The model that a file of weights holds. Its kind is the one whose key is in the file's metadata;
/// it works in integers if the file has them and the kind has a loader for them.
/// Throws what the kind's loader throws, and FileError if the file cannot be read or is of a kind
/// that this program does not know, listing those it does.
std::shared_ptr<Model> LoadModel(const std::filesystem::path& weights, const Rig& rig);

/// How many panoramas (or steps) the weights were trained on, counted as often as they were shown,
/// as the trainer noted in the file; absent if it did not. Throws FileError.
std::optional<std::int64_t> FramesTrained(const std::filesystem::path& weights);

/// Called once, before a file is refused for its kind: for programs that take in the networks when
/// they need them. Not to be set while other threads load models.
void SetMoreModelKinds(std::function<void()> take_in);

namespace internal {

/// Throws Error if the key is taken in that form.
void RegisterModel(std::string_view key, NumberForm form, ModelLoader loader);

}  // namespace internal

/// Makes a kind of model known: one constant of this type at the end of its file does it. `key`:
/// the entry of a file's metadata that holds the model's configuration, and by which it is told
/// from other kinds. A kind may have a loader for each form of its numbers.
class ModelRegistration {
 public:
  ModelRegistration(std::string_view key, ModelLoader loader,
                    NumberForm form = NumberForm::kTrained) {
    internal::RegisterModel(key, form, std::move(loader));
  }
};

}  // namespace bulletnav::agent
