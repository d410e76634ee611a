"""pip reports missing build requirements in one sentence before the build starts."""

import importlib.util
import os
import subprocess
import sys
import unittest
from pathlib import Path

from support import TestCase

REPOSITORY = Path(__file__).parents[3]

ASK = """
import sys, sysconfig
utilities, packages, include, prefix = sys.argv[1:]
sys.path[:0] = [utilities, packages]
sysconfig.get_path = lambda name: include
import build_needs
build_needs.SYSTEM_PREFIXES = (prefix,)
print(build_needs.missing(), end="")
"""


class BuildNeedsTest(TestCase):
    """A simulated machine with all requirements, which can be removed one by one."""

    def setUp(self):
        super().setUp()
        self.write("packages/setuptools.py", "__version__ = '61.0.0'")
        self.write("packages/wheel.py", "")
        self.write("packages/numpy.py", f"get_include = lambda: {str(self.folder / 'numpy-headers')!r}")
        self.write("numpy-headers/numpy/arrayobject.h", "")
        self.write("include/Python.h", "")
        self.write("prefix/lib/cmake/pybind11/pybind11ConfigVersion.cmake", 'set(PACKAGE_VERSION "2.10.0")')
        self.write("bin/cmake", "#!/bin/sh\necho cmake version 3.22.1", 0o755)
        for program in ("make", "gcc", "g++"):
            self.write("bin/" + program, "#!/bin/sh", 0o755)

    def write(self, name, text, mode=0o644):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        path.chmod(mode)

    def missing(self, **variables):
        folders = [self.folder / name for name in ("packages", "include", "prefix")]
        command = [sys.executable, "-S", "-E", "-B", "-c", ASK, REPOSITORY / "Wrapping/Python/utilities", *folders]
        environment = {"PATH": str(self.folder / "bin"), **variables}  # -S: without the packages of this Python
        done = subprocess.run(command, capture_output=True, text=True, check=False, env=environment)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def assertLacks(self, words):
        sentence = self.missing()
        self.assertRegex(sentence, rf"^Shapeton cannot be built with \S+, which lacks {words}[^,]*\.$")
        self.assertEqual(sentence.count("(Debian: "), 1)

    def test_nothing_is_missed_where_everything_is_there(self):
        self.assertEqual(self.missing(), "")

    def test_each_thing_that_is_missing_is_named(self):
        for name, words in (
            ("packages/wheel.py", "wheel"),
            ("packages/numpy.py", "numpy"),
            ("numpy-headers/numpy/arrayobject.h", "numpy with its headers"),
            ("include/Python.h", "the headers of Python"),
            ("prefix/lib/cmake/pybind11/pybind11ConfigVersion.cmake", "pybind11 2.10"),
            ("bin/cmake", "CMake 3.22"),
            ("bin/gcc", "a C compiler"),
            ("bin/g++", r"a C\+\+ compiler"),
        ):
            with self.subTest(name):
                path = self.folder / name
                kept, mode = path.read_text(), path.stat().st_mode
                path.unlink()
                self.assertLacks(words)
                self.write(name, kept, mode)

    def test_an_old_version_is_missing_too(self):
        for name, old, words in (
            ("packages/setuptools.py", "__version__ = '60.9'", "setuptools 61"),
            ("packages/numpy.py", "raise ImportError('broken')", "numpy"),
            ("prefix/lib/cmake/pybind11/pybind11ConfigVersion.cmake", 'set(PACKAGE_VERSION "2.9.2")', "pybind11 2.10"),
            ("bin/cmake", "#!/bin/sh\necho cmake version 3.18.4", "CMake 3.22"),
        ):
            with self.subTest(name):
                path = self.folder / name
                kept, mode = path.read_text(), path.stat().st_mode
                self.write(name, old, mode)
                self.assertLacks(words)
                self.write(name, kept, mode)

    def test_a_maker_is_the_one_of_the_generator(self):
        (self.folder / "bin/make").rename(self.folder / "bin/ninja")
        self.assertRegex(self.missing(), "which lacks make,")
        self.assertEqual(self.missing(CMAKE_GENERATOR="Ninja"), "")

    def test_other_places_are_looked_at(self):
        (self.folder / "packages/wheel.py").unlink()
        self.write("packages/setuptools.py", "__version__ = '70.1.0'")  # builds wheels itself
        (self.folder / "bin/g++").rename(self.folder / "bin/other")
        (self.folder / "prefix").rename(self.folder / "moved")
        self.assertEqual(self.missing(CXX="other -m64", CMAKE_PREFIX_PATH=str(self.folder / "moved")), "")

    @unittest.skipUnless(importlib.util.find_spec("pip"), "pip is not installed")
    def test_pip_prints_the_sentence(self):
        python = self.folder / "venv/bin/python"
        subprocess.run([sys.executable, "-m", "venv", "--without-pip", python.parents[1]], check=True)
        command = [sys.executable, "-m", "pip", "--python", python, "install", "--no-index", "--no-build-isolation",
                   "--target", self.folder / "target", REPOSITORY]
        done = subprocess.run(command, capture_output=True, text=True, check=False, env={**os.environ, "PYTHONPATH": ""})
        if "no such option: --python" in done.stderr:
            self.skipTest("pip lacks the option --python")
        self.assertNotEqual(done.returncode, 0)
        self.assertRegex(done.stdout + done.stderr, "Shapeton cannot be built with .*, which lacks setuptools 61 .*, wheel")
        self.assertNotIn("Traceback", done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
