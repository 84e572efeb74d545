# SPDX-License-Identifier: MIT
"""What runs of ./bulletnav run have left."""
import json
import os

from bulletnav import _core, given


def read_results(folder):
    """All episodes of a run, also while it goes on: a list of dicts with "agent", "setting",
    "condition", "seed", "scene", "episode", "difficulty", "failure" and the measures by name, or
    "goals": a list of them where an episode has several. Infinite distances are None. Raises
    FileError at the line that is damaged."""
    folder = given.path(folder, "read_results: the folder of a run is a name")
    if not os.path.isdir(folder):
        raise _core.FileError(f"{folder}: no such folder; name one that ./bulletnav run "
                              "has written")
    return [json.loads(line) for line in _core.read_results(folder)]


def read_trajectory(file):
    """One file below a run's trajectories/: every action and pose of an episode, and what the
    agent believed. Its keys are told in benchmark/play/trajectory.h. Raises FileError."""
    file = given.path(file, "read_trajectory: a trajectory is a file's name")
    return json.loads(_core.read_trajectory(file))


def measures():
    """What is measured of every goal: [{"name": key in results, "label", "column"}]."""
    return _core.measures()
