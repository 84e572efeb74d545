# SPDX-License-Identifier: MIT
"""Under Gymnasium, where it is installed (Debian 12 has none)."""
import sys
import unittest

import support
import bulletnav

try:
    import gymnasium
except ImportError:
    sys.stderr.write("skipped: gymnasium is not installed\n")
    sys.exit(77)


class Registered(unittest.TestCase):
    def test_make(self):
        env = gymnasium.make("bulletnav:ImageNav-v0", **support.ROOM)
        self.assertIsInstance(env.unwrapped, bulletnav.Env)
        self.assertIsInstance(env.unwrapped, gymnasium.Env)
        self.assertIsInstance(env.observation_space, gymnasium.spaces.Dict)
        observation, _ = env.reset(seed=1)
        self.assertIn(observation, env.observation_space)
        env.step(env.action_space.sample())
        env.close()

    def test_make_vec(self):
        envs = gymnasium.make_vec("bulletnav:ImageNav-v0", num_envs=2, **support.ROOM)
        self.assertIsInstance(envs.unwrapped, gymnasium.vector.VectorEnv)
        observations, _ = envs.reset(seed=1)
        self.assertIn(observations, envs.observation_space)
        envs.step(envs.action_space.sample())
        envs.close()

    def test_its_statistics(self):
        env = gymnasium.wrappers.RecordEpisodeStatistics(
            gymnasium.make("bulletnav:ImageNav-v0", **support.ROOM))
        env.reset(seed=1)
        *_, info = env.step(0)
        self.assertEqual(info["episode"]["l"], 1)
        self.assertIn("spl", info["measures"])

    def test_its_checker(self):
        from gymnasium.utils.env_checker import check_env
        check_env(bulletnav.Env(**support.ROOM, copy=True), skip_render_check=True)


if __name__ == "__main__":
    unittest.main()
