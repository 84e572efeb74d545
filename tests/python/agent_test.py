# SPDX-License-Identifier: MIT
"""Agents written in Python, in runs of the program."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
import unittest.mock

import support

PROGRAM = pathlib.Path(os.environ["BULLETNAV_BUILD"]) / "bulletnav"
LIBRARY = PROGRAM.parent / "bulletnav-python.so"
if not LIBRARY.exists():
    sys.stderr.write(f"skipped: {LIBRARY} is missing; this Python has no shared library\n")
    sys.exit(77)

AGENTS = """
import os, sys, time
import helper

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

class ForksAndAnswersNonsense(Walker):
    def act(self, observation):
        return "forward" if os.fork() == 0 else 0

class ForksWhenBuilt(Walker):
    def __init__(self, rig, options):
        super().__init__(rig, options)
        if os.fork() > 0:
            os.wait()

class LeavesAChild(Walker):
    def act(self, observation):
        child = os.fork()
        while child == 0:
            time.sleep(1)
        with open("children", "a") as file:
            file.write(f"{child}\\n")
        return 0

class Loops(Walker):
    def act(self, observation):
        while True:
            helper.nothing()

class Sleeps(Walker):
    def act(self, observation):
        time.sleep(1000)

class Stubborn(Walker):
    def act(self, observation):
        try:
            while True:
                helper.nothing()
        except BaseException:
            return self.act(observation)

class Ends(Walker):
    def act(self, observation):
        os._exit(0)

class Crashes(Walker):
    def act(self, observation):
        import ctypes
        ctypes.string_at(0)

class RaisesWhenBuilt(Walker):
    def __init__(self, rig, options):
        raise RuntimeError("no weights here")

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


def has_ended(process):
    """Whether it does before long; nobody may have taken note of it."""
    for _ in range(100):
        try:
            state = pathlib.Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0]
        except (FileNotFoundError, ProcessLookupError):
            return True
        if state == "Z":
            return True
        time.sleep(0.05)
    return False


class Agents(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / "mine.py").write_text(AGENTS)
        (self.folder / "helper.py").write_text("def nothing(): pass\n")

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

    def test_one_that_would_end_the_process_fails_its_episodes(self):
        done, results = self.run_agents(
            self.WALKER + "  - {agent: python, name: ends, parameters: {module: 'mine:Ends'}}\n")
        self.assertEqual((done.returncode, len(results)), (0, 8), done.stderr)
        for result in results:
            if result["agent"] == "ends":
                self.assertIn("SystemExit: os._exit", result["failure"])
            else:
                self.assertIsNone(result["failure"])

    def test_a_crash_in_c_code_is_told_with_its_place(self):
        done, _ = self.run_agents(
            "  - {agent: python, name: crashes, parameters: {module: 'mine:Crashes'}}\n")
        self.assertNotEqual(done.returncode, 0)
        self.assertRegex(done.stderr, 'mine.py", line [0-9]+ in act')

    def test_one_that_forks_leaves_one_run(self):
        for name in ("Forks", "ForksAndAnswersNonsense", "ForksWhenBuilt", "LeavesAChild"):
            done, results = self.run_agents(
                f"  - {{agent: python, name: forks, parameters: {{module: 'mine:{name}', "
                "options: {first: 1, steps: 5}}}\n", name)
            self.assertEqual((done.returncode, len(results)), (0, 4), done.stderr)
            self.assertTrue(all(result["failure"] is None for result in results), results)
        children = (self.folder / "children").read_text().split()
        self.assertEqual(len(children), 4)
        self.assertTrue(all(map(has_ended, children)), children)

    @staticmethod
    def stuck(name):
        return (f"  - {{agent: python, name: {name}, parameters: {{module: 'mine:{name}', "
                "time_limit_s: 0.5}}\n")

    def test_one_that_never_answers_fails_its_episodes(self):
        done, results = self.run_agents(self.WALKER + self.stuck("Loops"))
        self.assertEqual((done.returncode, len(results)), (0, 8), done.stderr)
        for result in results:
            if result["agent"] == "walker":
                self.assertIsNone(result["failure"])
            else:
                self.assertIn("gave no answer in time", result["failure"])
                self.assertRegex(result["failure"], "(mine|helper).py\", line")
                self.assertIn("TimeLimit", result["failure"])

    def test_one_that_cannot_be_interrupted_ends_the_process_and_loses_nothing(self):
        for name, times in (("Sleeps", 2), ("Stubborn", 1)):
            agents = self.WALKER + self.stuck(name)
            for failed in range(1, times + 1):  # The same command goes on.
                done, results = self.run_agents(agents, name, 1)
                self.assertEqual(done.returncode, 1, done.stderr)
                last = done.stderr.splitlines()[-1]
                self.assertIn(f"agent '{name}' ({self.folder / 'mine.py'})", last)
                self.assertEqual(len([r for r in results if r["agent"] == "walker"]), 4)
                found = [r for r in results if r["agent"] == name]
                self.assertEqual(len(found), failed, done.stderr)
                self.assertIn("could not be interrupted", found[-1]["failure"])
                self.assertTrue(any(f"'{r['episode']}'" in last for r in found), last)

    def test_other_code_is_not_the_same_agent(self):
        done, results = self.run_agents(self.WALKER)
        self.assertEqual(done.returncode, 0, done.stderr)
        (self.folder / "helper.py").write_text("def nothing(): return 1\n")
        done, again = self.run_agents(self.WALKER)
        self.assertEqual((done.returncode, again), (1, results))
        self.assertIn("the code of agent 'walker' has changed", done.stderr.splitlines()[-1])
        (self.folder / "helper.py").write_text("def nothing(): pass\n")
        done, again = self.run_agents(self.WALKER)
        self.assertEqual((done.returncode, again), (0, results))

    def test_a_virtual_environment_of_another_python_is_told(self):
        (self.folder / "venv").mkdir()
        with unittest.mock.patch.dict(os.environ, VIRTUAL_ENV=str(self.folder / "venv")):
            done, _ = self.run_agents("  - {agent: python, parameters: {module: 'none:A'}}\n")
        self.assertIn("VIRTUAL_ENV is not of Python", done.stderr.splitlines()[-1])

    def test_what_cannot_be_built_is_said_in_a_line(self):
        for module, expected in (("none:Walker", "No module named 'none'"), ("mine:None_", "None_"),
                                 ("mine", "MODULE:CLASS"), ("mine:NoAct", "act"),
                                 ("mine:RaisesWhenBuilt", "no weights here ({folder}/mine.py:")):
            # Others that could play do not: the line would be overlooked.
            done, results = self.run_agents(
                f"{self.WALKER}  - {{agent: python, parameters: {{module: '{module}'}}}}\n", module.replace(":", "_"))
            self.assertEqual((done.returncode, results), (1, []))
            self.assertIn(expected.format(folder=self.folder), done.stderr.splitlines()[-1])
        done, _ = self.run_agents("  - {agent: python}\n")
        self.assertIn("MODULE:CLASS", done.stderr)


if __name__ == "__main__":
    unittest.main()
