# The examples of docs/python.md: run as they stand there, with the output that stands behind them.
# SPDX-License-Identifier: GPL-2.0-or-later
import os
import re
import subprocess
import sys
import unittest

from bench import ROOT


class Documents(unittest.TestCase):
    def test_examples_print_what_stands_behind_them(self):
        page = (ROOT / "docs" / "python.md").read_text()
        examples = re.findall(r"```python\n(.*?)```\n\n```text\n(.*?)```", page, re.DOTALL)
        self.assertEqual(len(examples), page.count("```python\n"))
        self.assertGreaterEqual(len(examples), 4)
        for code, wanted in examples:
            ran = subprocess.run([sys.executable, "-W", "error", "-c", code], cwd=ROOT, env=os.environ,
                                 capture_output=True, text=True)
            self.assertEqual(ran.stderr, "")
            self.assertEqual(ran.stdout, wanted)


if __name__ == "__main__":
    unittest.main()
