"""Common test code: the functions of the package, volumes, tools of the build, skipping."""

import gzip
import inspect
import os
import re
import subprocess
import sys
import tempfile
import unittest
import zlib
from pathlib import Path

import numpy as np

import shapeton
from shapeton import colon, flattening, graphs, shapes, surfaces

MODULES = (shapeton, colon, flattening, graphs, shapes, surfaces)
DATA = Path(os.environ.get("SHAPETON_DATA", "."))
TOOLS = os.environ.get("SHAPETON_TOOLS", "")

needs_tools = unittest.skipUnless(TOOLS, "SHAPETON_TOOLS, the folder of the tools, is not set")


def public_functions():
    """Returns by name the functions, constructors and methods of the package that are written in Python."""
    functions = {}
    for name, thing in ((name, getattr(module, name)) for module in MODULES for name in module.__all__):
        members = vars(thing).items() if inspect.isclass(thing) else [("", thing)]
        for member, function in members:
            if inspect.isfunction(function) and (member == "__init__" or not member.startswith("_")):
                functions[f"{name}.{member}".rstrip(".")] = function
    return functions


def run_tool(name, *arguments):
    """Runs a tool of the build; fails with its message, or if its progress is incomplete."""
    command = [os.path.join(TOOLS, name), *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    shares = [float(share) for share in re.findall("<filter-progress>(.*)</filter-progress>", done.stdout)]
    if shares and (shares != sorted(shares) or shares.count(1.0) != 1):
        raise AssertionError(f"the progress of {name} does not increase to 1 exactly once: {shares}")


def error_of_tool(name, *arguments):
    """Returns the message of a tool that must fail."""
    command = [os.path.join(TOOLS, name), *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode == 0:
        raise AssertionError(f"{name} did not fail")
    return done.stderr.strip()


def run_python(code, timeout=None, **variables):
    """Runs a program in another Python and returns its output. It must exit with status 0 within the time limit (s)."""
    environment = {**os.environ, **variables}
    command = [sys.executable, "-c", code]  # searches modules in the working folder first
    done = subprocess.run(
        command, capture_output=True, text=True, check=False, env=environment, cwd=os.sep, timeout=timeout
    )
    if done.returncode != 0 or done.stderr:
        raise AssertionError(f"status {done.returncode}: {done.stderr}")
    return done.stdout.strip()


#: Voxel type names of NRRD and MetaImage.
TYPES = {"float": "<f4", "short": "<i2", "unsigned char": "u1", "unsigned short": "<u2", "unsigned int": "<u4",
         "MET_FLOAT": "<f4", "MET_SHORT": "<i2", "MET_UCHAR": "u1", "MET_USHORT": "<u2", "MET_UINT": "<u4"}


def stored(path, shape):
    """The voxels of a file in their stored type, read without the package."""
    if ".nii" in path.suffixes:
        import nibabel

        return np.asarray(nibabel.load(path).dataobj).T
    end = b"ElementDataFile = LOCAL\n" if path.suffix == ".mha" else b"\n\n"
    header, _, voxels = path.read_bytes().partition(end)
    fields = dict(re.split(r"\s*[:=]+\s*", line, maxsplit=1) for line in header.decode().splitlines() if re.search("[:=]", line))
    if fields.get("encoding") == "gzip":
        voxels = gzip.decompress(voxels)
    elif fields.get("CompressedData") == "True":
        voxels = zlib.decompress(voxels)
    return np.frombuffer(voxels, TYPES[fields.get("type") or fields["ElementType"]]).reshape(shape)


def oblique():
    """Rotation matrix: 20 degrees about z, then 30 about x."""
    a, b = np.radians([20.0, 30.0])
    about_z = np.array([[np.cos(a), -np.sin(a), 0.0], [np.sin(a), np.cos(a), 0.0], [0.0, 0.0, 1.0]])
    about_x = np.array([[1.0, 0.0, 0.0], [0.0, np.cos(b), -np.sin(b)], [0.0, np.sin(b), np.cos(b)]])
    return about_x @ about_z


def balls(shape=(40, 36, 32), seed=1, noise=20.0):
    """A volume of bright balls in noise on an oblique grid with three spacings; float32."""
    random = np.random.default_rng(seed)
    z, y, x = np.ogrid[tuple(slice(n) for n in shape)]
    voxels = random.normal(0.0, noise, shape)
    for _ in range(5):
        center, radius = random.uniform(0.25, 0.75, 3) * shape, random.uniform(0.1, 0.25) * min(shape)
        inside = (z - center[0]) ** 2 + (y - center[1]) ** 2 + (x - center[2]) ** 2 < radius**2
        voxels[inside] += 500.0
    return shapeton.Image(voxels.astype(np.float32), (0.8, 0.9, 1.5), (-10.0, 20.0, 5.0), oblique())


def cylinder(radius, height, around=40, along=30):
    """An open tube about the z axis."""
    angles = np.linspace(0.0, 2.0 * np.pi, around, endpoint=False)
    levels = np.linspace(0.0, height, along + 1)
    vertices = [(radius * np.cos(a), radius * np.sin(a), z) for z in levels for a in angles]
    faces = []
    for row in range(along):
        for i in range(around):
            a, b = row * around + i, row * around + (i + 1) % around
            faces += [(a, b, b + around), (a, b + around, a + around)]
    return shapeton.Mesh(vertices, faces)


class TestCase(unittest.TestCase):
    """Base class of tests with a temporary folder."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def assertSame(self, one, other):
        """Asserts equal shape, type and bytes."""
        self.assertEqual((one.shape, one.dtype), (other.shape, other.dtype))
        self.assertEqual(one.tobytes(), other.tobytes())
