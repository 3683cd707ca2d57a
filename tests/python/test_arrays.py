# What may stand for an argument: kinds of numbers, orders of memory, results given. Not: what is refused (test_errors).
# SPDX-License-Identifier: GPL-2.0-or-later
import unittest

import numpy as np
from bench import shipped


class Arrays(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.model = shipped("cart_pole").compile(["accelerations", "mass_matrix"])
        cls.x, cls.y = np.array([0.5, 0.25]), np.array([-1.0, 2.0])
        cls.wanted = cls.model.accelerations(cls.x, cls.y)

    def same(self, *arguments, **keywords):
        np.testing.assert_array_equal(self.model.accelerations(*arguments, **keywords), self.wanted)

    def test_lists_and_tuples_and_keywords(self):
        self.same([0.5, 0.25], (-1, 2))
        self.same(y=self.y, x=self.x)
        self.same(self.x, self.y, None, t=None)

    def test_other_kinds_of_real_numbers(self):
        for kind in ("f2", "f4", "f16", ">f8"):
            self.same(self.x.astype(kind), self.y.astype(kind))
        for kind in ("i1", "i8", "u2"):
            np.testing.assert_array_equal(self.model.accelerations(np.array([1, 0], kind), self.y),
                                          self.model.accelerations([1.0, 0.0], self.y))

    def test_arrays_with_gaps(self):
        gaps = np.zeros((2, 3))
        gaps[:, 1] = self.x
        self.same(gaps[:, 1], self.y[::-1][::-1])
        self.same(self.x[::-1].copy()[::-1], self.y)

    def test_arrays_that_are_not_aligned_or_not_writeable(self):
        raw = np.zeros(17, np.uint8)
        odd = raw[1:].view(np.float64)
        odd[:] = self.x
        frozen = self.y.copy()
        frozen.flags.writeable = False
        self.assertFalse(odd.flags.aligned)
        self.same(odd, frozen)

    def test_subclasses_of_arrays(self):
        self.same(self.x.view(np.recarray), np.ma.array(self.y))

    def test_arguments_stay_as_they_are(self):
        x, y = self.x.copy(), self.y.copy()
        self.model.accelerations(x, y)
        self.model.accelerations(np.array([x]), np.array([y]))
        np.testing.assert_array_equal([x, y], [self.x, self.y])

    def test_results_are_written_where_asked(self):
        out = np.full(2, np.nan)
        self.assertIs(self.model.accelerations(self.x, self.y, out=out), out)
        np.testing.assert_array_equal(out, self.wanted)
        rows = np.full((3, 2), np.nan)
        self.model.accelerations(self.x, self.y, out=rows[1])
        np.testing.assert_array_equal(rows[1], self.wanted)
        self.assertTrue(np.isnan(rows[[0, 2]]).all())
        A = np.empty((2, 2))
        self.assertIs(self.model.mass_matrix(self.x, out=A), A)

    def test_results_are_new_arrays(self):
        first = self.model.accelerations(self.x, self.y)
        second = self.model.accelerations(2 * self.x, self.y)
        self.assertFalse(np.shares_memory(first, second))
        self.assertTrue(first.flags.owndata and first.flags.writeable)


if __name__ == "__main__":
    unittest.main()
