# SPDX-License-Identifier: MIT
"""What a body can do in one step."""
import enum
import operator

from bulletnav._core import Error


class Action(enum.IntEnum):
    """Forward 0.25 m, turn 10 degrees, or end the episode."""

    STOP = 0
    MOVE_FORWARD = 1
    TURN_LEFT = 2
    TURN_RIGHT = 3


def read(actions):
    """A list of whole numbers from a list, an array or a tensor of them."""
    if hasattr(actions, "tolist"):
        actions = actions.tolist()
    try:
        actions = list(actions)
    except TypeError:
        raise Error(f"actions must be a list or an array of whole numbers, not {actions!r}"
                    ) from None
    return [_read(action) for action in actions]


def _read(action):
    try:
        number = operator.index(action)
    except TypeError:
        raise Error(f"actions must be whole numbers, one a lane; got {action!r}") from None
    if not 0 <= number < len(Action):
        raise Error(f"{number} is no action; 0: stop, 1: move forward, 2: turn left, 3: turn right")
    return number
