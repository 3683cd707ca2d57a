# What is refused: by which error, with which words; and that nothing is left behind by it.
# SPDX-License-Identifier: GPL-2.0-or-later
import os
import pickle
import resource
import signal
import threading
import time
import unittest

import kanec
import numpy as np
from bench import pendulum, shipped


class Refusals(unittest.TestCase):
    def refused(self, words, action, *arguments, error=kanec.InputError, **keywords):
        with self.assertRaises(error) as caught:
            action(*arguments, **keywords)
        self.assertIs(type(caught.exception), error)
        for word in (words,) if isinstance(words, str) else words:
            self.assertIn(word, str(caught.exception))
        return caught.exception


class Arguments(Refusals):
    @classmethod
    def setUpClass(cls):
        cls.model = shipped("cart_pole").compile(["accelerations", "residual"])
        cls.f = cls.model.accelerations
        cls.x, cls.y = np.array([0.5, 0.25]), np.array([-1.0, 2.0])

    def test_shapes(self):
        self.refused(("cart_pole, accelerations: x: found an array of float64, shape (3,)", "shape (2,), or (count, 2)"),
                     self.f, np.zeros(3), self.y)
        self.refused("y: found nothing; allowed: an array of shape (2,)", self.f, self.x)
        self.refused("y: found nothing; allowed: an array of shape (4, 2)", self.f, np.zeros((4, 2)))
        self.refused("ydot: found nothing", self.model.residual, self.x, self.y)
        self.refused("x: found an array of float64, shape (1, 1, 2)", self.f, np.zeros((1, 1, 2)), self.y)
        self.refused("x: found an array of float64, shape ()", self.f, 3.0, self.y)
        self.refused(("y: found an array of float64, shape (4, 2)", "3 states, as an array of float64, shape (3, 2)"),
                     self.f, np.zeros((3, 2)), np.zeros((4, 2)))
        self.refused("push: found an array of float64, shape (4,); allowed: 3 states", self.f, np.zeros((3, 2)), self.y,
                     push=np.zeros(4))
        self.refused("push: found an array of float64, shape (3, 1); allowed: a number, or", self.f, np.zeros((3, 2)),
                     self.y, push=np.zeros((3, 1)))
        self.refused("t: found an array of float64, shape (2,); allowed: 3 states", self.f, np.zeros((3, 2)), self.y,
                     t=np.zeros(2))

    def test_kinds_of_numbers(self):
        for kind, name in ((complex, "complex128"), (object, "object"), (str, "<U"), (bool, "bool"),
                           ("M8[s]", "datetime64")):
            self.refused(("x: found an array of " + name, "allowed: real numbers"), self.f, np.zeros(2, kind), self.y)
            self.refused("allowed: real numbers", self.f, np.zeros((3, 2), kind), self.y)
        self.refused("x: found a str", self.f, "ab", self.y)
        self.refused("x: found a list", self.f, [[1], [1, 2]], self.y)
        for bad in ("a", 1j, True, None, np.complex64(1), np.bool_(1)):
            self.refused(("push: found", "allowed: a number"), self.f, self.x, self.y, push=bad)
            self.refused(("push: found", "allowed: a number"), self.f, [self.x], [self.y], push=bad)
        self.refused("t: found a str; allowed: a number", self.f, self.x, self.y, t="0")
        self.refused("an integer beyond all numbers", self.f, self.x, self.y, t=10**400)

    def test_numbers_that_are_not_finite(self):
        self.refused("found nan; allowed: finite numbers", self.f, self.x, self.y, push=np.nan)
        self.refused("allowed: finite numbers", self.f, [self.x], [self.y], push=np.inf)
        self.refused("allowed: finite numbers", self.f, [self.x], [self.y], m_cart=np.array([np.nan]))

    def test_names(self):
        self.refused(("the keyword pusch", "m_cart", "did you mean push?"), self.f, self.x, self.y, pusch=1)
        self.refused("did you mean accelerations?", self.model.__getitem__, "acelerations")
        self.refused("no function acelerations (did you mean accelerations?)", getattr, self.model, "acelerations",
                     error=AttributeError)
        self.assertFalse(hasattr(self.model, "forcing"))
        self.refused("accelerations() takes x, y and ydot", self.f, 1, 2, 3, 4, error=TypeError)
        self.refused("found y twice", self.f, self.x, self.y, y=self.y, error=TypeError)

    def test_results_given(self):
        frozen = np.zeros(2)
        frozen.flags.writeable = False
        for out in (np.zeros(3), np.zeros(2, "f4"), np.zeros((1, 2)), np.zeros(4)[::2], frozen, [0.0, 0.0]):
            self.refused("out: found", self.f, self.x, self.y, out=out)
        for out in (np.zeros(2), np.zeros((3, 2), "f4"), np.zeros((3, 4))[:, ::2], np.zeros((2, 2))):
            self.refused("out: found", self.f, np.zeros((3, 2)), self.y, out=out)
        self.refused("out: found memory of y; allowed: an array of its own", self.f, self.x, self.y, out=self.y)
        many = np.zeros((3, 2))
        self.refused("out: found memory of x", self.f, many, self.y, out=many)

    def test_what_was_refused_has_changed_nothing(self):
        wanted, y = self.f(self.x, self.y), self.y.copy()
        self.refused("finite", self.f, self.x, self.y, push=np.nan, m_cart=7.0)
        self.refused("out", self.f, self.x, self.y, out=self.y)
        np.testing.assert_array_equal(self.f(self.x, self.y), wanted)
        np.testing.assert_array_equal(self.y, y)

    def test_refusals_keep_no_memory(self):
        bad, short = np.zeros(2, complex), np.zeros(1)

        def refuse(count):
            for _ in range(count):
                for action in (lambda: self.f(bad, self.y), lambda: self.f(short, self.y),
                               lambda: self.f(self.x, self.y, pusch=1), lambda: self.f(self.x, self.y, push=np.nan)):
                    try:
                        action()
                    except kanec.InputError:
                        pass

        refuse(2000)
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        refuse(10000)
        grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
        self.assertLess(grown, 1024)  # [KiB]; 100 bytes a refusal were 3900


