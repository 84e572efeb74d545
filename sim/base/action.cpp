// SPDX-License-Identifier: MIT
#include "sim/base/action.h"

#include "sim/base/check.h"

namespace bulletnav::sim {

std::string_view ActionName(Action action) {
  switch (action) {
    case Action::kStop:
      return "stop";
    case Action::kMoveForward:
      return "move_forward";
    case Action::kTurnLeft:
      return "turn_left";
    case Action::kTurnRight:
      return "turn_right";
  }
  BULLETNAV_CHECK(false);
}

}  // namespace bulletnav::sim
