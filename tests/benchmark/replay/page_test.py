# SPDX-License-Identifier: MIT
"""Pages of whole, half-written and damaged results."""
import os
import pathlib
import shutil
import tempfile
import unittest

import support


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.run_folder = support.play(cls.folder, "run", "--beliefs")

    def copy(self, name):
        return pathlib.Path(shutil.copytree(self.run_folder, self.folder / name))

    def test_holds_all_of_a_run_and_needs_nothing_else(self):
        done, page = support.replay(self.run_folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows, told = support.rows(page)
        self.assertEqual((len(rows), told["notes"]), (12, []))
        for i, row in enumerate(rows):
            path = support.block(page, f"e{i}")
            self.assertEqual((row["has_path"], len(path["poses"])), (1, len(path["actions"])))
            beliefs = support.block(page, f"b{i}")
            self.assertEqual(row["has_beliefs"], 0 if beliefs is None else 1)
            if beliefs:
                self.assertEqual(len(beliefs["frames"]), len(path["actions"]))
            self.assertGreater(len(support.block(page, f"s{row['scene_block']}")["walk"]), 0)
            self.assertIn(f'type="image/jpeg" id="i{i}"', page)
        self.assertEqual(sum(row["has_beliefs"] for row in rows), 4, "of the agent with a map")
        for word in ("http://", "https://", "src=", "@import", "fetch("):
            self.assertNotIn(word, page)
        self.assertEqual(page, support.replay(self.run_folder)[1], "same bytes again")

    def test_of_one_episode_and_without_pictures(self):
        done, page = support.replay(self.copy("some"), "--episodes", "room-easy-0001",
                                    "--panoramas", "0")
        self.assertEqual(len(support.rows(page)[0]), 3, done.stderr)
        self.assertNotIn("image/jpeg\"", page)
        done, _ = support.replay(self.copy("none"), "--episodes", "nowhere")
        self.assertEqual(done.returncode, 1)
        self.assertIn("has no result of episode 'nowhere'", done.stderr)

    def test_says_that_beliefs_or_trajectories_are_missing(self):
        run = self.copy("blind")
        shutil.rmtree(run / "beliefs")
        done, page = support.replay(run)
        self.assertIn("--beliefs", support.rows(page)[1]["notes"][0], done.stderr)
        shutil.rmtree(run / "trajectories")
        done, page = support.replay(run)
        rows, told = support.rows(page)
        self.assertEqual((len(rows), rows[0]["has_path"], done.returncode), (12, 0, 0))
        self.assertIn("no trajectories", told["notes"][0])

    def test_of_half_written_results(self):
        run = self.copy("half")
        lines = (run / "episodes.jsonl").read_text().splitlines(keepends=True)
        (run / "episodes.jsonl").write_text("".join(lines[:5]) + lines[5][:40])
        first = sorted((run / "trajectories").rglob("*.json"))[0]
        first.write_text(first.read_text()[:100])
        beliefs = sorted((run / "beliefs").rglob("*.gz"))[1]
        beliefs.write_bytes(beliefs.read_bytes()[:50])
        done, page = support.replay(run)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows, told = support.rows(page)
        self.assertEqual(len(rows), 5)
        self.assertEqual(len(told["notes"]), 3, told["notes"])
        self.assertIn("episodes.jsonl:6: is cut off", told["notes"][0])
        self.assertTrue(any(first.name in note for note in told["notes"]))
        self.assertTrue(any(beliefs.name in note for note in told["notes"]))

    def test_of_damaged_lines(self):
        run = self.copy("damaged")
        file = run / "episodes.jsonl"
        lines = file.read_text().splitlines(keepends=True)
        bad = ["garbage{\n", "{}\n", "\n", lines[0], '{"agent":1}\n', "\udcff\udc80\n", "[" * 5000 + "\n"]
        for number, line in enumerate(bad):
            text = "".join(lines[:2] + [line] + lines[3:])
            file.write_bytes(text.encode(errors="surrogateescape"))
            done, page = support.replay(run, "--panoramas", "0")
            self.assertEqual(done.returncode, 0, (number, done.stderr))
            rows, told = support.rows(page)
            self.assertEqual((len(rows), len(told["notes"])), (11, 1), (number, told["notes"]))
            self.assertIn("episodes.jsonl:3:", told["notes"][0])
            self.assertIn("episodes.jsonl:3:", done.stderr)
            self.assertEqual(support.program("plot", run).returncode, 1, "others refuse it")
        file.write_text("x\n" * 30 + lines[0])
        rows, told = support.rows(support.replay(run)[1])
        self.assertEqual((len(rows), len(told["notes"])), (1, 11))
        self.assertIn("20 more lines", told["notes"][-1])
        file.write_text("x\n" * 30)
        done, _ = support.replay(run)
        self.assertEqual((done.returncode, len(done.stderr.strip().splitlines())), (1, 1), done.stderr)
        self.assertIn("episodes.jsonl:1:", done.stderr)

    def test_names_the_version_that_played_it(self):
        self.assertEqual(support.rows(support.replay(self.run_folder)[1])[1]["to_play_again"], "")
        run = self.copy("older")
        (run / "versions.txt").write_text("0.0.9 (abc)\n")
        shutil.rmtree(run / "beliefs")
        told = support.rows(support.replay(run)[1])[1]
        self.assertIn("played with bulletnav 0.0.9 (abc)", told["to_play_again"])
        self.assertIn(told["to_play_again"], told["notes"][0])
        (run / "versions.txt").unlink()
        self.assertEqual(support.rows(support.replay(run)[1])[1]["to_play_again"], "")

    def test_of_scenes_that_are_gone_or_others(self):
        scene, away = self.folder / "room.obj", self.folder / "away.obj"
        os.rename(scene, away)
        self.addCleanup(os.rename, away, scene)
        run = self.copy("homeless")
        done, page = support.replay(run)
        rows, told = support.rows(page)
        self.assertEqual((done.returncode, rows[0]["has_path"], rows[0]["scene_block"]), (0, 1, -1))
        self.assertEqual(len(told["notes"]), 1, told["notes"])
        self.assertIn("room.obj", told["notes"][0])
        self.assertIn("without a plan", told["notes"][0])

    def test_refuses_what_is_no_run(self):
        for folder in (self.folder / "nothing", self.folder):
            done = support.program("replay", folder)
            self.assertEqual(done.returncode, 1)
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)

    def test_one_episode_can_be_played_again(self):
        run = self.folder / "again"
        done = support.program("run", self.run_folder / "config.yaml", "--no-plots", "--out", run,
                               "--only", "room-easy-0002")
        self.assertEqual(done.returncode, 0, done.stderr)
        again = set((run / "episodes.jsonl").read_text().splitlines())
        self.assertEqual(len(again), 3)
        self.assertLess(again, set((self.run_folder / "episodes.jsonl").read_text().splitlines()))
        done = support.program("run", self.run_folder / "config.yaml", "--out", run, "--only", "x")
        self.assertEqual(done.returncode, 1)
        self.assertIn("there is no episode 'x'", done.stderr)


if __name__ == "__main__":
    unittest.main()
