"""Builds the compiled module of the Python package by CMake: with the libraries inside it, from these sources, or against an
installed Shapeton whose prefix the environment variable Shapeton_ROOT names. pyproject.toml says the rest."""

import os
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

SOURCE = Path(__file__).resolve().parent


class BuildByCMake(build_ext):
    def build_extension(self, extension):
        build = Path(self.build_temp).resolve()
        options = ["-DBUILD_TESTING=OFF", f"-DPython_EXECUTABLE={sys.executable}"]
        if "Shapeton_ROOT" in os.environ:
            options += ["-S", SOURCE / "Wrapping/Python"]
        else:
            options += ["-S", SOURCE, "-DSHAPETON_PYTHON_ONLY=ON"]
        subprocess.run(["cmake", "-B", build, *options], check=True)
        jobs = str(os.cpu_count() or 1)
        subprocess.run(["cmake", "--build", build, "--parallel", jobs, "--target", "_shapeton"], check=True)
        (module,) = (build / "python/shapeton").glob("_shapeton*.so")
        self.copy_file(str(module), self.get_ext_fullpath(extension.name))


setup(cmdclass={"build_ext": BuildByCMake}, ext_modules=[Extension("shapeton._shapeton", sources=[])])
