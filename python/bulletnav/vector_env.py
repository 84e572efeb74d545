# SPDX-License-Identifier: MIT
"""Many bodies at once, stepped by C++ threads without the interpreter's lock."""
import enum
import json
import os

from bulletnav import _core, actions as _actions, arrays, given, spaces
from bulletnav.lanes_owner import RENDER_FPS, LanesOwner, read_seed, require_render_mode, told

try:
    from gymnasium.vector import VectorEnv as _Base
except ImportError:
    _Base = object
try:
    from gymnasium.vector import AutoresetMode
except ImportError:

    class AutoresetMode(enum.Enum):
        """When a lane whose episode is over gets the next one; as Gymnasium's."""

        NEXT_STEP = "NextStep"
        SAME_STEP = "SameStep"
        DISABLED = "Disabled"


_MODES = {"next_step": AutoresetMode.NEXT_STEP, "same_step": AutoresetMode.SAME_STEP,
          "disabled": AutoresetMode.DISABLED}
_LISTS = ("scenes", "scene_folders")
_LANE = "environment: a lane is a whole number from 0 on"


def _plain(value):
    """What JSON can say of an argument."""
    if isinstance(value, AutoresetMode):
        return next(name for name, mode in _MODES.items() if mode is value)
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError


def make_lanes(options):
    """The extension's lanes, from keyword arguments."""
    options = dict(options)
    for name in _LISTS:
        if isinstance(options.get(name), (str, os.PathLike)):
            options[name] = [options[name]]
    options = {name: value for name, value in options.items() if value is not None}
    return _core.Lanes(given.config(options, "environment", _plain))


def result(text):
    """What an episode came to, from the extension's JSON."""
    facts = json.loads(text)
    for name in ("agent", "setting", "condition", "seed"):
        facts.pop(name, None)
    return facts


