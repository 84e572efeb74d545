# SPDX-License-Identifier: MIT
"""Episodes: dicts in Habitat's form.

{"episode_id", "scene_id", "start_position": [x, y, z], "start_rotation": [x, y, z, w],
 "goals": [{"position", "radius"}], "info": {"geodesic_distance", "difficulty", "goal_rotation",
 "further_goals"}}; metres, y up, positions on the floor.
"""
import json
import os

from bulletnav import _core


def read_episodes(file):
    """Of a file: .json or .json.gz, in Habitat's form or that of image-goal-nav-dataset or NRNS.
    Raises FileError with file, episode and place."""
    return [json.loads(text) for text in _core.read_episodes(os.fspath(file))]


def write_episodes(file, episodes):
    """For VectorEnv(episodes=file); compressed if the name ends in .gz. Raises FileError for an
    episode that lacks something, and for two with one id in a scene."""
    _core.write_episodes(os.fspath(file), json.dumps(list(episodes)))


def draw_episodes(scenes, counts, seed=0, workers=0, **options):
    """Draws start and goals in scenes: `counts` is {"easy", "medium", "hard", "sequential"} over
    all scenes together. The same for the same seed. `options`: sequential_goals, body, navmesh,
    import. Raises Error for a scene that has no such episodes."""
    if isinstance(scenes, (str, os.PathLike)):
        scenes = [scenes]
    config = {"scenes": [os.fspath(scene) for scene in scenes], "counts": counts, "seed": seed,
              "out": "-", **options}
    return [json.loads(text) for text in _core.draw_episodes(json.dumps(config), workers)]
