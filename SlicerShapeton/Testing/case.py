"""Common test code: the Slicer stub, the tested tools (SHAPETON_TOOLS), a folder per test."""

import os
import resource
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

here = os.path.dirname(os.path.abspath(__file__))
extension = os.path.dirname(here)
sys.path[:0] = [os.path.join(here, "standin"), extension]
sys.path += [os.path.join(extension, module) for module in ("ShapetonColonoscopy", "ShapetonHeat")]

try:
    import numpy  # noqa: F401
    import vtk  # noqa: F401
except ImportError as error:
    print(f"skipped: {error}; install python3-vtk9 and python3-numpy")
    sys.exit()

import slicer  # noqa: E402  the stub

tools = os.environ["SHAPETON_TOOLS"]
hangingSeconds = 600.0  # a longer wait is a hang; steps of a test take seconds, on a busy machine minutes


def tool(name, *arguments):
    subprocess.run([os.path.join(tools, name), *map(str, arguments), "--quiet"], check=True)


def finish(run):
    while not run.poll():
        time.sleep(0.02)


def waitFor(condition, poll, state=lambda: None):
    """Polls until the condition is true. Other processes may slow this down without limit."""
    end = time.monotonic() + hangingSeconds
    while not condition():
        poll()
        assert time.monotonic() < end, state()
        time.sleep(0.005)


def numberOfWaits():
    """How often this thread has waited for something: a blocking call increases it, the load of the machine does not."""
    return resource.getrusage(resource.RUSAGE_THREAD).ru_nvcsw


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        slicer.util._settings["Shapeton/ToolsFolder"] = tools

    def phantom(self):
        """A cube and two spheres."""
        path = os.path.join(self.folder, "phantom.nrrd")
        tool("ShapePhantom", path, "--shape", "figure2.7a", "--size", "48,48,48")
        return path
