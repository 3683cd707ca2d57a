# The package kanec: what is public. Not: how it is done (_kanec, errors).
# SPDX-License-Identifier: GPL-2.0-or-later
"""kanec: a tree of rigid bodies in, its equations of motion, their compiled code and its motion out.

    scene = kanec.read("models/cart_pole")
    model = scene.compile()
    ydot = model.accelerations(scene.initial_x, scene.initial_y, push=1.0)
    motion = scene.simulate(duration=2.0)

help(kanec.Scene), help(kanec.Model), help(kanec.Function), help(kanec.Motion); errors are kanec.Error and below.
"""

from .errors import (
    BuildError,
    Error,
    FileError,
    InputError,
    IntegrationError,
    InternalError,
    LoadError,
    Note,
    SceneError,
)
from ._kanec import (
    Agreed,
    Event,
    Function,
    Model,
    Motion,
    Offer,
    Part,
    Scene,
    Shape,
    __version__,
    build,
    integrators,
    parse,
    read,
    tree,
)

for _public in (Agreed, Event, Model, Motion, Offer, Part, Scene, Shape, build, integrators, parse, read, tree):
    _public.__module__ = "kanec"
del _public

__all__ = [
    "Agreed", "BuildError", "Error", "Event", "FileError", "Function", "InputError", "IntegrationError",
    "InternalError", "LoadError", "Model", "Motion", "Note", "Offer", "Part", "Scene", "SceneError", "Shape", "__version__", "build",
    "integrators", "parse", "read", "tree",
]
