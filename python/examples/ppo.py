# SPDX-License-Identifier: MIT
"""PPO on image-goal navigation in a page: python ppo.py SCENE ... (needs PyTorch and numpy).

What is seen stays in BulletNav's memory: torch looks at it without a copy, and makes small what it
keeps. Source of the algorithm: Schulman et al., Proximal Policy Optimization, 2017.
"""
import argparse

import sys

try:
    import torch
    from torch import nn
except ImportError:
    sys.exit("ppo.py: needs PyTorch and numpy; on Debian: apt install python3-torch")

import bulletnav


class Policy(nn.Module):
    """A small network over what is seen beside the goal: depth and colour of both, 32 x 128."""

    def __init__(self, actions=4):
        super().__init__()
        self.body = nn.Sequential(
            nn.Conv2d(8, 16, 5, stride=2), nn.ReLU(), nn.Conv2d(16, 32, 3, stride=2), nn.ReLU(),
            nn.Conv2d(32, 32, 3, stride=2), nn.ReLU(), nn.Flatten(), nn.LazyLinear(128), nn.ReLU())
        self.actor = nn.Linear(128, actions)
        self.critic = nn.Linear(128, 1)

    def forward(self, seen):
        features = self.body(seen)
        return torch.distributions.Categorical(logits=self.actor(features)), self.critic(features)[:, 0]


class Eyes:
    """Tensors of the environment's memory, made once."""

    def __init__(self, envs):
        self.arrays = {name: torch.from_dlpack(array) for name, array in envs.arrays.items()}

    def __call__(self):
        parts = []
        for source in ("panorama", "goal"):
            color = self.arrays[f"{source}.color"][:, ::4, ::4].permute(0, 3, 1, 2) / 255.0
            parts += [color, self.arrays[f"{source}.depth"][:, None, ::4, ::4] / 10.0]
        return torch.cat(parts, 1)


def advantages_of(rewards, values, ends, last, discount=0.99, trace=0.95):
    """Generalised advantage estimates, [steps, lanes]."""
    advantages, running = torch.zeros_like(rewards), torch.zeros_like(last)
    for t in reversed(range(len(rewards))):
        after = (last if t + 1 == len(rewards) else values[t + 1]) * (1 - ends[t])
        running = rewards[t] + discount * after - values[t] + discount * trace * (1 - ends[t]) * running
        advantages[t] = running
    return advantages


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("scenes", nargs="+")
    options.add_argument("--num-envs", type=int, default=8)
    options.add_argument("--steps", type=int, default=64)
    options.add_argument("--updates", type=int, default=1000)
    given = options.parse_args()
    torch.manual_seed(0)
    envs = bulletnav.VectorEnv(scenes=given.scenes, num_envs=given.num_envs, max_steps=200,
                               autoreset_mode="same_step", shuffle=True)
    envs.reset(seed=0)
    eyes, policy = Eyes(envs), Policy()
    policy(eyes())  # Its lazy layer takes its size.
    optimiser = torch.optim.Adam(policy.parameters(), lr=2.5e-4)
    successes = []
    for update in range(given.updates):
        steps = {name: [] for name in ("seen", "action", "chance", "value", "reward", "end")}
        for _ in range(given.steps):
            seen = eyes()
            with torch.no_grad():
                choice, value = policy(seen)
            action = choice.sample()
            _, reward, terminated, truncated, info = envs.step(action)
            ends = [a or b for a, b in zip(terminated, truncated)]
            for name, what in (("seen", seen), ("action", action), ("value", value),
                               ("chance", choice.log_prob(action)),
                               ("reward", torch.tensor(list(reward), dtype=torch.float32)),
                               ("end", torch.tensor(ends, dtype=torch.float32))):
                steps[name].append(what)
            successes += [facts["success"] for facts in info.get("results", {}).values()]
        data = {name: torch.stack(what) for name, what in steps.items()}
        with torch.no_grad():
            last = policy(eyes())[1]
        advantages = advantages_of(data["reward"], data["value"], data["end"], last)
        wanted = (advantages + data["value"]).flatten()
        advantages = ((advantages - advantages.mean()) / (advantages.std() + 1e-8)).flatten()
        flat = {name: what.flatten(0, 1) for name, what in data.items()}
        for _ in range(3):
            for part in torch.randperm(len(wanted)).chunk(4):
                choice, value = policy(flat["seen"][part])
                ratio = (choice.log_prob(flat["action"][part]) - flat["chance"][part]).exp()
                gain = torch.min(ratio * advantages[part], ratio.clamp(0.8, 1.2) * advantages[part])
                loss = (-gain.mean() + 0.5 * (value - wanted[part]).pow(2).mean()
                        - 0.01 * choice.entropy().mean())
                optimiser.zero_grad()
                loss.backward()
                nn.utils.clip_grad_norm_(policy.parameters(), 0.5)
                optimiser.step()
        recent = successes[-100:]
        print(f"update {update}: reward a step {data['reward'].mean():.4f}, "
              f"success {sum(recent) / max(1, len(recent)):.2f} of the last {len(recent)}", flush=True)


if __name__ == "__main__":
    main()
