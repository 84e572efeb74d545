# SPDX-License-Identifier: MIT
"""Many bodies in a room: what they see, how they end, what misuse gets."""
import os
import threading
import unittest

import support
import bulletnav
from bulletnav import Action, VectorEnv

try:
    import numpy
except ImportError:
    numpy = None

FORWARD = [1, 1, 1]


def make(**options):
    return VectorEnv(**{**support.ROOM, "num_envs": 3, **options})


def seen(observations, name="panorama.depth"):
    return bytes(memoryview(observations[name]))


class Stepping(unittest.TestCase):
    def test_observations_are_in_their_space(self):
        envs = make()
        observations, info = envs.reset(seed=1)
        self.assertEqual(info, {})
        self.assertEqual(set(observations), {"panorama.color", "panorama.depth", "goal.color",
                                             "goal.depth", "odometry.motion", "bumper.collided"})
        self.assertEqual(tuple(observations["panorama.color"].shape), (3, 16, 64, 3))
        self.assertTrue(envs.observation_space.contains(observations))
        self.assertIn(envs.action_space.sample(), envs.action_space)
        observations, rewards, terminated, truncated, info = envs.step(FORWARD)
        self.assertTrue(envs.observation_space.contains(observations))
        self.assertEqual([len(x) for x in (rewards, terminated, truncated)], [3, 3, 3])
        self.assertEqual(info, {})

    def test_the_same_seed_and_actions_give_the_same(self):
        def walk(seed, threads):
            envs = make(threads=threads)
            trace = [seen(envs.reset(seed=seed)[0])]
            for _ in range(5):
                observations, rewards, *_ = envs.step(FORWARD)
                trace += [seen(observations), list(rewards)]
            return trace

        self.assertEqual(walk(1, 1), walk(1, 2))
        self.assertNotEqual(walk(1, 1), walk(2, 1))

    def test_observations_are_views_of_one_memory(self):
        envs = make()
        first, _ = envs.reset(seed=0)
        before = seen(first)
        second, *_ = envs.step(FORWARD)
        self.assertNotEqual(before, seen(first))
        self.assertEqual(seen(first), seen(second))
        array = envs.arrays["panorama.depth"]
        self.assertEqual((array.dtype, array.units, array.nbytes), ("float32", "m", 3 * 16 * 64 * 4))
        self.assertEqual(array[1].tolist(), array.tolist()[1])
        self.assertEqual(array[1, 2, 3], array.tolist()[1][2][3])
        self.assertEqual(array[1:].shape, (2, 16, 64))
        envs.close()
        del envs
        self.assertEqual(len(array.tolist()), 3)  # The view keeps the memory.

    @unittest.skipIf(numpy is None, "needs python3-numpy")
    def test_numpy_and_dlpack_look_at_the_same_bytes(self):
        envs = make()
        observations, _ = envs.reset(seed=0)
        array = envs.arrays["panorama.depth"]
        seen_by_numpy = observations["panorama.depth"]
        self.assertIsInstance(seen_by_numpy, numpy.ndarray)
        self.assertEqual(seen_by_numpy.dtype, numpy.float32)
        by_dlpack = numpy.from_dlpack(array)
        self.assertTrue(numpy.shares_memory(by_dlpack, seen_by_numpy))
        envs.step(FORWARD)
        self.assertTrue((by_dlpack == seen_by_numpy).all())
        array.__dlpack__()  # Nobody takes it: it is freed.
        self.assertIn("dltensor", repr(array.__dlpack__(stream=None, max_version=(1, 0),
                                                        dl_device=(1, 0), copy=False)))

        class Copying:
            def __dlpack__(self, stream=None):
                return array.__dlpack__(copy=True)

            def __dlpack_device__(self):
                return array.__dlpack_device__()

        copied = numpy.from_dlpack(Copying())
        self.assertFalse(numpy.shares_memory(copied, seen_by_numpy))
        self.assertTrue((copied == seen_by_numpy).all())
        with self.assertRaisesRegex(BufferError, "CPU"):
            array.__dlpack__(dl_device=(2, 0))
        envs.step(numpy.array(FORWARD))
        envs.step([numpy.int64(1), Action.TURN_LEFT, 1])

    def test_copies(self):
        for options, is_kept in (({}, False), ({"copy": True}, True)):
            envs = make(**options)
            first, _ = envs.reset(seed=numpy.int64(3) if numpy else 3)
            before = seen(first)
            later = envs.step([1, 2, 3])[0]
            self.assertEqual(seen(first) == before, is_kept)
            self.assertNotEqual(seen(later), before)
            self.assertTrue(envs.observation_space.contains(later))
        with self.assertRaisesRegex(bulletnav.Error, "whole number"):
            envs.reset(seed=1.5)

    def test_episodes_end_with_their_measures(self):
        envs = make()
        envs.reset(seed=0)
        *_, terminated, truncated, info = envs.step([0, 1, 0])
        self.assertEqual((list(terminated), list(truncated)), ([True, False, True], [False] * 3))
        self.assertEqual(list(info["_measures"]), [True, False, True])
        self.assertEqual(list(info["measures"]["success"]), [0, 0, 0])
        for column in info["measures"].values():
            self.assertEqual(len({type(value) for value in column}), 1)
        self.assertGreater(info["measures"]["distance_to_goal"][2], 1.0)
        self.assertEqual([bool(facts) for facts in info["results"]], [True, False, True])
        self.assertEqual(list(info["_results"]), [True, False, True])
        self.assertEqual(info["results"][0]["difficulty"], "easy")
        *_, terminated, truncated, info = envs.step([0, 1, 1])
        self.assertEqual((list(terminated), info), ([False] * 3, {}))  # Begun anew meanwhile.
        for _ in range(8):
            *_, truncated, info = envs.step(FORWARD)
        self.assertTrue(any(truncated))

    def test_cameras_can_be_noisy(self):
        clean, _ = make().reset(seed=0)
        noisy, _ = make(sensor_noise="depth_camera").reset(seed=0)
        again, _ = make(sensor_noise="depth_camera", threads=1).reset(seed=0)
        for name in ("panorama.color", "panorama.depth", "goal.color"):
            self.assertFalse((clean[name] == noisy[name]).all(), name)
            self.assertTrue((again[name] == noisy[name]).all(), name)

    def test_the_goal_can_be_reached(self):
        """By the truth: turn to it on the straight line, go, stop."""
        import math
        envs = make(noise="none", max_steps=100)
        envs.reset(seed=0)
        for _ in range(100):
            actions = []
            for lane in range(3):
                truth = envs.truth(lane)
                (x, _, z, yaw), (gx, _, gz, _) = truth["pose"], truth["goal"]
                off = math.remainder(math.atan2(x - gx, z - gz) - yaw, 2 * math.pi)
                turn = Action.TURN_LEFT if off > 0 else Action.TURN_RIGHT
                there = truth["distance"] < 0.8
                actions.append(Action.STOP if there else
                               Action.MOVE_FORWARD if abs(off) < 0.1 else turn)
            *_, info = envs.step(actions)
            if info:
                break
        lane = list(info["_results"]).index(True)
        self.assertTrue(info["results"][lane]["success"])
        self.assertGreater(info["results"][lane]["spl"], 0.9)

    def test_autoreset_modes(self):
        envs = make(autoreset_mode="same_step")
        envs.reset(seed=0)
        first = envs.episode(0)
        *_, terminated, _, _ = envs.step([0, 1, 1])
        self.assertTrue(terminated[0])
        self.assertNotEqual(envs.episode(0), first)
        envs = make(autoreset_mode=bulletnav.AutoresetMode.DISABLED)
        envs.reset(seed=0)
        envs.step([0, 1, 1])
        with self.assertRaisesRegex(bulletnav.Error, "lane 0 is over; reset it"):
            envs.step(FORWARD)
        envs.reset(options={"reset_mask": [True, False, False]})
        envs.step(FORWARD)
        self.assertEqual(envs.metadata["autoreset_mode"], bulletnav.AutoresetMode.DISABLED)

    def test_what_is_sent_is_received(self):
        envs, other = make(), make()
        envs.reset(seed=3)
        other.reset(seed=3)
        envs.send(FORWARD)
        with self.assertRaisesRegex(bulletnav.Error, "call recv first"):
            envs.step(FORWARD)
        observations, rewards, *_, info = envs.recv()
        expected, expected_rewards, *_ = other.step(FORWARD)
        self.assertEqual(seen(observations), seen(expected))
        self.assertEqual((list(rewards), info["lanes"]), (list(expected_rewards), range(0, 3)))
        envs.send([1, 1], lanes=range(1, 3))
        observations, rewards, *_, info = envs.recv()
        expected, *_ = other.step(FORWARD)
        self.assertEqual((len(rewards), info["lanes"]), (2, range(1, 3)))
        self.assertEqual(seen(observations), seen({"panorama.depth": expected["panorama.depth"][1:]}))
        with self.assertRaisesRegex(bulletnav.Error, "nothing was sent"):
            envs.recv()
        envs.send(FORWARD)
        envs.close()  # Waits.

    def test_sensors_of_ones_own(self):
        envs = make(sensors={"panorama": {"type": "panorama", "rows": 8, "cols": 32,
                                          "channels": ["depth"]},
                             "front": {"type": "pinhole", "rows": 12, "cols": 16}})
        observations, _ = envs.reset()
        self.assertEqual(set(observations), {"panorama.depth", "front.color", "front.depth",
                                             "goal.depth"})
        self.assertEqual(tuple(observations["front.color"].shape), (3, 12, 16, 3))

    def test_render(self):
        envs = make(render_mode="rgb_array")
        envs.reset(seed=0)
        frames = envs.render()
        self.assertEqual(len(frames), 3)
        self.assertIsNone(make().render())


