# Values of compiled functions, one state each, held against each other and against physics. Not: many states.
# SPDX-License-Identifier: GPL-2.0-or-later
import unittest

import kanec
import numpy as np
from bench import ROOT, random_states, shipped


class Values(unittest.TestCase):
    def test_residual_undoes_accelerations(self):
        for name in ("cart_pole", "six_body", "satellite"):
            scene = shipped(name)
            model = scene.compile(["accelerations", "residual", "mass_matrix", "forcing"])
            for x, y, _ in zip(*random_states(scene, 5)):
                ydot = model.accelerations(x, y, t=0.3)
                size = np.abs(model.mass_matrix(x)) @ np.abs(ydot) + 1
                self.assertLess(np.max(np.abs(model.residual(x, y, ydot, t=0.3)) / size), 1e-11, name)
                np.testing.assert_allclose(model.mass_matrix(x) @ ydot, model.forcing(x, y, t=0.3), atol=1e-10)

    def test_mass_matrix_gives_kinetic_energy(self):
        scene = shipped("arm_6")
        model = scene.compile(["mass_matrix", "energy"])
        for x, y, _ in zip(*random_states(scene, 5)):
            A = model.mass_matrix(x)
            np.testing.assert_allclose(A, A.T, atol=1e-13)
            self.assertAlmostEqual(0.5 * y @ A @ y, model.energy(x, y)[0], delta=1e-12)

    def test_power_is_the_rate_of_energy(self):
        scene = shipped("cart_pole")
        model = scene.compile(["kinematics", "accelerations", "energy", "power"])
        x, y, h = np.array([0.4, 0.1]), np.array([0.3, -0.2]), 1e-5
        xdot, ydot = model.kinematics(x, y), model.accelerations(x, y, push=2.0)
        after, before = (model.energy(x + s * xdot, y + s * ydot).sum() for s in (h, -h))
        rate = (after - before) / (2 * h)
        self.assertAlmostEqual(rate, model.power(x, y, push=2.0)[0], delta=1e-8)

    def test_state_matrix_is_the_derivative(self):
        model = shipped("cart_pole").compile()
        z, h = np.array([0.4, 0.1, 0.3, -0.2]), 1e-6
        rates = lambda z: np.concatenate([model.kinematics(z[:2], z[2:]), model.accelerations(z[:2], z[2:])])
        columns = [(rates(z + h * e) - rates(z - h * e)) / (2 * h) for e in np.eye(4)]
        np.testing.assert_allclose(model.state_matrix(z[:2], z[2:]), np.column_stack(columns), atol=1e-7)

    def test_shapes_are_matrices_or_rows(self):
        scene = shipped("cart_pole")
        model = scene.compile(["mass_matrix", "input_matrix", "poses", "power", "kinematics+accelerations",
                               "partial_velocities"])
        wanted = {"mass_matrix": (2, 2), "input_matrix": (4, 1), "poses": (24,), "power": (1,),
                  "kinematics_and_accelerations": (4,), "partial_velocities": (12,)}
        self.assertEqual({name: f.shape for name, f in model.functions.items()}, wanted)
        for name, function in model.functions.items():
            self.assertEqual(function(scene.initial_x, scene.initial_y).shape, wanted[name])

    def test_results_are_split_by_name(self):
        model = shipped("cart_pole").compile(["poses", "kinematics+accelerations", "mass_matrix"])
        poses = model.poses([0.3, 0.5])
        parts = model.poses.results[0].split(poses)
        self.assertEqual(list(parts), ["R_cart", "p_cart", "R_pole", "p_pole"])
        np.testing.assert_allclose(parts["R_pole"] @ parts["R_pole"].T, np.eye(3), atol=1e-15)
        self.assertTrue(np.shares_memory(parts["R_pole"], poses))
        self.assertEqual(model.poses.results[0].split(np.zeros((7, 24)))["R_cart"].shape, (7, 3, 3))
        self.assertEqual(model["kinematics+accelerations"].results[1].parts[0].name, "thetaddot_pole")
        A = model.mass_matrix([0.3, 0.5])
        self.assertIs(model.mass_matrix.results[0].split(A)["A"], A)
        with self.assertRaises(kanec.InputError):
            model.poses.results[0].split(np.zeros(23))

    def test_combined_functions_return_one_after_another(self):
        model = shipped("satellite").compile(["kinematics", "accelerations", "kinematics+accelerations"])
        x, y, _ = (states[0] for states in random_states(shipped("satellite"), 1))
        both = model["kinematics+accelerations"]
        self.assertIs(both, model.kinematics_and_accelerations)
        wanted = np.concatenate([model.kinematics(x, y), model.accelerations(x, y)])
        np.testing.assert_allclose(both(x, y), wanted, rtol=1e-12)

    def test_keywords_hold_for_their_call_alone(self):
        model = shipped("cart_pole").compile(["accelerations", "forcing"])
        x, y = [0.3, 0.1], [0.5, -0.2]
        before = model.accelerations(x, y)
        pushed = model.forcing(x, y, push=2.0) - model.forcing(x, y)
        np.testing.assert_allclose(pushed, [0.0, 2.0], atol=1e-13)
        self.assertGreater(np.abs(model.accelerations(x, y, m_cart=2, mu=np.float32(0.5)) - before).max(), 0.01)
        np.testing.assert_array_equal(model.accelerations(x, y), before)
        self.assertEqual(model.parameters["m_cart"], 1.0)

    def test_time_is_read_where_it_is_given(self):
        model = kanec.read(ROOT / "models" / "slider_crank").compile(["accelerations"])
        scene = shipped("slider_crank")
        at = [model.accelerations(scene.initial_x, scene.initial_y, t=t) for t in (0.0, 0.5)]
        np.testing.assert_array_equal(model.accelerations(scene.initial_x, scene.initial_y), at[0])
        self.assertIn("t", model.accelerations.reads)
        self.assertGreater(np.abs(at[1] - at[0]).max(), 1e-3)

    def test_models_say_what_they_are(self):
        model = shipped("cart_pole").compile(["accelerations", "mass_matrix"])
        self.assertEqual((model.name, model.nx, model.ny), ("cart_pole", 2, 2))
        self.assertEqual((model.coordinates, model.speeds), (["theta_pole", "s_cart"], ["thetadot_pole", "sdot_cart"]))
        self.assertEqual((model.parameters, model.inputs), ({"m_cart": 1.0, "mu": 0.05}, {"push": 0.0}))
        self.assertEqual(model.accelerations.reads, ("x", "y", "inputs"))
        self.assertRegex(model.hash, "^[0-9a-f]{16}$")
        self.assertTrue({"accelerations", "mass_matrix"} <= set(dir(model)))
        self.assertIs(model.accelerations, model["accelerations"])
        self.assertIs(model.functions["mass_matrix"], model.mass_matrix)


if __name__ == "__main__":
    unittest.main()
