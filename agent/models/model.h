// SPDX-License-Identifier: MIT
#pragma once

namespace bulletnav::agent {

/// Something that an agent asks: a network with its weights, or an oracle in its place. What it can
/// be asked is said by the interfaces that derive from this one, such as SemanticModel; a model may
/// have several of them.
class Model {
 public:
  Model() = default;
  virtual ~Model() = default;
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;
  Model(Model&&) = delete;
  Model& operator=(Model&&) = delete;
};

}  // namespace bulletnav::agent
