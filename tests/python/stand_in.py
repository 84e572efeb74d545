# SPDX-License-Identifier: MIT
"""A stand-in for Gymnasium 1.x, by its documentation, where it is not installed: what the module
subclasses and calls, with the checks that Gymnasium's own classes make of their arguments."""
import enum
import sys
import types

import numpy


class Env:
    metadata = {"render_modes": []}
    render_mode = None
    spec = None
    _np_random = None

    def reset(self, *, seed=None, options=None):
        if seed is not None:
            if not isinstance(seed, int) or seed < 0:
                raise TypeError(f"seed {seed!r}")
            self._np_random = numpy.random.default_rng(seed)

    @property
    def unwrapped(self):
        return self


class AutoresetMode(enum.Enum):
    NEXT_STEP = "NextStep"
    SAME_STEP = "SameStep"
    DISABLED = "Disabled"


class VectorEnv(Env):
    closed = False


class Space:
    def __init__(self, shape, dtype):
        self.shape, self.dtype = shape, None if dtype is None else numpy.dtype(dtype)
        self.random = numpy.random.default_rng(0)

    def __contains__(self, value):
        return self.contains(value)


class Box(Space):
    def __init__(self, low, high, shape, dtype):
        super().__init__(tuple(map(int, shape)), dtype)
        for bound in (low, high):  # Bounds must be exact in the type.
            assert numpy.isinf(bound) or self.dtype.type(bound) == bound, (bound, dtype)
        self.low, self.high = numpy.full(shape, low, dtype), numpy.full(shape, high, dtype)

    def contains(self, value):
        return bool(isinstance(value, numpy.ndarray) and numpy.can_cast(value.dtype, self.dtype)
                    and value.shape == self.shape and (value >= self.low).all()
                    and (value <= self.high).all())


class Discrete(Space):
    def __init__(self, n):
        super().__init__((), numpy.int64)
        self.n = n

    def sample(self):
        return self.random.integers(self.n)

    def contains(self, value):
        return isinstance(value, (int, numpy.integer)) and 0 <= value < self.n


class MultiDiscrete(Space):
    def __init__(self, nvec):
        self.nvec = numpy.array(nvec, dtype=numpy.int64)
        super().__init__(self.nvec.shape, numpy.int64)

    def sample(self):
        return self.random.integers(self.nvec)

    def contains(self, value):
        return value.shape == self.shape and bool(((0 <= value) & (value < self.nvec)).all())


class Dict(Space):
    def __init__(self, spaces):
        super().__init__(None, None)
        assert all(isinstance(space, Space) for space in spaces.values())
        self.spaces = dict(sorted(spaces.items()))

    def contains(self, value):
        return (isinstance(value, dict) and value.keys() == self.spaces.keys()
                and all(value[name] in space for name, space in self.spaces.items()))


REGISTRY = {}


def register(id, entry_point=None, vector_entry_point=None, kwargs=None):  # noqa: A002
    REGISTRY[id] = types.SimpleNamespace(entry_point=entry_point, kwargs=kwargs or {},
                                         vector_entry_point=vector_entry_point)


def install():
    """Makes `import gymnasium` find this."""

    def module(name, **content):
        made = sys.modules[name] = types.ModuleType(name)
        vars(made).update(content)
        return made

    spaces = module("gymnasium.spaces", Box=Box, Dict=Dict, Discrete=Discrete,
                    MultiDiscrete=MultiDiscrete, Space=Space)
    vector = module("gymnasium.vector", VectorEnv=VectorEnv, AutoresetMode=AutoresetMode)
    registration = module("gymnasium.envs.registration", register=register, registry=REGISTRY)
    envs = module("gymnasium.envs", registration=registration)
    module("gymnasium", Env=Env, spaces=spaces, vector=vector, envs=envs)
