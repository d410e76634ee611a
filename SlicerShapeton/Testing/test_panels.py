"""Each tool runs with the arguments of a panel in 3D Slicer whose defaults were not touched, and writes only the outputs
that were chosen."""

import os
import shutil
import subprocess
import tempfile
import time
import unittest

from case import tools
from toolinputs import Tools, argumentsOfPanel, makeInputs

serving = ("ShapetonSession",)  # run until they are canceled


class PanelTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = tempfile.mkdtemp()
        cls.addClassCleanup(shutil.rmtree, cls.work)
        cls.inputs = makeInputs(Tools(tools), cls.work, os.environ["SHAPETON_PATIENT"])

    def testEveryToolIsListed(self):
        described = {name[:-4] for name in os.listdir(tools) if name.endswith(".xml")}
        self.assertEqual(set(self.inputs), described)

    def testApplyRunsWithUntouchedDefaults(self):
        for name, values in sorted(self.inputs.items()):
            with self.subTest(name), tempfile.TemporaryDirectory() as outputs, tempfile.TemporaryDirectory() as current:
                arguments = argumentsOfPanel(os.path.join(tools, name + ".xml"), values, outputs)
                process = subprocess.Popen(
                    [os.path.join(tools, name), *arguments],
                    cwd=current, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                )
                if name in serving:
                    while "http://" not in process.stdout.readline():
                        self.assertIsNone(process.poll(), name)
                    process.terminate()
                begin = time.monotonic()
                output, _ = process.communicate()
                print(f"{name}: {time.monotonic() - begin:.1f} s", flush=True)
                if name not in serving:
                    self.assertEqual(process.returncode, 0, f"{arguments}: {output[-2000:]}")
                self.assertEqual(os.listdir(current), [], f"{name} writes files that nobody chose")


if __name__ == "__main__":
    unittest.main()
