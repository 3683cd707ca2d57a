# What the tests of the module share: shipped scenes and random states. Not: any expectation.
# SPDX-License-Identifier: GPL-2.0-or-later
import pathlib

import kanec
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]


def shipped(name):
    return kanec.read(ROOT / "models" / name)


def random_states(scene, count, seed=1):
    """x (count, nx) with Euler parameters of unit norm, y (count, ny), and as many ydot."""
    random = np.random.default_rng(seed)
    x = random.uniform(-1, 1, (count, scene.nx))
    for part in scene.x.parts:
        if part.name.startswith("eps"):
            eps = x[:, part.begin:part.begin + 4]
            eps /= np.linalg.norm(eps, axis=1, keepdims=True)
    return x, random.uniform(-1, 1, (count, scene.ny)), random.uniform(-1, 1, (count, scene.ny))


def pendulum(**more):
    """The tables of a scene with one revolute joint."""
    body = {"name": "rod", "joint": "revolute", "axis": "y", "mass": 1.2,
            "inertia": [0.1, 0.1, 0.0], "r": [0.0, 0.0, -0.5]}
    return {"name": "pendulum", "connection": [0], "gravity": [0.0, 0.0, -9.81], "body": [body], **more}
