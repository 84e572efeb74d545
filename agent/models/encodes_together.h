// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "agent/models/model.h"
#include "agent/observation.h"

namespace bulletnav::agent {

/// A model that several lanes share and that can be told beforehand what they will ask it for: all
/// of that is encoded together when the first of it is asked for. Only for models whose answers do
/// not depend on what else is asked, such as those in integers.
class EncodesTogether : public virtual Model {
 public:
  /// The panoramas of all lanes; they live until the next call. None: forgets them.
  virtual void Expect(std::span<const Panorama> panoramas) = 0;
};

}  // namespace bulletnav::agent
