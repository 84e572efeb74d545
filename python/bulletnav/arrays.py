# SPDX-License-Identifier: MIT
"""Between the extension's arrays and what Python works with."""
from bulletnav import spaces

try:
    import numpy
except ImportError:
    numpy = None


def view(array):
    """A numpy array of the same memory; the Array itself where there is no numpy."""
    return array if numpy is None else numpy.asarray(array)


def copy(array):
    """A numpy array of its own; a list where there is no numpy."""
    return array.tolist() if numpy is None else numpy.array(array)


def copied(array):
    """As view, of memory of its own."""
    return array.copy() if numpy is None else numpy.array(array)


def filled(count, value):
    """`count` times `value`: a numpy array (of objects where it is None), or a list."""
    return [value] * count if numpy is None else numpy.full(count, value)


def space(array, max_depth_m, shape):
    """The values that an array of the environment may hold."""
    if array.dtype == "uint8":
        high = 1 if array.name.endswith(".collided") else 255
        return spaces.Box(0, high, shape, _dtype(array))
    if array.name in ("panorama.depth", "goal.depth"):
        return spaces.Box(0.0, max_depth_m, shape, _dtype(array))
    low = 0.0 if array.name.endswith(".depth") else -float("inf")
    return spaces.Box(low, float("inf"), shape, _dtype(array))


def _dtype(array):
    return array.dtype if numpy is None else numpy.dtype(array.dtype).type
