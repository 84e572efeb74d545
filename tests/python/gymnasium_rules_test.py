# SPDX-License-Identifier: MIT
"""The rules that Gymnasium's documentation and its checker of environments have for both classes,
over a stand-in for its classes; gymnasium_test.py takes the real one where there is one."""
import importlib
import sys
import unittest

import support

try:
    import numpy
except ImportError:
    sys.stderr.write("skipped: needs python3-numpy\n")
    sys.exit(77)
import stand_in

stand_in.install()
import bulletnav  # noqa: E402


def make(vector=False, **options):
    """As gymnasium.make and make_vec: an entry point with the registered arguments."""
    spec = stand_in.REGISTRY["ImageNav-v0"]
    module, name = (spec.vector_entry_point if vector else spec.entry_point).split(":")
    entry = getattr(importlib.import_module(module), name)
    if vector:
        options.setdefault("num_envs", 3)
    env = entry(**{**spec.kwargs, **support.ROOM, **options})
    env.unwrapped.spec = spec
    return env


class Rules(unittest.TestCase):
    def check_info(self, info, is_over):
        self.assertIs(type(info), dict)
        self.assertEqual(bool(info), is_over)
        self.assertNotIn("episode", info)  # the wrapper RecordEpisodeStatistics wants it free
        for name in info:
            self.assertIsInstance(name, str)

    def test_classes(self):
        self.assertIsInstance(make(), stand_in.Env)
        envs = make(vector=True)
        self.assertIsInstance(envs, stand_in.VectorEnv)
        self.assertIs(envs.metadata["autoreset_mode"], stand_in.AutoresetMode.NEXT_STEP)
        same = make(vector=True, autoreset_mode=stand_in.AutoresetMode.SAME_STEP)
        self.assertIs(same.metadata["autoreset_mode"], stand_in.AutoresetMode.SAME_STEP)

    def test_reset_and_step_of_one(self):
        env = make(render_mode="rgb_array")
        self.assertIs(env.unwrapped, env)
        self.assertIsInstance(env.action_space, stand_in.Discrete)
        first, info = env.reset(seed=123)
        self.check_info(info, is_over=False)
        self.assertIn(first, env.observation_space)
        state = env._np_random.bit_generator.state
        again, _ = env.reset(seed=123)
        self.assertEqual(env._np_random.bit_generator.state, state)
        for name, array in first.items():  # data of their own, and the same
            self.assertFalse(numpy.shares_memory(array, again[name]))
            numpy.testing.assert_array_equal(array, again[name])
        env.reset(seed=456)
        self.assertNotEqual(env._np_random.bit_generator.state, state)
        env.reset(options={})
        for step in range(1, 9):
            observation, reward, terminated, truncated, info = env.step(numpy.int64(2))
            self.assertIn(observation, env.observation_space)
            self.assertIsInstance(reward, float)
            self.assertTrue(numpy.isfinite(reward))
            self.assertIsInstance(terminated, bool)
            self.assertIsInstance(truncated, bool)
            self.check_info(info, is_over=step == 8)
        picture = env.render()
        self.assertEqual((picture.dtype, picture.ndim, picture.shape[2]), (numpy.uint8, 3, 3))
        self.assertIn("rgb_array", env.metadata["render_modes"])
        self.assertGreater(env.metadata["render_fps"], 0)
        env.close()
        env.close()

    def test_many(self):
        envs = make(vector=True)
        single, batch = envs.single_observation_space, envs.observation_space
        self.assertEqual(single.spaces.keys(), batch.spaces.keys())
        for name, space in single.spaces.items():
            self.assertEqual(batch.spaces[name].shape, (3, *space.shape))
            self.assertEqual(batch.spaces[name].dtype, space.dtype)
        observations, info = envs.reset(seed=1)
        self.assertIn(observations, batch)
        self.check_info(info, is_over=False)
        for step in range(1, 9):
            actions = envs.action_space.sample() % 2 + 2
            observations, rewards, terminated, truncated, info = envs.step(actions)
            self.assertIn(observations, batch)
            for array, kind in ((rewards, "f"), (terminated, "b"), (truncated, "b")):
                self.assertEqual((array.shape, array.dtype.kind), ((3,), kind))
            self.check_info(info, is_over=step == 8)
        for name, value in info.items():  # each with its mask, as in every vector environment
            if not name.startswith("_"):
                self.assertEqual(list(info[f"_{name}"]), [True] * 3)
                for array in value.values() if isinstance(value, dict) else [value]:
                    self.assertEqual(array.shape, (3,))
        envs.step(envs.action_space.sample())  # begins the next episodes
        envs.close()
        self.assertTrue(envs.closed)

    def test_lanes_are_reset_by_a_mask(self):
        envs = make(vector=True, autoreset_mode="disabled")
        envs.reset(seed=1)
        envs.step([0, 1, 0])
        observations, _ = envs.reset(options={"reset_mask": numpy.array([True, False, True])})
        self.assertIn(observations, envs.observation_space)
        envs.step([1, 1, 1])


if __name__ == "__main__":
    unittest.main()
