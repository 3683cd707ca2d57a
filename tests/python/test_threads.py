# One scene, one model, many threads. Oracle: the same calls one after another.
# SPDX-License-Identifier: GPL-2.0-or-later
import unittest
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from bench import random_states, shipped


class Threads(unittest.TestCase):
    def test_share_a_model(self):
        scene = shipped("cart_pole")
        model = scene.compile("accelerations")
        x, y, _ = random_states(scene, 200)
        pushes = np.linspace(-1, 1, 16)

        def single(push):
            return np.array([model.accelerations(a, b, push=push) for a, b in zip(x, y)])

        def many(push):
            return model.accelerations(x, y, push=np.full(200, push), m_cart=1 + abs(push))

        for work in (single, many):
            wanted = [work(push) for push in pushes]
            with ThreadPoolExecutor(8) as threads:
                found = list(threads.map(work, pushes))
            np.testing.assert_array_equal(found, wanted)

    def test_ask_for_many_states_first_at_the_same_time(self):
        scene = shipped("pendulum")
        model = scene.compile(["accelerations", "energy"])
        x, y, _ = random_states(scene, 50)
        with ThreadPoolExecutor(4) as threads:
            found = list(threads.map(lambda i: (model.accelerations, model.energy)[i % 2](x, y), range(8)))
        for i in range(2, 8):
            np.testing.assert_array_equal(found[i], found[i % 2])

    def test_long_functions_give_way_to_others(self):
        scene = shipped("bench_cr32")
        model = scene.compile("mass_matrix+accelerations")
        x, y, _ = random_states(scene, 8)
        function = model["mass_matrix+accelerations"]
        wanted = [function(*state) for state in zip(x, y)]
        with ThreadPoolExecutor(4) as threads:
            np.testing.assert_array_equal(list(threads.map(lambda i: function(x[i], y[i]), range(8))), wanted)

    def test_derive_generate_and_simulate_side_by_side(self):
        scene = shipped("cart_pole")
        work = [scene.derive, scene.generate, lambda: scene.simulate(duration=0.2).x.tolist(),
                lambda: sorted(scene.functions)]
        wanted = [one() for one in work]
        with ThreadPoolExecutor(8) as threads:
            found = list(threads.map(lambda i: work[i % 4](), range(24)))
        self.assertEqual(found, wanted * 6)


if __name__ == "__main__":
    unittest.main()
