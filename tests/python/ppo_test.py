# SPDX-License-Identifier: MIT
"""The example of PPO runs, where Debian's python3-torch is installed."""
import os
import runpy
import sys

import support

try:
    import numpy
    import torch
except ImportError as error:
    sys.stderr.write(f"skipped: {error}; install python3-torch and python3-numpy\n")
    sys.exit(77)

EXAMPLE = os.path.join(os.path.dirname(__file__), "../../python/examples/ppo.py")
module = runpy.run_path(EXAMPLE)

# One lane, discount 0.5, trace 1: sums of discounted rewards, cut at the end of the episode.
rewards, values = torch.tensor([[1.0], [2.0], [4.0]]), torch.zeros(3, 1)
ends = torch.tensor([[0.0], [1.0], [0.0]])
found = module["advantages_of"](rewards, values, ends, torch.tensor([8.0]), 0.5, 1.0)
assert found.flatten().tolist() == [2.0, 2.0, 8.0], found

torch.set_num_threads(2)
sys.argv = [EXAMPLE, support.SCENE, "--updates", "2", "--steps", "8", "--num-envs", "2"]
module["main"]()
