"""Builds the compiled module of the Python package by CMake: with the libraries inside it, from these sources, or against an
installed Shapeton whose prefix the environment variable Shapeton_ROOT names. pyproject.toml says the rest."""

import os
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

SOURCE = Path(__file__).resolve().parent
sys.path.insert(0, str(SOURCE / "Wrapping/Python/utilities"))

from build_needs import pybind11_folder  # noqa: E402  (from the folder above)


class BuildByCMake(build_ext):
    def build_extension(self, extension):
        build = Path(self.build_temp).resolve()
        options = ["-DBUILD_TESTING=OFF", f"-DPython_EXECUTABLE={sys.executable}", f"-Dpybind11_DIR={pybind11_folder()}"]
        jobs = str(os.cpu_count() or 1)
        if "Shapeton_ROOT" in os.environ:
            options += ["-S", SOURCE / "Wrapping/Python"]
            work, minutes = "the module against the installed libraries", "2"
        else:
            options += ["-S", SOURCE, "-DSHAPETON_PYTHON_ONLY=ON"]
            work, minutes = "the libraries and the module", "10"
        print(f"Building {work} with {jobs} processes; two take about {minutes} minutes", flush=True)
        subprocess.run(["cmake", "-B", build, *options], check=True)
        subprocess.run(["cmake", "--build", build, "--parallel", jobs, "--target", "_shapeton"], check=True)
        (module,) = (build / "python/shapeton").glob("_shapeton*.so")
        target = Path(self.get_ext_fullpath(extension.name))
        self.copy_file(str(module), str(target))
        for parser in module.parent.glob("ShapetonFileParser"):  # with the libraries inside it
            self.copy_file(str(parser), str(target.parent))


setup(cmdclass={"build_ext": BuildByCMake}, ext_modules=[Extension("shapeton._shapeton", sources=[])])
