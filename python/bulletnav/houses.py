# SPDX-License-Identifier: MIT
"""Scenes where there are none."""
import os

from bulletnav import _core


def generate(folder, count=3, first_seed=0, workers=0):
    """Furnished houses house_000.glb, ... in `folder`, made if they are not there yet.

    The same seed gives the same house on every machine; house i has the seed first_seed + i.
    `workers`: threads, 0 for one per processor. A house takes some seconds.
    Returns their files, for VectorEnv(scenes=...). Raises FileError if the folder holds others.
    """
    return _core.generate(os.fspath(folder), count, first_seed, workers)
