# Many states at once. Oracle: the same states one by one.
# SPDX-License-Identifier: GPL-2.0-or-later
import unittest

import numpy as np
from bench import random_states, shipped


class ManyStates(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scene = shipped("cart_pole")
        cls.model = cls.scene.compile(["accelerations", "residual", "mass_matrix", "kinematics+accelerations"])
        cls.count = 101  # not a multiple of the lanes
        cls.x, cls.y, cls.ydot = random_states(cls.scene, cls.count)

    def near(self, found, wanted, relative=1e-13):
        self.assertEqual(found.shape, np.shape(wanted))
        np.testing.assert_allclose(found, wanted, rtol=relative, atol=relative * np.abs(wanted).max())

    def one_by_one(self, name, *states, **values):
        each = {key: np.broadcast_to(value, self.count) for key, value in values.items()}
        return np.array([self.model[name](*(s[i] for s in states), **{key: value[i] for key, value in each.items()})
                         for i in range(self.count)])

    def test_are_those_one_by_one(self):
        states = self.x, self.y, self.ydot
        for name, n in (("accelerations", 2), ("residual", 3), ("mass_matrix", 1), ("kinematics+accelerations", 2)):
            self.near(self.model[name](*states[:n]), self.one_by_one(name, *states[:n]))

    def test_of_quaternions_as_well(self):
        scene = shipped("six_body")
        model = scene.compile("accelerations")
        x, y, _ = random_states(scene, 9)
        self.near(model.accelerations(x, y), np.array([model.accelerations(*state) for state in zip(x, y)]), 1e-11)

    def test_in_any_order_of_memory(self):
        wanted = self.model.accelerations(self.x, self.y)
        fortran = self.model.accelerations(np.asfortranarray(self.x), np.asfortranarray(self.y))
        self.near(fortran, wanted)
        self.assertTrue(fortran.flags.f_contiguous)
        self.assertTrue(self.model.accelerations(self.x, np.asfortranarray(self.y)).flags.c_contiguous)
        self.near(self.model.accelerations(self.x, np.asfortranarray(self.y)), wanted)
        wide = np.zeros((self.count, 5))
        wide[:, 1:3] = self.x
        self.near(self.model.accelerations(wide[:, 1:3], self.y[::-1].copy()[::-1]), wanted)
        self.near(self.model.mass_matrix(np.asfortranarray(self.x)), self.model.mass_matrix(self.x))
        self.near(self.model.accelerations(self.x.tolist(), self.y), wanted)

    def test_are_written_where_asked(self):
        wanted = self.model.accelerations(self.x, self.y)
        for order in "CF":
            for given in "CF":
                out = np.full(self.x.shape, np.nan, order=order)
                x, y = np.asarray(self.x, order=given), np.asarray(self.y, order=given)
                self.assertIs(self.model.accelerations(x, y, out=out), out)
                self.near(out, wanted)

    def test_in_float_where_all_are(self):
        x, y = self.x.astype("f4"), self.y.astype("f4")
        found = self.model.accelerations(x, y)
        self.assertEqual(found.dtype, np.float32)
        self.near(found, self.model.accelerations(x.astype("f8"), y.astype("f8")).astype("f4"), 2e-5)
        self.assertEqual(self.model.accelerations(x, self.y).dtype, np.float64)
        out = np.empty((self.count, 2), "f4")
        self.model.accelerations(x, y, push=np.ones(self.count), out=out)
        self.near(out, self.model.accelerations(x, y, push=1))

    def test_values_for_all_and_for_each(self):
        push, mass = np.linspace(-1, 1, self.count), np.linspace(1, 3, self.count)
        for values in ({"push": 2.0}, {"push": push}, {"m_cart": mass}, {"m_cart": 2.0, "push": push},
                       {"m_cart": mass, "push": push, "mu": 0.0}):
            for order in "CF":
                x, y = np.asarray(self.x, order=order), np.asarray(self.y, order=order)
                found = self.model.accelerations(x, y, **values)
                self.near(found, self.one_by_one("accelerations", self.x, self.y, **values))
        self.near(self.model.accelerations(self.x, self.y), self.one_by_one("accelerations", self.x, self.y))

    def test_fewer_states_after_values_for_each(self):
        self.model.accelerations(self.x, self.y, m_cart=np.full(self.count, 9.0))
        wanted = self.one_by_one("accelerations", self.x, self.y)[:3]
        self.near(self.model.accelerations(self.x[:3], self.y[:3]), wanted)

    def test_one_dimension_holds_for_all(self):
        x, push = np.array([0.2, 0.1]), np.linspace(-1, 1, self.count)
        wanted = np.array([self.model.accelerations(x, y) for y in self.y])
        self.near(self.model.accelerations(x, self.y), wanted)
        found = self.model.accelerations(x, self.y[0], push=push)
        self.near(found, np.array([self.model.accelerations(x, self.y[0], push=p) for p in push]))

    def test_times_for_all_and_for_each(self):
        scene = shipped("slider_crank")
        model = scene.compile("accelerations")
        x, y, _ = random_states(scene, 10)
        t = np.linspace(0, 1, 10)
        wanted = np.array([model.accelerations(a, b, t=c) for a, b, c in zip(x, y, t)])
        self.near(model.accelerations(x, y, t=t), wanted, 1e-12)
        wanted = np.array([model.accelerations(a, b, t=0.5) for a, b in zip(x, y)])
        self.near(model.accelerations(x, y, t=0.5), wanted, 1e-12)

    def test_none_and_one(self):
        self.assertEqual(self.model.mass_matrix(np.zeros((0, 2))).shape, (0, 2, 2))
        self.near(self.model.mass_matrix(self.x[:1]), self.model.mass_matrix(self.x[0])[None])

    def test_do_not_depend_on_the_number_of_threads(self):
        x, y, _ = random_states(self.scene, 20000)
        found = [self.scene.compile("accelerations", threads=n).accelerations(x, y) for n in (1, 3)]
        np.testing.assert_array_equal(found[0], found[1])


if __name__ == "__main__":
    unittest.main()
