# The errors and warnings of kanec. Not: who raises them.
# SPDX-License-Identifier: GPL-2.0-or-later
"""Errors of kanec: one base class, one class a cause, each also the built-in class that it is nearest to."""

from difflib import get_close_matches
from typing import Iterable


class Error(Exception):
    """Base of all errors of kanec; its text is the whole message."""


class InputError(Error, ValueError):
    """An argument that cannot be used: what it is, what was found, what is allowed."""


class SceneError(Error, ValueError):
    """A scene that cannot be understood or modelled."""

    file: str = ""  #: where it was read
    line: int = 0  #: counted from 1; 0: not known
    body: str = ""  #: "body 3 (arm)"
    field: str = ""  #: "mass", "r[2]"
    found: str = ""  #: what stands there
    allowed: str = ""  #: what may stand there


class FileError(Error, OSError):
    """A file that cannot be read or written."""


class BuildError(Error, RuntimeError):
    """No compiler, or one that fails."""

    command: str = ""  #: as it is typed into a shell
    output: str = ""  #: what the compiler said


class LoadError(Error):
    """A compiled model that cannot be loaded, or that is of another version."""


class IntegrationError(Error, ArithmeticError):
    """An integration that cannot go on: when, and why."""


class InternalError(Error):
    """A mistake in kanec itself."""


class Note(UserWarning):
    """Category of warnings: a remark of reading a scene, or of the generator."""


def nearest(name: str, names: Iterable[str]) -> str:
    """" (did you mean accelerations?)", or nothing: the end of a message."""
    near = get_close_matches(name, list(names), 1)
    return f" (did you mean {near[0]}?)" if near else ""
