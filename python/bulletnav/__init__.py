# SPDX-License-Identifier: MIT
"""BulletNav: embodied navigation in 3D scenes, for Python.

    import bulletnav
    scenes = bulletnav.generate("houses", count=3)
    envs = bulletnav.VectorEnv(scenes=scenes, num_envs=8)
    observations, info = envs.reset(seed=0)
    for _ in range(100):
        observations, rewards, terminated, truncated, info = envs.step(envs.action_space.sample())
"""
from bulletnav import built_for as _built_for

_built_for.require()

from bulletnav import spaces
from bulletnav._core import Array, Error, FileError, PoseError, RenderError, __version__
from bulletnav.actions import Action
from bulletnav.env import Env
from bulletnav.episodes import draw_episodes, read_episodes, write_episodes
from bulletnav.houses import generate
from bulletnav.results import measures, read_results, read_trajectory
from bulletnav.scene import Scene
from bulletnav.vector_env import AutoresetMode, VectorEnv

__all__ = [
    "Action", "Array", "AutoresetMode", "Env", "Error", "FileError", "PoseError", "RenderError",
    "Scene", "VectorEnv", "__version__", "draw_episodes", "generate", "measures", "read_episodes",
    "read_results", "read_trajectory", "spaces", "write_episodes",
]


def _register():
    """gymnasium.make("bulletnav:ImageNav-v0", scenes=[...]) and gymnasium.make_vec."""
    try:
        from gymnasium.envs.registration import register, registry
    except ImportError:
        return
    if "ImageNav-v0" not in registry:
        register("ImageNav-v0", entry_point="bulletnav.env:Env",
                 vector_entry_point="bulletnav.vector_env:VectorEnv", kwargs={"copy": True})


_register()
