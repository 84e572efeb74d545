# SPDX-License-Identifier: MIT
"""Frames a second of VectorEnv beside those of the C++ batch simulator: python speed.py SCENE ...

Both step the same lanes with the same actions in turns, so that what else the machine does troubles
both alike. A frame: one lane's step with its panorama, colour and depth of 128 x 512.
"""
import argparse
import random
import statistics
import time

import bulletnav


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("scenes", nargs="+")
    options.add_argument("--num-envs", type=int, default=8)
    options.add_argument("--threads", type=int, default=0)
    options.add_argument("--steps", type=int, default=60)
    options.add_argument("--rounds", type=int, default=7)
    options.add_argument("--least", type=float, help="fail under this share of the batch's speed")
    given = options.parse_args()
    envs = bulletnav.VectorEnv(scenes=given.scenes, num_envs=given.num_envs, threads=given.threads,
                               max_steps=10**6)
    draw = random.Random(0)
    ratios, speeds = [], []
    warm_up = 10
    for _ in range(given.rounds):
        actions = [[draw.choice((1, 1, 2, 3)) for _ in range(given.num_envs)]
                   for _ in range(given.steps + warm_up)]
        envs.reset(seed=0)
        batch = envs._lanes.batch_seconds(actions, warm_up)
        for step, action in enumerate(actions):
            if step == warm_up:
                start = time.perf_counter()
            envs.step(action)
        seconds = time.perf_counter() - start
        ratios.append(batch / seconds)
        speeds.append(given.steps * given.num_envs / seconds)
    ratio = statistics.median(ratios)
    print(f"VectorEnv: {statistics.median(speeds):.0f} frames/s, {100 * ratio:.1f}% of the C++ batch "
          f"simulator's (medians of {given.rounds} rounds in turns; {given.num_envs} lanes)")
    if given.least is not None and ratio < given.least:
        raise SystemExit(f"that is under {100 * given.least:.0f}%")


if __name__ == "__main__":
    main()
