#!/usr/bin/env python3
"""Stacking blocks, in the shape of a Gymnasium environment: put the next block at x so that the stack grows and stands.

    env = Stacking(blocks=5)
    observation, info = env.reset(seed=1)
    observation, reward, terminated, truncated, info = env.step(0.1)

The action is where the next block lands, in m beside the middle of the block below. The verdict is exact, so nothing
has to be simulated to give the reward; `render` shows the stack with its forces, and a fall as it happens.
"""
import numpy as np

import wuerfel as w


class Stacking:
    metadata = {"render_modes": ["rgb_array"]}

    def __init__(self, blocks=5, size=(1.0, 0.4), render_mode="rgb_array"):
        self.blocks, self.size, self.render_mode = blocks, size, render_mode
        self.places = []

    def reset(self, seed=None, options=None):
        """The first block lies somewhere near the origin."""
        self.random = np.random.default_rng(seed)
        self.places = [float(self.random.uniform(-0.2, 0.2))]
        return self.observation(), {"scene": self.scene()}

    def step(self, action):
        self.places.append(self.places[-1] + float(np.clip(action, -0.999, 0.999)) * self.size[0])
        check = w.check(self.scene())
        stands, complete = bool(check), len(self.places) == self.blocks
        reward = (1.0 + abs(self.places[-1] - self.places[0])) if stands else -1.0  # far out pays
        return self.observation(), reward, not stands or complete, False, {"verdict": check.verdict, "scene": self.scene()}

    def observation(self):
        """Places of the blocks in m, NaN where there is none yet."""
        return np.array(self.places + [np.nan] * (self.blocks - len(self.places)))

    def scene(self):
        width, height = self.size
        cubes = [{"name": f"b{i + 1}", "size": [width, height], "position": [x, height * (i + 0.5)]} for i, x in enumerate(self.places)]
        return w.Scene({"plane": [{"name": "floor"}], "cube": cubes})

    def render(self, t=0.0):
        return w.render(self.scene(), t=t, size=(480, 360))


def main():
    env = Stacking()
    best = -np.inf
    for episode in range(200):
        env.reset(seed=episode)
        total, done = 0.0, False
        while not done:
            _, reward, terminated, truncated, info = env.step(env.random.normal(0.0, 0.25))
            total, done = total + reward, terminated or truncated
        if total > best:
            best = total
            print(f"episode {episode}: {info['verdict']}, return {total:.3f}, places {np.round(env.observation(), 2)}")


if __name__ == "__main__":
    main()
