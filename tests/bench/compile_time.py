#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Compile time, code bytes and run time of one function as a straight line and as loops, for docs/compile_time.md.

    python3 tests/bench/compile_time.py build/kanec chain 64 residual

Trees: chain, star, random; revolute joints about x, y and z in turn. CPU seconds of the compiler, and the least of many
single evaluations [ns], forms taken in turn, so that another load on the machine disturbs all alike.
"""
import pathlib
import random
import resource
import subprocess
import sys
import tempfile

FLAGS = ["-std=c++17", "-march=native", "-fno-math-errno", "-fno-tree-slp-vectorize"]
CALLS = {"residual": "residual(c, x, y, ydot, u, out)", "accelerations": "accelerations(c, x, y, u, out)"}


def scene(tree, bodies):
    draw = random.Random(7)
    lower = {"chain": lambda k: k - 1, "star": lambda k: min(k - 1, 1),
             "random": lambda k: draw.randint(1, k - 1) if k > 1 else 0}[tree]
    lines = [f'name = "tree"\nconnection = {[lower(k) for k in range(1, bodies + 1)]}\ngravity = [0.0, 0.0, -9.81]\n[inputs]']
    lines += [f"tau_{k} = 0.0" for k in range(1, bodies + 1)]
    for k in range(1, bodies + 1):
        m = 1 + 0.1 * k
        inertia = [[round(m * v, 12) for v in row]
                   for row in ([0.10, 0.005, 0.003], [0.005, 0.12, -0.004], [0.003, -0.004, 0.08])]
        q = f"\nq = [0.3, {round(0.05 * (k % 64), 10)}, 0.1]" if k > 1 else ""
        lines.append(f'[[body]]\njoint = "revolute"\naxis = "{"xyz"[k % 3]}"\neffort = "tau_{k}"\nmass = {round(m, 10)}\n'
                     f"inertia = {inertia}\nr = [0.1, 0.2, 0.05]{q}")
    return "\n".join(lines) + "\n"


def program(function, calls):
    return f"""#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include "tree.hpp"
namespace model = kanec::tree;
int main() {{
  static double x[model::nx], y[model::ny], ydot[model::ny], out[model::ny];
  for (int i = 0; i < model::nx; ++i) x[i] = std::sin(1.7 * i), y[i] = std::cos(1.3 * i), ydot[i] = std::sin(0.9 * i);
  const auto c = model::prepare(model::Parameters<double>{{}});
  const model::Inputs<double> u{{}};
  double least = 1e300;
  for (int i = 0; i < {calls}; ++i) {{
    const auto start = std::chrono::steady_clock::now();
    model::{CALLS[function]};
    least = std::min(least, std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
    x[i % model::nx] += 1e-3 * out[0] / (1 + std::abs(out[0]));
  }}
  std::printf("%.0f\\n", least);
}}
"""


def cpu_seconds(command):
    def used():
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime
    before = used()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return used() - before


def main():
    kanec, tree, bodies, function = sys.argv[1], sys.argv[2], int(sys.argv[3]), sys.argv[4]
    forms = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "tree.toml").write_text(scene(tree, bodies))
        for form in ("line", "loops"):
            there = folder / form
            there.mkdir()
            derived = cpu_seconds([kanec, "generate", str(folder / "tree.toml"), "--functions", function, "--optimize", form,
                                   "-o", str(there)])
            (there / "main.cpp").write_text(program(function, 2000))
            for compiler in ("g++", "clang++"):
                for level in ("-O1", "-O2"):
                    run = there / (compiler + level)
                    seconds = cpu_seconds([compiler, *FLAGS, level, str(there / "main.cpp"), "-o", str(run)])
                    size = subprocess.run(["size", str(run)], capture_output=True, text=True, check=True).stdout.split()
                    forms.append((form, compiler, level, derived, seconds, int(size[6]), run))
        least = [1e300] * len(forms)
        for _ in range(5):
            for i, form in enumerate(forms):
                least[i] = min(least[i], float(subprocess.run([str(form[6])], capture_output=True, check=True).stdout))
    print(f"{tree} {bodies} {function}")
    for form, ns in zip(forms, least):
        print(f"  {form[0]:5} {form[1]:7} {form[2]}  derive {form[3]:5.2f} s  compile {form[4]:6.2f} s  code {form[5]:7}  {ns:8.0f} ns")


main()
