# SPDX-License-Identifier: MIT
"""Episodes: dicts in Habitat's form.

{"episode_id", "scene_id", "start_position": [x, y, z], "start_rotation": [x, y, z, w],
 "goals": [{"position", "radius"}], "info": {"geodesic_distance", "difficulty", "goal_rotation",
 "further_goals"}}; metres, y up, positions on the floor.
"""
import json
import os

from bulletnav import _core, given

_FILE = "episodes: their file is a name"


def read_episodes(file):
    """Of a file: .json or .json.gz, in Habitat's form or that of image-goal-nav-dataset or NRNS.
    Raises FileError with file, episode and place."""
    return [json.loads(text) for text in _core.read_episodes(given.path(file, _FILE))]


def write_episodes(file, episodes):
    """For VectorEnv(episodes=file); compressed if the name ends in .gz. Raises FileError for an
    episode that lacks something, and for two with one id in a scene."""
    try:
        text = json.dumps(list(episodes))
    except (TypeError, ValueError):
        raise _core.Error("bulletnav episodes: they are dicts of plain values, as read_episodes "
                          f"returns them, not {episodes!r:.80}") from None
    _core.write_episodes(given.path(file, _FILE), text)


def draw_episodes(scenes, counts, seed=0, workers=0, **options):
    """Draws start and goals in scenes: `counts` is {"easy", "medium", "hard", "sequential"} over
    all scenes together. The same for the same seed. `options`: sequential_goals, body, navmesh,
    import_. Raises Error for a scene that has no such episodes."""
    if isinstance(scenes, (str, os.PathLike)) or not hasattr(scenes, "__iter__"):
        scenes = [scenes]
    scenes = [given.path(scene, "draw_episodes: a scene is a file's name") for scene in scenes]
    config = given.config({"scenes": scenes, "counts": counts, "seed": seed, "out": "-", **options},
                          "draw_episodes")
    workers = given.whole(workers, "draw_episodes: workers is a whole number")
    return [json.loads(text) for text in _core.draw_episodes(config, workers)]
