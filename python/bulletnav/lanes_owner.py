# SPDX-License-Identifier: MIT
"""What the environments for one body and for many have in common."""
import operator

from bulletnav import _core, arrays

RENDER_FPS = 10  # for who makes films of what is rendered; time has no part in an episode


def require_render_mode(render_mode):
    if render_mode not in (None, "rgb_array"):
        raise _core.Error(f"render_mode is 'rgb_array' or None, not {render_mode!r}")


def read_seed(seed, what):
    """None, or a whole number of any kind (numpy's too) as an int."""
    if seed is None:
        return None
    try:
        number = operator.index(seed)
    except TypeError:
        number = -1
    if number < 0:
        raise _core.Error(f"seed must be {what}, not {seed!r}")
    return number


def told(truth):
    """What the extension says of a lane's truth, with names."""
    pose, goal, distance = truth
    return {"pose": pose, "goal": goal, "distance": distance}


class LanesOwner:
    """Has the extension's lanes in `_lanes`, views of their memory in `_views`, and in `_copies`
    whether observations are arrays of their own."""

    def _observations(self):
        if not self._copies:
            return dict(self._views)
        return {name: arrays.copied(array) for name, array in self.arrays.items()}

    def rendered(self):
        """The array of panoramas to copy from; None without a render_mode."""
        if self.render_mode is None:
            return None
        self._lanes.outcome()  # Raises where there is no environment any more.
        if "panorama.color" not in self.arrays:
            raise _core.Error("there is nothing to render: the body has no 'panorama.color'")
        return self.arrays["panorama.color"]

    def close(self):
        """Views of what was observed last stay readable, and keep memory and threads."""
        self._lanes.close()
        self.arrays, self._views, self._outcome = {}, {}, []

    @property
    def unwrapped(self):
        return self

    def __enter__(self):
        return self

    def __exit__(self, *ignored):
        self.close()

    def __del__(self):
        lanes = getattr(self, "_lanes", None)
        if lanes is not None:
            lanes.close()
