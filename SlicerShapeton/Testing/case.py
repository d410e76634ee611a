"""Common test code: the Slicer stub, the tested tools (SHAPETON_TOOLS), a folder per test."""

import os
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


def tool(name, *arguments):
    subprocess.run([os.path.join(tools, name), *map(str, arguments), "--quiet"], check=True)


def finish(run):
    while not run.poll():
        time.sleep(0.02)


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
