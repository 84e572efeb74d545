# SPDX-License-Identifier: MIT
"""One body."""
import json

from bulletnav import _core, actions as _actions, arrays, spaces
from bulletnav.lanes_owner import RENDER_FPS, LanesOwner, read_seed, require_render_mode, told
from bulletnav.vector_env import make_lanes, result

try:
    from gymnasium import Env as _Base
except ImportError:
    _Base = object


class Env(LanesOwner, _Base):
    """Image-goal navigation for one body: bulletnav.VectorEnv with one lane, without the first
    dimension and without autoreset. Its arguments are those, but num_envs and autoreset_mode.

    Observations are views of one memory that the next step writes into: copy what you keep, or say
    copy=True. Raises bulletnav.Error, in one line with the remedy, for all misuse.
    """

    metadata = {"render_modes": ["rgb_array"], "render_fps": RENDER_FPS}
    spec = None

    def __init__(self, *, render_mode=None, copy=False, **options):
        for name in ("num_envs", "autoreset_mode"):
            if name in options:
                raise _core.Error(f"{name} is an argument of bulletnav.VectorEnv, not of Env")
        require_render_mode(render_mode)
        self._copies = bool(copy)
        self._lanes = make_lanes({"threads": 1, **options, "num_envs": 1,
                                  "autoreset_mode": "disabled"})
        self.render_mode = render_mode
        self.arrays = {array.name: array[0] for array in self._lanes.observed()}
        self._views = {name: arrays.view(array) for name, array in self.arrays.items()}
        self._outcome = self._lanes.outcome()
        depth = self._lanes.max_depth_m
        self.observation_space = spaces.Dict(
            {name: arrays.space(a, depth, a.shape) for name, a in self.arrays.items()})
        self.action_space = spaces.Discrete(len(_actions.Action))

    def reset(self, *, seed=None, options=None):
        """Begins anew as a new environment with this seed would; without one, the next episode.
        Returns (observation, {})."""
        if options:
            raise _core.Error(f"reset knows no options, but got {sorted(options)}")
        seed = read_seed(seed, "a whole number")
        if _Base is not object:
            super().reset(seed=seed)
        self._lanes.reset(seed)
        return self._observations(), {}

    def step(self, action):
        """Returns (observation, reward, terminated, truncated, info); info["measures"] is what an
        episode came to when it ended: {"success", "spl", ...}."""
        self._lanes.step(_actions.read([action.item() if hasattr(action, "item") else action]),
                         None)
        reward, terminated, truncated = (array[0] for array in self._outcome)
        finished = self._lanes.finished()
        info = {"measures": result(finished[0][1])} if finished else {}
        return self._observations(), reward, terminated, truncated, info

    def episode(self):
        """The present episode: a dict in Habitat's form (see docs/python.md)."""
        return json.loads(self._lanes.episode(0))

    def truth(self):
        """What no agent may see: {"pose", "goal": [x, y, z, yaw] in the world, metres and radians;
        "distance": geodesic metres between them}."""
        return told(self._lanes.truth(0))

    def render(self):
        """With render_mode="rgb_array": a copy of the panorama, uint8 [rows, cols, 3]."""
        color = self.rendered()
        return None if color is None else arrays.copy(color)