class Causes(Refusals):
    def test_classes(self):
        for error, builtin in ((kanec.InputError, ValueError), (kanec.SceneError, ValueError),
                               (kanec.FileError, OSError), (kanec.BuildError, RuntimeError),
                               (kanec.IntegrationError, ArithmeticError),
                               (kanec.LoadError, Exception), (kanec.InternalError, Exception)):
            self.assertTrue(issubclass(error, kanec.Error) and issubclass(error, builtin))
        self.assertTrue(issubclass(kanec.Note, UserWarning))

    def test_scenes(self):
        error = self.refused("mine.toml:1: name: found 3", kanec.parse, "name = 3", "mine.toml", error=kanec.SceneError)
        self.assertEqual((error.file, error.line, error.field, error.found), ("mine.toml", 1, "name", "3"))
        self.assertIn("identifier", error.allowed)
        tables = pendulum()
        tables["body"][0]["mass"] = -1
        error = self.refused("mass", kanec.build, tables, error=kanec.SceneError)
        self.assertEqual((error.body, error.field), ("body 1 (rod)", "mass"))
        self.assertEqual(vars(pickle.loads(pickle.dumps(error))), vars(error))
        self.refused("mass", shipped("cart_pole").with_values, m_cart=-1, error=kanec.SceneError)
        self.refused("forward reference", kanec.tree, [0, 3], error=kanec.SceneError)

    def test_tables(self):
        tables = pendulum()
        for bad in ({1}, None, 1j, b"rod", object(), np.array([1j]), [None], {"a": None}):
            tables["body"][0]["mass"] = bad
            self.refused("body[0].mass", kanec.build, tables)
        self.refused("the key 3; allowed: keys that are a str", kanec.build, {3: 1})
        self.refused("integers of 64 bits", kanec.build, {"name": 2**70})
        self.refused("valid Unicode", kanec.build, {"name": "\ud800"})
        endless = []
        endless.append(endless)
        self.refused("levels", kanec.build, {"name": endless})

    def test_files(self):
        self.assertIn("/no/such", str(self.refused("No such file", kanec.read, "/no/such", error=kanec.FileError)))

    def test_settings(self):
        scene = shipped("cart_pole")
        self.refused("did you mean push?", scene.with_values, pusch=1)
        self.refused("m_cart: found a str; allowed: a number", scene.with_values, {"m_cart": "1"})
        self.refused("allowed: text, latex, json", scene.derive, "html")
        self.refused("did you mean accelerations?", scene.results, "acelerations")
        self.refused("functions: found 3", scene.compile, 3)
        self.refused("functions: found [3]", scene.compile, [3])
        self.refused("nothing", scene.compile, ["nothing"])
        self.refused("allowed: cpp, c", scene.generate, language="rust")
        self.refused("threads: found -1", scene.compile, threads=-1)
        self.refused("states: found 0", scene.check, "accelerations", states=0)
        self.refused("integrator: found 'euler'", scene.simulate, integrator="euler")
        self.refused("did you mean push?", scene.simulate, pusch=1)
        self.refused("cart_pole: x: found", scene.simulate, [1.0])
        self.refused("y: found nan", scene.simulate, y=[np.nan, 0.0])

    def test_compilers(self):
        scene = shipped("pendulum")
        error = self.refused("status 1", scene.compile, "energy", flags="-O0 -fno-such-flag", use_cache=False,
                             error=kanec.BuildError)
        self.assertIn("-fno-such-flag", error.command)
        self.assertIn("-fno-such-flag", error.output)
        self.refused("", scene.compile, "energy", flags="-O0 -Dkanec_model_entry=another", use_cache=False,
                     error=kanec.LoadError)

    def test_integrations(self):
        slide = {"name": "slide", "joint": "prismatic", "axis": "x", "mass": 1.0, "inertia": [0, 0, 0],
                 "effort": "s_slide^3", "initial": {"s": 1.0, "sdot": 1.0}}
        scene = kanec.build({"name": "runaway", "connection": [0], "body": [slide]})
        self.refused("t = ", scene.simulate, duration=10.0, error=kanec.IntegrationError)


class Interrupts(unittest.TestCase):
    def interrupted(self, action):
        timer = threading.Timer(0.4, os.kill, (os.getpid(), signal.SIGINT))
        begin = time.perf_counter()
        with self.assertRaises(KeyboardInterrupt):
            timer.start()
            try:
                action()
            finally:
                timer.cancel()
        self.assertLess(time.perf_counter() - begin, 20)

    def test_end_simulations(self):
        scene = shipped("cart_pole")
        scene.simulate(duration=0.1)
        self.interrupted(lambda: scene.simulate(duration=1e7, output_step=1e4))

    def test_end_compilations(self):
        scene = kanec.tree([0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11])
        self.interrupted(lambda: scene.compile(use_cache=False))


if __name__ == "__main__":
    unittest.main()
