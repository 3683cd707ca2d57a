# Simulations. Oracles: conserved energy, closed forms, the model's own derivatives.
# SPDX-License-Identifier: GPL-2.0-or-later
import gc
import math
import unittest

import kanec
import numpy as np
from bench import pendulum, shipped


class Motions(unittest.TestCase):
    def test_have_rows_of_every_output_step(self):
        motion = shipped("cart_pole").simulate(duration=1.0, output_step=0.125)
        np.testing.assert_allclose(motion.t, np.linspace(0, 1, 9), atol=1e-15)
        self.assertEqual((motion.x.shape, motion.y.shape, motion.kinetic.shape, len(motion)), ((9, 2), (9, 2), (9,), 9))
        self.assertEqual((motion.coordinates, motion.speeds), (["theta_pole", "s_cart"], ["thetadot_pole", "sdot_cart"]))
        self.assertGreater(motion.evaluations, motion.steps)
        self.assertFalse(motion.stopped)

    def test_keep_energy(self):
        motion = shipped("double_pendulum").simulate(duration=2.0)
        energy = motion.kinetic + motion.potential
        self.assertLess(np.abs(energy - energy[0]).max(), 1e-8)
        self.assertLess(motion.energy_error, 1e-9)

    def test_count_the_work_of_inputs(self):
        motion = shipped("cart_pole").simulate([0.0, 0.0], [0.0, 0.0], duration=1.0, push=1.0, mu=0.0)
        energy = motion.kinetic + motion.potential
        np.testing.assert_allclose(energy - energy[0], motion.work, atol=1e-8)
        np.testing.assert_allclose(motion.work, motion.x[:, 1], atol=1e-8)  # force times way
        self.assertEqual(motion.inputs, {"push": 1.0})

    def test_small_swings_have_their_period(self):
        length = (0.1 + 1.2 * 0.25) / (1.2 * 0.5)  # of the mathematical pendulum
        motion = kanec.build(pendulum()).simulate([1e-4], [0.0], duration=2.0, rtol=1e-12, atol=1e-16)
        np.testing.assert_allclose(motion.x[:, 0], 1e-4 * np.cos(math.sqrt(9.81 / length) * motion.t), atol=2e-12)

    def test_agree_between_integrators(self):
        scene = shipped("double_pendulum")
        ends = [scene.simulate(duration=0.5, integrator=name, rtol=1e-12, atol=1e-13).x[-1]
                for name in ("arkode", "taylor", "cvode")]
        np.testing.assert_allclose(ends[1:], [ends[0]] * 2, atol=1e-8)
        self.assertIn("taylor", kanec.integrators())
        coarse = scene.simulate(duration=0.5, integrator="rk4", step=0.01)
        self.assertEqual(coarse.steps, 50)

    def test_arrays_outlive_their_motion(self):
        x = shipped("pendulum").simulate(duration=0.1).x
        self.assertFalse(x.flags.owndata)
        kept = x.copy()
        gc.collect()
        np.testing.assert_array_equal(x, kept)

    def test_tell_events(self):
        scene = kanec.build(pendulum(event=[{"name": "bottom", "expression": "theta_rod", "action": "stop"}]))
        motion = scene.simulate([0.5], [0.0], duration=5.0)
        self.assertTrue(motion.stopped)
        self.assertEqual([(event.name, event.up) for event in motion.events], [("bottom", False)])
        self.assertAlmostEqual(motion.events[0].t, motion.t[-1], delta=1e-12)
        self.assertAlmostEqual(motion.x[-1, 0], 0.0, delta=1e-9)


if __name__ == "__main__":
    unittest.main()
