"""Each tool runs with the arguments of a panel in 3D Slicer whose defaults were not touched, and writes only the outputs
that were chosen. Further outputs change no byte of these."""

import hashlib
import os
import shutil
import subprocess
import tempfile
import time
import unittest

from case import tools
from toolinputs import Tools, argumentsOfPanel, extensionOf, makeInputs, parametersOf

serving = ("ShapetonSession",)  # run until they are canceled
# Outputs that need more than the inputs of makeInputs().
special = {"dicomMap", "checkpoint", "snapshotFolder", "markers", "verdicts"}


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

    def testFurtherOutputsDoNotChangeTheResult(self):
        for name, values in sorted(self.inputs.items()):
            if name in serving or name == "ColonPhantom":
                continue
            description = os.path.join(tools, name + ".xml")
            with self.subTest(name), tempfile.TemporaryDirectory() as alone, tempfile.TemporaryDirectory() as more:
                further = []
                for parameter in parametersOf(description):
                    key = parameter.findtext("name")
                    isFurther = parameter.findtext("channel") == "output" and parameter.find("longflag") is not None
                    if isFurther and key not in special | set(values):
                        further += [f"--{key}", os.path.join(more, "further-" + key + extensionOf(parameter))]
                self.runTool(name, argumentsOfPanel(description, values, alone))
                self.runTool(name, further + argumentsOfPanel(description, values, more))
                before, after = contentOf(alone), contentOf(more)
                self.assertEqual([path for path in before if before[path] != after.get(path)], [])

    def runTool(self, name, arguments):
        done = subprocess.run([os.path.join(tools, name), *arguments], stdin=subprocess.DEVNULL, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, f"{arguments}: {done.stderr[-2000:]}")


def contentOf(folder):
    """The checksums of all files, except those that state times."""
    content = {}
    for place, _, files in os.walk(folder):
        for file in files:
            path = os.path.join(place, file)
            if not file.endswith("run.json") and file != "returned":
                with open(path, "rb") as opened:
                    content[os.path.relpath(path, folder)] = hashlib.sha256(opened.read()).hexdigest()
    return content


if __name__ == "__main__":
    unittest.main()
