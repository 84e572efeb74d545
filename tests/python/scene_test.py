# SPDX-License-Identifier: MIT
"""Scenes, episodes and results from Python."""
import json
import math
import os
import pathlib
import shutil
import tempfile
import unittest

import support
import bulletnav

# A room of 4 x 6 m, x from 0 to 4, z from -6 to 0, 3 m high.


class Looking(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scene = bulletnav.Scene(support.SCENE, backend="embree")

    def test_depth_is_that_of_the_room(self):
        camera = {"type": "pinhole", "rows": 9, "cols": 17, "hfov_deg": 60}
        seen = self.scene.render([[2, 1.5, -3, 0], [2, 1.5, -3, math.pi / 2]], camera)
        depth = memoryview(seen["depth"])
        self.assertEqual(depth.shape, (2, 9, 17))
        self.assertAlmostEqual(depth[0, 4, 8], 3.0, places=4)  # To the wall at z = -6,
        self.assertAlmostEqual(depth[1, 4, 8], 2.0, places=4)  # to that at x = 0.
        self.assertEqual(memoryview(seen["color"]).shape, (2, 9, 17, 3))
        one = self.scene.render([2, 1.5, -3, 0])
        self.assertEqual(memoryview(one["depth"]).shape, (128, 512))

    def test_ways_are_those_of_the_room(self):
        self.assertAlmostEqual(self.scene.distance([1, 0, -1], [1, 0, -5]), 4.0, places=2)
        metres, points = self.scene.path([1, 0, -1], [3, 0, -1])
        self.assertAlmostEqual(metres, 2.0, places=2)
        self.assertEqual(len(points), 2)
        self.assertAlmostEqual(self.scene.snap([2, 0.5, -3])[0], 2.0, places=3)
        self.assertIsNone(self.scene.snap([50, 0, 0]))
        self.assertEqual(self.scene.distance([50, 0, 0], [1, 0, -1]), math.inf)
        self.assertIsNone(self.scene.path([50, 0, 0], [1, 0, -1]))
        self.assertEqual((self.scene.island([2, 0, -3]), self.scene.island([50, 0, 0])), (0, None))
        self.assertGreater(self.scene.islands[0]["area"], 20.0)

    def test_random_points_are_of_their_seed(self):
        points = self.scene.random_points(5, seed=3)
        self.assertEqual(points, self.scene.random_points(5, seed=3))
        self.assertNotEqual(points, self.scene.random_points(5, seed=4))
        self.assertTrue(all(0 < x < 4 and -6 < z < 0 for x, _, z in points))

    def test_what_is_drawn_grey_is_warned_of(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "room.mtl").write_text("newmtl m\nmap_Kd gone.png\n")
            scene = folder / "room.obj"
            scene.write_text("mtllib room.mtl\nusemtl m\nv 0 0 0\nv 4 0 0\nv 4 0 -6\nv 0 0 -6\n"
                             "v 0 3 0\nv 4 3 0\nf 1 2 3 4\nf 1 2 6 5\n")
            with self.assertWarnsRegex(UserWarning, "drawn grey: 1 of 1 texture, as gone.png"):
                bulletnav.Scene(scene, backend="embree")
            with self.assertWarnsRegex(UserWarning, "drawn grey: 1 of 1 texture, as gone.png"):
                env = bulletnav.VectorEnv(scenes=[str(scene)], num_envs=1, threads=1,
                                          backend="embree", counts={"easy": 2})
                env.reset(seed=0)
                env.close()

    def test_doors_that_nobody_knows_are_none(self):
        scene = bulletnav.Scene(support.SCENE, backend="embree", import_={"doors": "as_built"})
        self.assertEqual(scene.doors, [])

    def test_misuse(self):
        nan = float("nan")
        for call in (lambda: bulletnav.Scene("nowhere.glb"),
                     lambda: bulletnav.Scene(support.SCENE, backend="x"),
                     lambda: self.scene.random_points(1, island=7),
                     lambda: self.scene.random_points(-1),
                     lambda: self.scene.random_points("many"),
                     lambda: self.scene.path("there", [0, 0, 0]),
                     lambda: self.scene.path([0, 0, 0], None),
                     lambda: self.scene.distance([0, 0], [0, 0, 0]),
                     lambda: self.scene.island(7),
                     lambda: self.scene.render(None),
                     lambda: self.scene.render([0, 0, 0, "north"]),
                     lambda: self.scene.render([0, 0, 0, 0], "pinhole"),
                     lambda: bulletnav.Scene(7),
                     lambda: bulletnav.Scene(support.SCENE, backend=object()),
                     lambda: bulletnav.Scene(support.SCENE, import_={"doors": "closed"}),
                     lambda: bulletnav.Scene(support.SCENE, import_={}, **{"import": {}}),
                     lambda: bulletnav.generate(3),
                     lambda: bulletnav.generate("houses", count="3"),
                     lambda: bulletnav.generate("houses", kind="castle"),
                     lambda: bulletnav.generate("houses", kind=3),
                     lambda: bulletnav.read_results(7),
                     lambda: bulletnav.read_trajectory(None),
                     lambda: bulletnav.draw_episodes(7, {"easy": 1}),
                     lambda: self.scene.snap([nan, 0, 0]),
                     lambda: self.scene.render([1, 2, 3]),
                     lambda: self.scene.render([nan, 0, 0, 0]),
                     lambda: self.scene.render([0, 0, 0, 0], {"type": "fisheye"}),
                     lambda: self.scene.render([0, 0, 0, 0], {"rows": -1})):
            with self.assertRaises(bulletnav.Error):
                call()
        child = os.fork()
        if child == 0:
            try:
                self.scene.distance([1, 0, -1], [1, 0, -5])
            except bulletnav.Error:
                os._exit(0)
            os._exit(1)
        self.assertEqual(os.waitpid(child, 0)[1], 0)


class Files(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def test_episodes_are_drawn_written_read_and_played(self):
        episodes = bulletnav.draw_episodes(support.SCENE, {"easy": 2, "medium": 1}, seed=4)
        self.assertEqual(len(episodes), 3)
        self.assertEqual(episodes[0]["info"]["difficulty"], "easy")
        self.assertEqual(episodes, bulletnav.draw_episodes([support.SCENE],
                                                           {"easy": 2, "medium": 1}, seed=4))
        file = self.folder / "episodes.json.gz"
        bulletnav.write_episodes(file, episodes)
        self.assertEqual(bulletnav.read_episodes(file), episodes)
        options = {**support.ROOM, "scenes": None}
        env = bulletnav.Env(episodes=file, **options)
        env.reset()
        self.assertEqual(env.episode()["episode_id"], episodes[0]["episode_id"])
        with self.assertRaisesRegex(bulletnav.FileError, "'scene_id' is missing"):
            bulletnav.write_episodes(file, [{"episode_id": "1"}])
        with self.assertRaisesRegex(bulletnav.FileError, "has the id of"):
            bulletnav.write_episodes(file, [episodes[0], episodes[0]])
        with self.assertRaises(bulletnav.FileError):
            bulletnav.read_episodes(self.folder / "none.json")

    def test_a_lane_whose_episode_cannot_be_played_is_no_crash(self):
        episodes = bulletnav.draw_episodes(support.SCENE, {"easy": 2}, seed=4)
        episodes[1]["start_position"] = [50.0, 0.0, 50.0]
        file = self.folder / "episodes.json"
        bulletnav.write_episodes(file, episodes)
        env = bulletnav.Env(episodes=file, **{**support.ROOM, "scenes": None})
        env.reset()
        for _ in range(2):
            with self.assertRaisesRegex(bulletnav.Error, episodes[1]["episode_id"]):
                env.reset()
            with self.assertRaisesRegex(bulletnav.Error, "has no episode"):
                env.step(1)
            env.reset()
            env.step(1)

    def test_results(self):
        line = {"agent": "a", "setting": "rgbd", "condition": "noise", "seed": 1, "scene": "s.glb",
                "episode": "e", "difficulty": "easy", "failure": "", "success": True, "spl": 0.5,
                "distance_to_goal": None}
        (self.folder / "episodes.jsonl").write_text(json.dumps(line) + "\n")
        results = bulletnav.read_results(self.folder)
        self.assertEqual(results[0]["spl"], 0.5)
        self.assertIsNone(results[0]["distance_to_goal"])
        (self.folder / "episodes.jsonl").write_text("{\n")
        with self.assertRaisesRegex(bulletnav.FileError, "episodes.jsonl"):
            bulletnav.read_results(self.folder)
        with self.assertRaisesRegex(bulletnav.FileError, "no such folder"):
            bulletnav.read_results(self.folder / "none")
        with self.assertRaises(bulletnav.FileError):
            bulletnav.read_trajectory(self.folder / "none.json")
        self.assertIn("spl", [measure["name"] for measure in bulletnav.measures()])


if __name__ == "__main__":
    unittest.main()