class Misuse(unittest.TestCase):
    def test_is_answered_in_one_line(self):
        cases = [
            ({"scenes": []}, "scenes=.FILE"),
            ({"episodes": "x.json"}, "not both"),
            ({"scenes": ["nowhere.glb"]}, "nowhere.glb"),
            ({"num_envs": 0}, "num_envs must lie"),
            ({"num_env": 2}, "did you mean|num_envs"),
            ({"noise": "loud"}, "ans_released"),
            ({"sensor_noise": "loud"}, "phone_camera"),
            ({"sensors": "xyz"}, "xyz"),
            ({"sensors": {"front": "pinhole"}}, "the goal is a panorama"),
            ({"body": {"radius": -1}}, "radius"),
            ({"reward": {"success": "much"}}, "much"),
            ({"max_steps": 0}, "max_steps"),
            ({"render_mode": "human"}, "rgb_array"),
            ({"autoreset_mode": object()}, "cannot be an argument"),
            ({"counts": {"hard": -3}}, "each count"),
        ]
        for options, expected in cases:
            with self.subTest(options), self.assertRaisesRegex(bulletnav.Error, expected) as caught:
                make(**options)
            self.assertNotIn("\n", str(caught.exception))
            self.assertNotIn("arguments:", str(caught.exception))

    def test_of_actions(self):
        envs = make()
        with self.assertRaisesRegex(bulletnav.Error, "call reset first"):
            envs.step(FORWARD)
        with self.assertRaisesRegex(bulletnav.Error, "call reset first"):
            envs.episode(0)
        envs.reset()
        for actions in ([1, 1], [1, 1, 4], [1, 1, -1], [1, 1, 1.5], 1, None, "abc", [[1, 1, 1]],
                        [2**70, 1, 1]):
            with self.subTest(actions), self.assertRaises(bulletnav.Error):
                envs.step(actions)
        for lanes in ([0, 2, 1], [0, 2], [], [5], [-1]):
            with self.subTest(lanes), self.assertRaises(bulletnav.Error):
                envs.send([1] * len(lanes), lanes)
        with self.assertRaisesRegex(bulletnav.Error, "no lane 3"):
            envs.episode(3)
        for options in ({"mask": 1}, {"reset_mask": [True]}):
            with self.assertRaises(bulletnav.Error):
                envs.reset(options=options)
        with self.assertRaises(bulletnav.Error):
            envs.reset(seed=[1, 2, 3])
        envs.step(FORWARD)  # Nothing was hurt.

    def test_after_close(self):
        envs = make()
        envs.reset()
        envs.close()
        envs.close()
        for call in (envs.reset, envs.recv, lambda: envs.step(FORWARD), lambda: envs.truth(0)):
            with self.assertRaisesRegex(bulletnav.Error, "it is closed"):
                call()

    def test_after_a_fork(self):
        envs = make(threads=2)
        envs.reset()
        child = os.fork()
        if child == 0:
            status = 1
            try:
                envs.step(FORWARD)
            except bulletnav.Error as error:
                status = 0 if "process that made it" in str(error) else 2
                envs.close()
                del envs
            os._exit(status)
        self.assertEqual(os.waitpid(child, 0)[1], 0)
        envs.step(FORWARD)

    def test_from_two_threads(self):
        """The lock is let go while stepping, so that others run; one at a time may step."""
        envs = make(sensors="rgbd", num_envs=8)
        envs.reset()
        outcomes = []

        def step():
            while len(outcomes) < 2000 and set(outcomes) <= {"stepped"}:  # Until they meet.
                try:
                    envs.step([1] * 8)
                    outcomes.append("stepped")
                except bulletnav.Error as error:
                    outcomes.append(str(error))

        threads = [threading.Thread(target=step) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        others = {o for o in outcomes if o != "stepped"}
        self.assertIn("stepped", outcomes)
        self.assertEqual(len(others), 1, others)  # They met, and were told so.
        self.assertIn("another thread", others.pop())


if __name__ == "__main__":
    unittest.main()
