# SPDX-License-Identifier: MIT
"""Scenes where there are none."""
from bulletnav import _core, given


def generate(folder="houses", count=3, first_seed=0, workers=0, kind=None):
    """Furnished houses house_000.glb, ... in `folder`, made if they are not there yet.

    Mind the order: the first argument is where they go, the second how many.
    `kind`: "home", "clinic", "hotel", "loft", "office", "school", "shop", "warehouse" or
    "workshop"; files are KIND_000.glb, ... then. None: homes as they are made without a kind, which
    are others than those of "home". A folder holds what one call has made: take one for each.
    The same seed gives the same house on every machine; house i has the seed first_seed + i.
    `workers`: threads, 0 for one per processor. A house takes some seconds.
    Returns their files, for VectorEnv(scenes=...). Raises FileError if the folder holds others.
    """
    folder = given.path(folder, "generate: the first argument is the folder to write to, as "
                        "generate('houses', count=3)")
    count = given.whole(count, "generate: count is a whole number")
    first_seed = given.seed(first_seed, "generate")
    workers = given.whole(workers, "generate: workers is a whole number")
    if kind is not None and (not isinstance(kind, str) or not kind):
        raise _core.Error("bulletnav generate: kind is a word, as 'office', or None, "
                          f"not {kind!r}")
    return _core.generate(folder, count, first_seed, workers, kind or "")
