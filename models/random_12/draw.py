#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws random_12: python3 draw.py > scene.toml gives the committed file again."""
import math
import random

draw = random.Random(12)


def numbers(size, low, high, digits):
    return [round(draw.uniform(low, high), digits) for _ in range(size)]


def unit_eps():
    """Uniform on the unit sphere of four dimensions (a Gaussian direction, by Box and Muller)."""
    gauss = []
    for _ in range(4):
        radius = math.sqrt(-2 * math.log(1 - draw.random()))
        gauss.append(radius * math.cos(2 * math.pi * draw.random()))
    norm = math.sqrt(sum(g * g for g in gauss))
    return [g / norm for g in gauss]


def rotation(e):
    """Body to inertial axes, from Euler parameters with the scalar last."""
    a, b, c, d = e
    return [[1 - 2 * (b * b + c * c), 2 * (a * b - c * d), 2 * (a * c + b * d)],
            [2 * (a * b + c * d), 1 - 2 * (a * a + c * c), 2 * (b * c - a * d)],
            [2 * (a * c - b * d), 2 * (b * c + a * d), 1 - 2 * (a * a + b * b)]]


def box_inertia(mass):
    """A homogeneous box with half-edges of 0.1 to 0.6 m, its edges in random directions of the body's axes."""
    a, b, c = (draw.uniform(0.1, 0.6) for _ in range(3))
    moments = [mass / 3 * (b * b + c * c), mass / 3 * (a * a + c * c), mass / 3 * (a * a + b * b)]
    turn = rotation(unit_eps())
    return [[round(sum(turn[i][k] * moments[k] * turn[j][k] for k in range(3)), 4) for j in range(3)] for i in range(3)]


def body(k):
    mass = round(draw.uniform(0.5, 5.0), 2)
    lines = ["", "[[body]]", f"mass = {mass}", f"inertia = {box_inertia(mass)}", f"r = {numbers(3, -0.5, 0.5, 3)}"]
    if k > 1:
        lines.append(f"q = {numbers(3, -0.5, 0.5, 3)}")
    lines += [f"force = {numbers(3, -2, 2, 2)}", f"moment = {numbers(3, -0.1, 0.1, 3)}"]
    lines += ["[body.initial]", f"eps = {[round(e, 15) for e in unit_eps()]}", f"omega = {numbers(3, -1, 1, 2)}"]
    lines += [f"s = {numbers(3, -0.2, 0.2, 3)}", f"sdot = {numbers(3, -0.2, 0.2, 3)}"]
    return lines


def main():
    bodies = 12
    connection = [0] + [draw.randint(1, k - 1) for k in range(2, bodies + 1)]
    lines = ["# SPDX-License-Identifier: BSD-3-Clause",
             "# A random tree of twelve bodies. Written by draw.py; SI units.",
             'name = "random_12"', f"connection = {connection}", "gravity = [0.0, 0.0, -9.81]"]
    for k in range(1, bodies + 1):
        lines += body(k)
    lines += ["", "[simulate]", "duration = 10.0", "output_step = 0.01", 'integrator = "dop853"',
              "relative_tolerance = 1e-9", "absolute_tolerance = 1e-12"]
    print("\n".join(lines))


main()
