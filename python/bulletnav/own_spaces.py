# SPDX-License-Identifier: MIT
"""Spaces for those who have no Gymnasium: what an observation or an action may be.

As Gymnasium's: `space.sample()`, `space.contains(x)` and `x in space`, `space.seed(n)`,
`space.shape`, `space.dtype`, `==`. Samples are numpy arrays where numpy is installed; without it
Box gives nested lists and MultiDiscrete a list.
"""
import random

try:
    import numpy
except ImportError:
    numpy = None


def _dtype(name):
    return name if numpy is None else numpy.dtype(name)


def _nested(shape, make):
    if not shape:
        return make()
    return [_nested(shape[1:], make) for _ in range(shape[0])]


def _numbers(values):
    """All numbers of nested lists."""
    if isinstance(values, (list, tuple)):
        for value in values:
            yield from _numbers(value)
    else:
        yield values


class Space:
    """A set that values can be drawn from."""

    def __init__(self, shape, dtype, seed=None):
        self.shape = shape
        self.dtype = dtype
        self._random = random.Random(seed)

    def seed(self, seed=None):
        """Makes what sample() gives a function of `seed`."""
        self._random = random.Random(seed)
        return seed

    def __contains__(self, x):
        return self.contains(x)


class Discrete(Space):
    """start, start + 1, ..., start + n - 1."""

    def __init__(self, n, seed=None, start=0):
        super().__init__((), _dtype("int64"), seed)
        self.n = n
        self.start = start

    def sample(self):
        value = self.start + self._random.randrange(self.n)
        return value if numpy is None else numpy.int64(value)

    def contains(self, x):
        if getattr(x, "shape", ()) != () or isinstance(x, (bool, float, str)):
            return False
        try:
            return self.start <= int(x) < self.start + self.n and int(x) == x
        except (TypeError, ValueError):
            return False

    def __eq__(self, other):
        return isinstance(other, Discrete) and (self.n, self.start) == (other.n, other.start)

    def __repr__(self):
        return f"Discrete({self.n})" if self.start == 0 else f"Discrete({self.n}, start={self.start})"


class MultiDiscrete(Space):
    """Of each entry i: 0, ..., nvec[i] - 1."""

    def __init__(self, nvec, seed=None):
        super().__init__((len(nvec),), _dtype("int64"), seed)
        self.nvec = list(nvec) if numpy is None else numpy.asarray(nvec, dtype="int64")

    def sample(self):
        values = [self._random.randrange(int(n)) for n in self.nvec]
        return values if numpy is None else numpy.asarray(values, dtype="int64")

    def contains(self, x):
        if hasattr(x, "tolist"):
            x = x.tolist()
        return (isinstance(x, (list, tuple)) and len(x) == len(self.nvec)
                and all(isinstance(v, int) and 0 <= v < n for v, n in zip(x, self.nvec)))

    def __eq__(self, other):
        return isinstance(other, MultiDiscrete) and list(self.nvec) == list(other.nvec)

    def __repr__(self):
        return f"MultiDiscrete({list(map(int, self.nvec))})"


class Box(Space):
    """Arrays of `shape` between `low` and `high`, which are numbers."""

    def __init__(self, low, high, shape, dtype="float32", seed=None):
        super().__init__(tuple(shape), _dtype(dtype), seed)
        self.low = low
        self.high = high

    def _draw(self):
        name = str(self.dtype)
        if "int" in name:
            return self._random.randint(int(self.low), int(self.high))
        low, high = self.low, self.high
        if low == -float("inf") or high == float("inf"):
            if low == high * -1:
                return self._random.gauss(0.0, 1.0)
            wide = self._random.expovariate(1.0)
            return low + wide if high == float("inf") else high - wide
        return self._random.uniform(low, high)

    def sample(self):
        values = _nested(self.shape, self._draw)
        return values if numpy is None else numpy.asarray(values, dtype=self.dtype)

    def contains(self, x):
        if tuple(getattr(x, "shape", ())) != self.shape:
            return False
        if str(getattr(x, "dtype", None)) != str(self.dtype):
            return False
        if numpy is not None:
            x = numpy.asarray(x)
            return bool((x >= self.low).all() and (x <= self.high).all())
        return all(self.low <= value <= self.high for value in _numbers(x.tolist()))

    def __eq__(self, other):
        return (isinstance(other, Box) and str(self.dtype) == str(other.dtype)
                and (self.low, self.high, self.shape) == (other.low, other.high, other.shape))

    def __repr__(self):
        return f"Box({self.low}, {self.high}, {self.shape}, {self.dtype})"


class Dict(Space):
    """Named spaces; values are dicts."""

    def __init__(self, spaces, seed=None):
        super().__init__(None, None, seed)
        self.spaces = dict(spaces)

    def seed(self, seed=None):
        super().seed(seed)
        for space in self.spaces.values():
            space.seed(self._random.getrandbits(32) if seed is not None else None)
        return seed

    def sample(self):
        return {name: space.sample() for name, space in self.spaces.items()}

    def contains(self, x):
        return (isinstance(x, dict) and x.keys() == self.spaces.keys()
                and all(space.contains(x[name]) for name, space in self.spaces.items()))

    def __getitem__(self, name):
        return self.spaces[name]

    def __iter__(self):
        return iter(self.spaces)

    def __len__(self):
        return len(self.spaces)

    def keys(self):
        return self.spaces.keys()

    def values(self):
        return self.spaces.values()

    def items(self):
        return self.spaces.items()

    def __eq__(self, other):
        return isinstance(other, Dict) and self.spaces == other.spaces

    def __repr__(self):
        return f"Dict({', '.join(f'{name!r}: {space}' for name, space in self.spaces.items())})"
