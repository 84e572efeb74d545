# SPDX-License-Identifier: MIT
"""One body, and what is there without numpy and Gymnasium."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

import support
import bulletnav


class Playing(unittest.TestCase):
    def test_an_episode(self):
        with bulletnav.Env(**support.ROOM) as env:
            observation, info = env.reset(seed=1)
            self.assertEqual(tuple(observation["panorama.color"].shape), (16, 64, 3))
            self.assertTrue(env.observation_space.contains(observation))
            self.assertIn(env.action_space.sample(), env.action_space)
            for step in range(1, 9):
                observation, reward, terminated, truncated, info = env.step(2)
                self.assertIs(type(reward), float)
                self.assertEqual((terminated, truncated), (False, step == 8))
            self.assertEqual(info["measures"]["steps"], 8)
            with self.assertRaisesRegex(bulletnav.Error, "reset it first"):
                env.step(1)
            first = env.episode()
            env.reset()
            self.assertNotEqual(env.episode(), first)
            env.reset(seed=1)
            self.assertEqual(env.episode(), first)
            self.assertGreater(env.truth()["distance"], 1.0)

    def test_is_a_lane_of_a_vector(self):
        env = bulletnav.Env(**support.ROOM)
        envs = bulletnav.VectorEnv(num_envs=1, **support.ROOM)
        one, _ = env.reset(seed=5)
        many, _ = envs.reset(seed=5)
        for action in (1, 2, 1, 1):
            reward = env.step(action)[1]
            self.assertEqual(reward, envs.step([action])[1][0])
            self.assertEqual(bytes(memoryview(one["panorama.color"])),
                             bytes(memoryview(many["panorama.color"])))

    def test_misuse(self):
        with self.assertRaisesRegex(bulletnav.Error, "VectorEnv"):
            bulletnav.Env(num_envs=2, **support.ROOM)
        env = bulletnav.Env(**support.ROOM, render_mode="rgb_array")
        with self.assertRaisesRegex(bulletnav.Error, "call reset first"):
            env.step(1)
        env.reset()
        with self.assertRaises(bulletnav.Error):
            env.step([1])
        with self.assertRaises(bulletnav.Error):
            env.reset(options={"x": 1})
        self.assertEqual(tuple(bulletnav.arrays.copy(env.arrays["panorama.color"]).shape),
                         tuple(env.render().shape))
        env.close()
        with self.assertRaisesRegex(bulletnav.Error, "it is closed"):
            env.render()


class WrongPython(unittest.TestCase):
    def test_is_told_in_a_line(self):
        from bulletnav import built_for
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            with self.assertRaisesRegex(ImportError, "has no extension"):
                built_for.require(folder, ".cpython-39.so")
            (folder / "_core.cpython-38.so").touch()
            built_for.require(folder, ".cpython-38.so")
            with self.assertRaises(ImportError) as caught:
                built_for.require(folder, ".cpython-39.so")
        said = str(caught.exception)
        self.assertIn("is built for cpython-38", said)
        self.assertIn("./bulletnav python", said)
        self.assertEqual(len(said.splitlines()), 1)


class WithoutPackages(unittest.TestCase):
    def test_it_works_without_numpy(self):
        script = """
import sys
sys.modules["numpy"] = sys.modules["gymnasium"] = None  # As if they were not installed.
sys.path.insert(0, sys.argv[1])
import support, bulletnav
envs = bulletnav.VectorEnv(num_envs=2, **support.ROOM)
observations, _ = envs.reset(seed=0)
assert envs.observation_space.contains(observations), observations
for _ in range(12):
    observations, rewards, terminated, truncated, info = envs.step(envs.action_space.sample())
    assert isinstance(rewards, list) and isinstance(terminated[0], bool)
assert type(observations["panorama.depth"]) is bulletnav.Array
env = bulletnav.Env(**support.ROOM)
env.reset()
env.step(env.action_space.sample())
assert envs.single_observation_space["odometry.motion"].sample()
assert "torch" not in sys.modules
print("played")
"""
        folder = support.__file__.rsplit("/", 1)[0]
        done = subprocess.run([sys.executable, "-c", script, folder], capture_output=True,
                              text=True)
        self.assertEqual((done.stdout, done.stderr), ("played\n", ""))

    def test_spaces(self):
        from bulletnav import own_spaces
        for space in (own_spaces.Discrete(4), own_spaces.MultiDiscrete([4, 2]),
                      own_spaces.Box(0, 255, (2, 3), "uint8"),
                      own_spaces.Box(-float("inf"), float("inf"), (3,), "float64"),
                      own_spaces.Dict({"a": own_spaces.Discrete(2, start=5)})):
            space.seed(3)
            first = space.sample()
            self.assertIn(first, space)
            self.assertEqual(space, space)
            space.seed(3)
            self.assertEqual(str(space.sample()), str(first))
        self.assertNotIn(4, own_spaces.Discrete(4))
        self.assertNotIn(1.0, own_spaces.Discrete(4))
        self.assertNotEqual(own_spaces.Discrete(4), own_spaces.Discrete(5))


if __name__ == "__main__":
    unittest.main()