class VectorEnv(LanesOwner, _Base):
    """`num_envs` lanes that play image-goal navigation, episode after episode.

    Lane i plays number i, i + num_envs, ... of the episodes. What a lane sees is a function of the
    arguments, the seed and the actions: not of other lanes nor of the number of threads.

    Arguments, all by name:
      scenes: files (glb, gltf, obj, ply, dae) to draw episodes in; see bulletnav.generate
      counts: {"easy", "medium", "hard", "sequential"} to draw, over all scenes together;
        20 easy ones a scene if not given. Easy is 1.5 to 3 m of way, medium to 5, hard to 10.
      sequential_goals, episode_seed: of that draw
      episodes: instead of scenes, a file of episodes (Habitat's form too, .json or .json.gz)
      scene_folders: where its scenes are looked for
      num_envs, threads: lanes; C++ threads, 0 for one per processor
      seed, shuffle: of noise and order; another order in each pass through the episodes
      autoreset_mode: "next_step", "same_step", "disabled" or Gymnasium's AutoresetMode
      sensors: "rgb", "rgbd", or {name: {type: panorama | pinhole | odometry | bumper, ...}}
      body: {radius, height, camera_height, max_climb, max_slope_deg, sliding}, metres
      noise: of motion: "ans_released" (default), "none", "ans_radians", "physical"
      sensor_noise: of cameras: "none" (default), "depth_camera", "phone_camera", "stereo_camera"
      success_distance (m), no_stop, max_steps, reward: {success, progress, step}
      import_: {up: y | z, scale, ground_plane, doors: as_built | open | closed |
        {open_share, seed}, finish: {...}}, as import in configs
      navmesh: {...}; backend: auto | egl | embree
      render_mode: "rgb_array" or None
      copy: True: observations are arrays of their own, as Gymnasium's wrappers expect

    Observations are a dict of arrays, lane first; views of one memory that the next step writes
    into: copy what you keep.
      panorama.color  uint8   [num_envs, 128, 512, 3]  RGB; column 0 looks behind, clockwise
      panorama.depth  float32 [num_envs, 128, 512]     metres along the ray, 0: no return
      odometry.motion float64 [num_envs, 3]            measured: m ahead, m to the left, rad
      bumper.collided uint8   [num_envs, 1]            1: something was in the way
      goal.color, goal.depth                           the panorama at the goal, as the body's
    Actions: bulletnav.Action, one whole number a lane. Rewards, terminated and truncated are
    arrays [num_envs] of their own.

    Raises bulletnav.Error, in one line with the remedy, for all misuse.
    """

    metadata = {"render_modes": ["rgb_array"], "render_fps": RENDER_FPS,
                "autoreset_mode": AutoresetMode.NEXT_STEP}
    spec = None

    def __init__(self, *, num_envs=1, render_mode=None, copy=False, **options):
        require_render_mode(render_mode)
        self._copies = bool(copy)
        self._lanes = make_lanes({"num_envs": num_envs, **options})
        self.num_envs = self._lanes.num_envs
        self.render_mode = render_mode
        self.metadata = {**type(self).metadata,
                         "autoreset_mode": _MODES[self._lanes.autoreset_mode]}
        self.arrays = {array.name: array for array in self._lanes.observed()}
        self._views = {name: arrays.view(array) for name, array in self.arrays.items()}
        self._outcome = self._lanes.outcome()
        depth = self._lanes.max_depth_m
        self.single_observation_space = spaces.Dict(
            {name: arrays.space(a, depth, a.shape[1:]) for name, a in self.arrays.items()})
        self.observation_space = spaces.Dict(
            {name: arrays.space(a, depth, a.shape) for name, a in self.arrays.items()})
        self.single_action_space = spaces.Discrete(len(_actions.Action))
        self.action_space = spaces.MultiDiscrete([len(_actions.Action)] * self.num_envs)

    def reset(self, *, seed=None, options=None):
        """Begins anew as a new environment with this seed would; without one, goes on with the
        next episodes. options={"reset_mask": [bool] * num_envs}: in these lanes alone.
        Returns (observations, {})."""
        options = dict(options or {})
        mask = options.pop("reset_mask", None)
        if options:
            raise _core.Error(f"reset knows no option {sorted(options)}; it knows 'reset_mask'")
        seed = read_seed(seed, "one whole number for all lanes")
        if _Base is not object:
            super().reset(seed=seed)
        if mask is None:
            self._lanes.reset(seed)
        elif seed is not None:
            raise _core.Error("a seed begins all lanes anew; give it without a reset_mask")
        else:
            self._lanes.reset_lanes(self._chosen(mask))
        return self._observations(), {}

    def _chosen(self, mask):
        mask = list(mask)
        if len(mask) != self.num_envs:
            raise _core.Error(f"reset_mask has {len(mask)} entries for {self.num_envs} lanes")
        return [lane for lane, chosen in enumerate(mask) if chosen]

    def step(self, actions):
        """One action for each lane.
        Returns (observations, rewards, terminated, truncated, info).

        info["measures"] is there when episodes ended: {measure: [num_envs]}, such as "success" and
        "spl", with the mask info["_measures"]; info["results"] has all facts of these lanes, a dict
        each, with the mask info["_results"]."""
        self._lanes.step(_actions.read(actions), None)
        return self._answer()

    def send(self, actions, lanes=None):
        """As step, but returns at once: recv waits for it. `lanes`: a range of neighbours that
        move, all if not given; meanwhile the rows of the others can be read."""
        if lanes is not None:
            lanes = range(self.num_envs)[lanes] if isinstance(lanes, slice) else lanes
            lanes = list(lanes)
            if (not lanes or lanes != list(range(lanes[0], lanes[0] + len(lanes)))
                    or lanes[0] < 0 or lanes[-1] >= self.num_envs):
                raise _core.Error("lanes must be neighbours between 0 and "
                                  f"{self.num_envs - 1}, as range(0, 2)")
        self._lanes.send(_actions.read(actions), lanes)

    def recv(self):
        """What step would return, of the lanes that were sent: their rows of the same memory, and
        info["lanes"], a range."""
        lanes = self._lanes.recv()
        first, last = lanes[0], lanes[-1] + 1
        observations, rewards, terminated, truncated, info = self._answer()
        info["lanes"] = range(first, last)
        rows = {name: array[first:last] for name, array in observations.items()}
        return rows, rewards[first:last], terminated[first:last], truncated[first:last], info

    def _answer(self):
        rewards, terminated, truncated = (arrays.copy(array) for array in self._outcome)
        return self._observations(), rewards, terminated, truncated, self._info()

    def _info(self):
        finished = self._lanes.finished()
        if not finished:
            return {}
        mask, results = arrays.filled(self.num_envs, False), arrays.filled(self.num_envs, None)
        measures = {}
        for lane, text in finished:
            mask[lane], results[lane] = True, result(text)
            for name, value in results[lane].items():
                if isinstance(value, (bool, int, float)):
                    column = measures.setdefault(name, arrays.filled(self.num_envs, 0.0))
                    column[lane] = float(value)
        return {"measures": measures, "_measures": mask, "results": results, "_results": mask}

    def episode(self, lane):
        """The episode that a lane is in: a dict in Habitat's form (see docs/python.md)."""
        return json.loads(self._lanes.episode(given.whole(lane, _LANE)))

    def truth(self, lane):
        """What no agent may see, for teachers and rewards: {"pose", "goal": [x, y, z, yaw] in the
        world, metres and radians; "distance": geodesic metres between them}."""
        return told(self._lanes.truth(given.whole(lane, _LANE)))

    def render(self):
        """With render_mode="rgb_array": a tuple of copies of the panoramas, one a lane."""
        colors = self.rendered()
        if colors is None:
            return None
        return tuple(arrays.copy(colors[lane]) for lane in range(self.num_envs))

    def close(self, **kwargs):
        """Views of what was observed last stay readable, and keep memory and threads."""
        LanesOwner.close(self)
        self.closed = True

    closed = False
