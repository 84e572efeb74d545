# SPDX-License-Identifier: MIT
"""Agents written in Python, in runs of the program."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import support

PROGRAM = pathlib.Path(os.environ["BULLETNAV_BUILD"]) / "bulletnav"
LIBRARY = PROGRAM.parent / "bulletnav-python.so"
if not LIBRARY.exists():
    sys.stderr.write(f"skipped: {LIBRARY} is missing; this Python has no shared library\n")
    sys.exit(77)

AGENTS = """
import os, sys

class Walker:
    def __init__(self, rig, options):
        self.rig, self.options = rig, options
        assert rig["rows"] == 16 and rig["has_depth"], rig
    def reset(self, goal, seed):
        assert memoryview(goal["color"]).shape == (16, 64, 3)
        self.kept, self.steps = [], 0
    def act(self, observation):
        assert memoryview(observation["panorama.depth"]).shape == (16, 64), observation
        assert observation["step"] == self.steps
        self.kept.append(bytes(memoryview(observation["panorama.depth"])))
        self.steps += 1
        return self.options["first"] if self.steps < self.options["steps"] else 0

class Raises(Walker):
    def act(self, observation):
        raise ValueError("out of ideas")

class Nonsense(Walker):
    def act(self, observation):
        return "forward"

class Leaves(Walker):
    def reset(self, goal, seed):
        sys.exit(3)

class Forks(Walker):
    def act(self, observation):
        if os.fork() > 0:
            os.wait()
        return 0

class NoAct:
    def __init__(self, rig, options): pass
    def reset(self, goal, seed): pass
"""
CONFIG = """
episodes:
  file: {folder}/episodes.json
  draw: {{scenes: [{scene}], counts: {{easy: 4}}, seed: 1}}
panorama: {{rows: 16, cols: 64}}
backend: embree
max_steps: 12
agents:
"""


class Agents(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / "mine.py").write_text(AGENTS)

    def run_agents(self, agents, out="out", workers=2):
        config = self.folder / "run.yaml"
        config.write_text(CONFIG.format(folder=self.folder, scene=os.path.abspath(support.SCENE))
                          + agents)
        environment = {**os.environ, "PYTHONPATH": "", "PYTHONDONTWRITEBYTECODE": "1"}
        done = subprocess.run([PROGRAM, "run", config, "--no-plots", "--workers", str(workers),
                               "--out", self.folder / out], cwd=self.folder, env=environment,
                              capture_output=True, text=True)
        file = self.folder / out / "episodes.jsonl"
        lines = file.read_text().splitlines() if file.exists() else []
        return done, [json.loads(line) for line in lines]

    WALKER = ("  - {agent: python, name: walker, lanes: 2, parameters: {module: 'mine:Walker', "
              "options: {first: 1, steps: 5}}}\n")

    def test_play_as_others_do(self):
        done, results = self.run_agents(self.WALKER + "  - {agent: shortest_path}\n")
        self.assertEqual(done.returncode, 0, done.stderr)
        walker = [r for r in results if r["agent"] == "walker"]
        self.assertEqual((len(walker), len(results)), (4, 8))
        self.assertTrue(all(r["failure"] is None and r["steps"] == 4 for r in walker), walker)
        self.assertIn("walker", (self.folder / "out" / "table.md").read_text())
        again, same = self.run_agents(self.WALKER + "  - {agent: shortest_path}\n", "again", 1)
        self.assertEqual(same, results)

    def test_what_they_raise_fails_their_episodes_alone(self):
        names = {"Raises": 'ValueError: out of ideas', "Nonsense": "act answered 'forward'",
                 "Leaves": "SystemExit: 3"}
        done, results = self.run_agents(self.WALKER + "".join(
            f"  - {{agent: python, name: {name}, parameters: {{module: 'mine:{name}'}}}}\n"
            for name in names))
        self.assertEqual(len(results), 16, done.stderr)
        for result in results:
            if result["agent"] == "walker":
                self.assertIsNone(result["failure"])
                continue
            self.assertIn(names[result["agent"]], result["failure"])
            self.assertFalse(result["success"])
            if result["agent"] == "Raises":
                self.assertIn("mine.py\", line", result["failure"])  # Its traceback.

    def test_one_that_forks_leaves_one_run(self):
        done, results = self.run_agents(
            "  - {agent: python, name: forks, parameters: {module: 'mine:Forks'}}\n")
        self.assertEqual((done.returncode, len(results)), (0, 4), done.stderr)

    def test_what_cannot_be_built_is_said_in_a_line(self):
        for module, expected in (("none:Walker", "No module named 'none'"), ("mine:None_", "None_"),
                                 ("mine", "MODULE:CLASS"), ("mine:NoAct", "act")):
            done, results = self.run_agents(
                f"  - {{agent: python, parameters: {{module: '{module}'}}}}\n", module.replace(":", "_"))
            self.assertEqual((done.returncode, results), (1, []))
            self.assertIn(expected, done.stderr.splitlines()[-1])
        done, _ = self.run_agents("  - {agent: python}\n")
        self.assertIn("MODULE:CLASS", done.stderr)


if __name__ == "__main__":
    unittest.main()
