# The types that checkers read are those of the module: names, and that all of it is documented.
# SPDX-License-Identifier: GPL-2.0-or-later
import ast
import pathlib
import unittest

import kanec

EXTRA = {"__call__", "__getitem__", "__getattr__", "__len__", "_repr_latex_"}


def public(names):
    return {name for name in names if not name.startswith("_") or name in EXTRA}


class Stubs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = pathlib.Path(kanec.__file__).parent
        cls.tree = ast.parse((folder / "_kanec.pyi").read_text())
        cls.folder = folder

    def test_have_the_names_of_the_module(self):
        defined = {node.name for node in self.tree.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
        self.assertEqual(defined, public(dir(kanec._kanec)))
        self.assertTrue((self.folder / "py.typed").exists())
        self.assertTrue(defined <= set(kanec.__all__))

    def test_have_the_members_of_every_class(self):
        for node in self.tree.body:
            if not isinstance(node, ast.ClassDef):
                continue
            stub = {member.name for member in node.body if isinstance(member, ast.FunctionDef)}
            self.assertEqual(stub, public(vars(getattr(kanec, node.name))), node.name)

    def test_everything_public_has_a_docstring(self):
        for name in set(kanec.__all__) - {"__version__"}:
            thing = getattr(kanec, name)
            self.assertTrue(thing.__doc__, name)
            if isinstance(thing, type) and not issubclass(thing, BaseException):
                for member in public(vars(thing)) - EXTRA:
                    self.assertTrue(getattr(thing, member).__doc__, f"{name}.{member}")


if __name__ == "__main__":
    unittest.main()
