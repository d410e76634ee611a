"""Builds the compiled module by CMake against an installed Shapeton, which CMAKE_PREFIX_PATH of the environment names."""

import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

SOURCE = Path(__file__).resolve().parent


class BuildByCMake(build_ext):
    def build_extension(self, extension):
        build = Path(self.build_temp).resolve()
        options = {
            "BUILD_TESTING": "OFF",
            "CMAKE_INSTALL_PREFIX": build / "installed",
            "Python_EXECUTABLE": sys.executable,
            "SHAPETON_PYTHON_DIR": "package",
        }
        definitions = [f"-D{name}={value}" for name, value in options.items()]
        subprocess.run(["cmake", "-S", SOURCE, "-B", build, *definitions], check=True)
        subprocess.run(["cmake", "--build", build, "--parallel", "2", "--target", "install"], check=True)
        (module,) = (build / "installed" / "package" / "shapeton").glob("_shapeton*.so")
        self.copy_file(str(module), self.get_ext_fullpath(extension.name))


setup(cmdclass={"build_ext": BuildByCMake}, ext_modules=[Extension("shapeton._shapeton", sources=[])])
