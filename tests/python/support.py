# SPDX-License-Identifier: MIT
"""What the tests of the Python module share."""
import os

SCENE = os.path.join(os.path.dirname(__file__), "../embedding/room.obj")
SMALL = {"panorama": {"type": "panorama", "rows": 16, "cols": 64}, "odometry": "odometry",
         "bumper": "bumper"}
# Arguments of an environment that takes no time.
ROOM = {"scenes": [SCENE], "sensors": SMALL, "max_steps": 8, "backend": "embree"}
