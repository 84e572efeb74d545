# SPDX-License-Identifier: MIT
"""A small run and its page."""
import base64
import gzip
import json
import os
import pathlib
import re
import shutil
import subprocess

PROGRAM = os.environ["BULLETNAV_PROGRAM"]
ROOM = pathlib.Path(__file__).parent / "../../embedding/room.obj"
CONFIG = """
episodes:
  file: {folder}/episodes.json
  draw: {{scenes: [{folder}/room.obj], counts: {{easy: 4}}, seed: 1}}
panorama: {{rows: 16, cols: 64}}
backend: embree
max_steps: 60
agents:
  - {{agent: metric_map_fbe, models: {{semantic_model: oracle}}}}
  - {{agent: random}}
  - {{agent: shortest_path}}
"""


def program(*arguments):
    """Runs the program; its output as text."""
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)


def play(folder, out, *more):
    """Plays the small run into folder/out."""
    shutil.copy(ROOM, folder / "room.obj")
    (folder / "run.yaml").write_text(CONFIG.format(folder=folder))
    done = program("run", folder / "run.yaml", "--no-plots", "--workers", 1, "--out", folder / out,
                   *more)
    assert done.returncode == 0, done.stderr
    return folder / out


def replay(run, *more):
    """Makes the page of a run: what the program said, and the page."""
    done = program("replay", run, *more)
    page = run / "replay.html"
    return done, page.read_text() if page.exists() else ""


def rows(page):
    """What a page lists, by the names of its columns; and all that it tells besides."""
    text = re.search(r'<script type="application/json" id="run">(.*?)</script>', page, re.S)
    told = json.loads(text.group(1))
    return [dict(zip(told["columns"], row)) for row in told["rows"]], told


def block(page, name):
    """A block of a page, unpacked; None if there is none."""
    text = re.search(rf'<script type="application/gzip" id="{name}">([^<]*)</script>', page)
    return json.loads(gzip.decompress(base64.b64decode(text.group(1)))) if text else None
