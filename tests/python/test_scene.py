# Scenes: read, parsed, built; what they say of themselves, and what is generated of them. Not: compiled models.
# SPDX-License-Identifier: GPL-2.0-or-later
import json
import pathlib
import re
import tempfile
import unittest
import warnings

import kanec
import numpy as np
from bench import ROOT, pendulum, shipped


def remarkable():
    """Its axis is y but for rounding."""
    tables = pendulum()
    tables["body"][0]["axis"] = [1e-17, 1.0, 0.0]
    return tables


class Scenes(unittest.TestCase):
    def test_tell_their_states_parameters_and_functions(self):
        scene = shipped("cart_pole")
        self.assertEqual((scene.name, scene.bodies, scene.connection), ("cart_pole", ["cart", "pole"], [0, 1]))
        self.assertEqual((scene.nx, scene.ny), (2, 2))
        self.assertEqual([(part.name, part.unit, part.begin) for part in scene.x.parts],
                         [("theta_pole", "rad", 0), ("s_cart", "m", 1)])
        self.assertEqual(scene.ydot.parts[0].unit, "rad/s^2")
        self.assertEqual(scene.parameters, {"m_cart": 1.0, "mu": 0.05})
        self.assertEqual(scene.inputs, {"push": 0.0})
        np.testing.assert_array_equal(scene.initial_x, [0.02, 0.0])
        np.testing.assert_array_equal(scene.initial_y, [0.0, 0.0])
        offer = scene.functions["mass_matrix"]
        self.assertEqual((offer.reads, offer.result.rows, offer.result.parts[0].shape),
                         (("x",), ["thetadot_pole", "sdot_cart"], (2, 2)))
        self.assertEqual([shape.name for shape in scene.results("kinematics+accelerations")],
                         [scene.functions["kinematics"].result.name, scene.functions["accelerations"].result.name])
        self.assertEqual(scene.run["duration"], 5.0)

    def test_are_read_from_folders_files_and_texts_alike(self):
        folder = ROOT / "models" / "pendulum"
        by_folder, by_file = kanec.read(str(folder)), kanec.read(folder / "scene.toml")
        by_text = kanec.parse((folder / "scene.toml").read_text())
        self.assertEqual(by_folder.text, by_file.text)
        self.assertEqual(by_folder.text, by_text.text)
        self.assertEqual(kanec.parse(by_text.text).text, by_text.text)

    def test_built_of_dicts_are_those_of_the_same_text(self):
        text = """name = "pendulum"
connection = [0]
gravity = [0.0, 0.0, -9.81]
[parameters]
c = 0.25
[[body]]
name = "rod"
joint = "revolute"
axis = "y"
mass = 1.2
inertia = [0.1, 0.1, 0.0]
r = [0.0, 0.0, -0.5]
"""
        self.assertEqual(kanec.build(pendulum(parameters={"c": 0.25})).text, kanec.parse(text).text)

    def test_are_built_of_numpy_numbers_and_arrays(self):
        plain = kanec.build(pendulum())
        tables = pendulum(connection=np.array([0]), gravity=np.array([0, 0, -9.81]))
        tables["body"][0].update(mass=np.float64(1.2), inertia=np.diag([0.1, 0.1, 0.0]), r=(0.0, np.int64(0), -0.5))
        model = kanec.build(tables).compile("accelerations")
        x, y = [0.7], [0.2]
        np.testing.assert_array_equal(model.accelerations(x, y), plain.compile("accelerations").accelerations(x, y))

    def test_with_other_values_are_others(self):
        scene = shipped("cart_pole")
        heavy = scene.with_values({"m_cart": 3.0}, push=2)
        self.assertEqual((heavy.parameters["m_cart"], heavy.inputs["push"]), (3.0, 2.0))
        self.assertEqual(scene.parameters["m_cart"], 1.0)
        model = heavy.compile("accelerations")
        self.assertEqual((model.parameters["m_cart"], model.inputs), (3.0, {"push": 2.0}))
        x, y = [0.3, 0.1], [0.5, -0.2]
        np.testing.assert_array_equal(model.accelerations(x, y),
                                      scene.compile("accelerations").accelerations(x, y, m_cart=3.0, push=2.0))
        np.testing.assert_allclose(model.accelerations([x], [y])[0], model.accelerations(x, y), rtol=1e-13)

    def test_of_connection_arrays_are_symbolic(self):
        scene = kanec.tree([0, 1, 1])
        self.assertEqual((scene.connection, scene.nx, scene.ny), ([0, 1, 1], 21, 18))
        self.assertTrue(scene.parameters)

    def test_warn_with_their_remarks(self):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            scene = kanec.build(remarkable())
        self.assertEqual(len(caught), 1)
        self.assertEqual([str(one.message) for one in caught], scene.remarks)
        self.assertIn("were made exact", scene.remarks[0])
        self.assertIs(caught[0].category, kanec.Note)
        self.assertEqual(caught[0].filename, __file__)

    def test_warnings_may_be_errors(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error", kanec.Note)
            with self.assertRaises(kanec.Note):
                kanec.build(remarkable())

    def test_derive_text_latex_and_json(self):
        scene = shipped("cart_pole")
        self.assertIn("A ydot = f", scene.derive())
        self.assertIn("\\begin{document}", scene.derive("latex"))
        self.assertEqual(json.loads(scene.derive("json"))["model"], "cart_pole")

    def test_show_their_equations_in_a_notebook(self):
        for name in ("cart_pole", "every_joint", "six_body"):
            display = shipped(name)._repr_latex_()
            self.assertTrue(display.startswith("$$\\begin{aligned}") and display.endswith("\\end{aligned}$$"))
            self.assertEqual(display.count("{") - display.count("\\{"), display.count("}") - display.count("\\}"))
            self.assertNotIn("\\brk", display)
            self.assertIsNone(re.search(r"\\text\{[^}]*\\_", display))  # MathJax shows the backslash of it
            self.assertLess(len(re.findall("&", display)), 102)
        self.assertIn("A\\dot y &= f", display)
        self.assertIsNone(kanec.tree([0] * 40)._repr_latex_())

    def test_generate_what_the_command_does(self):
        scene = shipped("cart_pole")
        header = (ROOT / "generated" / "cart_pole" / "cart_pole.hpp").read_text()
        self.assertEqual(scene.generate(), {"cart_pole.hpp": header})
        self.assertEqual(list(scene.generate("accelerations", language="c")), ["cart_pole.h"])
        self.assertEqual(list(scene.generate(["accelerations"], abi=True, taylor=True)),
                         ["cart_pole.hpp", "cart_pole_abi.cpp", "abi.h", "cart_pole_taylor.hpp"])
        self.assertNotEqual(scene.generate("mass_matrix"), scene.generate("mass_matrix", optimize="size"))

    def test_check_their_compiled_code(self):
        agreed = shipped("cart_pole").check(["accelerations", "mass_matrix"], states=8, seed=3)
        self.assertEqual([(one.function, one.passed) for one in agreed],
                         [("accelerations", True), ("mass_matrix", True)])
        self.assertLess(agreed[0].generic, 1e-12)

    def test_compile_into_the_cache_that_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            shipped("pendulum").compile("energy", cache=folder)
            self.assertTrue(any(path.is_file() for path in pathlib.Path(folder).rglob("*")))


if __name__ == "__main__":
    unittest.main()
