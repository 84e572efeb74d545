# SPDX-License-Identifier: MIT
"""The module in a fresh virtual environment, as a user gets it: built, installed, played with."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PLAY = """
import sys, bulletnav
scene = sys.argv[1]
envs = bulletnav.VectorEnv(scenes=[scene], num_envs=8)
observations, info = envs.reset(seed=0)
for _ in range(5):
    observations, rewards, terminated, truncated, info = envs.step(envs.action_space.sample())
print(bulletnav.__file__, observations["panorama.color"].shape)
"""


def run(*command, **options):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, **options)
    return done.returncode, done.stdout, done.stderr


class Installed(unittest.TestCase):
    def test_in_a_virtual_environment(self):
        if pathlib.Path(os.environ.get("BULLETNAV_BUILD", "")) != ROOT / "build" / "release":
            self.skipTest("the launcher builds in build/release alone")
        with tempfile.TemporaryDirectory() as folder:
            venv = pathlib.Path(folder) / "venv"
            status, out, err = run(sys.executable, "-m", "venv", venv)
            if status != 0:
                self.skipTest(f"no virtual environments here (python3-venv): {out} {err}")
            environment = {**os.environ, "VIRTUAL_ENV": str(venv)}
            environment.pop("PYTHONPATH", None)
            status, out, err = run(ROOT / "bulletnav", "--no-install", "python", env=environment)
            self.assertEqual(status, 0, out + err)
            scene = ROOT / "tests" / "embedding" / "room.obj"
            status, out, err = run(venv / "bin" / "python", "-c", PLAY, scene, cwd=folder,
                                   env=environment)
            self.assertEqual((status, err), (0, ""))
            self.assertIn(str(venv), out)
            self.assertIn("8, 128, 512, 3", out)

    def test_without_one_it_says_so(self):
        environment = {k: v for k, v in os.environ.items() if k != "VIRTUAL_ENV"}
        status, _, err = run(ROOT / "bulletnav", "--no-install", "python", env=environment)
        self.assertEqual(status, 1)
        self.assertIn("no virtual environment is active", err)
        self.assertEqual(len(err.splitlines()), 1, err)


class Wheel(unittest.TestCase):
    def test_is_the_same_twice_and_whole(self):
        if pathlib.Path(os.environ.get("BULLETNAV_BUILD", "")) != ROOT / "build" / "release":
            self.skipTest("the launcher builds in build/release alone")
        sys.path.insert(0, str(ROOT / "python"))
        import build_backend
        with tempfile.TemporaryDirectory() as first, tempfile.TemporaryDirectory() as second:
            name = build_backend.build_wheel(first)
            self.assertEqual(build_backend.build_wheel(second), name)
            file = pathlib.Path(first) / name
            self.assertEqual(file.read_bytes(), (pathlib.Path(second) / name).read_bytes())
            with zipfile.ZipFile(file) as wheel:
                names = wheel.namelist()
                record = wheel.read(next(n for n in names if n.endswith("RECORD"))).decode()
        self.assertEqual([line.split(",")[0] for line in record.splitlines()], names)
        self.assertIn("bulletnav/bulletnav-import", names)
        self.assertIn("bulletnav/py.typed", names)


if __name__ == "__main__":
    unittest.main()
