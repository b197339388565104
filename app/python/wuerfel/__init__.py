"""Falling cubes in the plane by Gauss' principle of least constraint.

    import wuerfel as w
    scene = w.Scene("demo")                    # path, TOML or JSON text, dict, or the name of a shipped scene
    w.check(scene).verdict                     # "falls"
    w.explain(scene)["text"]                   # why, and what would help
    motion = w.simulate(scene, [0.0, 0.5, 1.0])
    motion.states                              # (times, bodies, 6): x, y, angle, vx, vy, spin
    w.render(scene, t=0.5, size=(640, 360))    # (360, 640, 4) uint8
    w.save_film(scene, "demo.mp4")

SI units, y up, angles in radians counter-clockwise. Errors in scenes are SceneError, a ValueError that says where
and what would be right.
"""
from typing import NamedTuple

from ._core import (Check, OutputError, RenderError, Scene, SceneError, Simulation, __version__, check, check_many,
                    explain, render, replay, save_film, simulate, simulate_many)

__all__ = ["Check", "OutputError", "RenderError", "Scene", "SceneError", "Simulation", "Trajectory", "check",
           "check_many", "explain", "render", "replay", "save_film", "simulate", "simulate_many"]

SceneError.__doc__ = "Bad input: the message says where, what is wrong and what would be right."
RenderError.__doc__ = "A picture that cannot be drawn as asked."
OutputError.__doc__ = "Something that is needed is missing or cannot be written: ffmpeg, a disk."


class Trajectory(NamedTuple):
    """What `simulate` returns."""

    times: "numpy.ndarray"   # s
    states: "numpy.ndarray"  # (times, bodies, 6): x, y, angle and their rates; just after events
    names: list              # of the cubes, then of the point masses
    events: list             # dicts with the keys of `run --json`
    audit: dict
    outcome: dict            # moved, at_rest
