// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "agent/models/model.h"

namespace bulletnav::agent {

/// A place for a model that an agent can be given, by name. A run's config fills it: with a file of
/// weights, with the weights that come with the program (`learned`), or with an `oracle`.
struct ModelSlot {
  std::string name;     // as in the config's `models`
  std::string weights;  // the program's own are assets/weights/<weights>_<setting>.safetensors
  bool is_needed = true;
  std::string interface;                      // in words: "semantic model"
  std::function<bool(const Model&)> accepts;  // whether a model has the slot's interface
};

/// A slot for models with interface M, which says what it is by M::kWhat.
template <class M>
ModelSlot NeededSlot(std::string name, std::string weights) {
  return {std::move(name), std::move(weights), true, std::string(M::kWhat), [](const Model& model) {
            return dynamic_cast<const M*>(&model) != nullptr;
          }};
}

/// The same, for an agent that can do without.
template <class M>
ModelSlot OptionalSlot(std::string name, std::string weights) {
  ModelSlot slot = NeededSlot<M>(std::move(name), std::move(weights));
  slot.is_needed = false;
  return slot;
}

/// The models that an agent is given, by slot. Lanes may share them.
class Models {
 public:
  void Set(std::string_view slot, std::shared_ptr<Model> model) {
    models_.insert_or_assign(std::string(slot), std::move(model));
  }

  /// Null if the slot is empty, or its model cannot be asked this way.
  template <class M>
  std::shared_ptr<M> Find(std::string_view slot) const {
    const auto found = models_.find(slot);
    return found == models_.end() ? nullptr : std::dynamic_pointer_cast<M>(found->second);
  }

  /// Throws Error, telling how a config fills the slot, where Find would give null.
  template <class M>
  std::shared_ptr<M> Need(std::string_view slot) const {
    if (auto model = Find<M>(slot)) return model;
    FailWithout(slot, M::kWhat);
  }

  /// Those that can be asked this way, whatever their slots.
  template <class M>
  std::vector<std::shared_ptr<M>> All() const {
    std::vector<std::shared_ptr<M>> all;
    for (const auto& [slot, model] : models_) {
      if (auto found = std::dynamic_pointer_cast<M>(model)) all.push_back(std::move(found));
    }
    return all;
  }

 private:
  [[noreturn]] static void FailWithout(std::string_view slot, std::string_view what);

  std::map<std::string, std::shared_ptr<Model>, std::less<>> models_;
};

}  // namespace bulletnav::agent
