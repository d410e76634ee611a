"""Build requirements of the package, checked before a build of several minutes."""

import importlib
import importlib.util
import os
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

SYSTEM_PREFIXES = ("/usr/local", "/usr")  # default search paths of CMake


def _module(name):
    """Imports a module of this Python; returns None if this fails."""
    try:
        return importlib.import_module(name)
    except Exception:  # pylint: disable=broad-except
        return None


def _numbers(version):
    """Returns major and minor number of a version."""
    return tuple(int(n) for n in re.findall(r"\d+", version)[:2])


def _program(variable, names):
    """Returns the program that an environment variable such as CC names, else the first one found on PATH, or None."""
    given = shlex.split(os.environ.get(variable, ""))
    return next(filter(None, map(shutil.which, given[:1] or names)), None)


def has_setuptools():
    setuptools = _module("setuptools")
    return setuptools is not None and _numbers(setuptools.__version__) >= (61,)


def has_wheel():
    setuptools = _module("setuptools")
    has_own = setuptools is not None and _numbers(setuptools.__version__) >= (70, 1)
    return has_own or _module("wheel") is not None


def has_numpy():
    numpy = _module("numpy")
    return numpy is not None and Path(numpy.get_include(), "numpy/arrayobject.h").exists()


def has_headers():
    return Path(sysconfig.get_path("include"), "Python.h").exists()


def pybind11_folder():
    """Returns the folder of the CMake files of pybind11 2.10 or later, or None."""
    folders = [Path(folder) for folder in [os.environ.get("pybind11_DIR")] if folder]
    package = _module("pybind11")
    if package is not None and hasattr(package, "get_cmake_dir"):
        folders.append(Path(package.get_cmake_dir()))
    prefixes = os.environ.get("CMAKE_PREFIX_PATH", "").split(os.pathsep)
    prefixes += [os.path.dirname(folder) for folder in os.environ.get("PATH", "").split(os.pathsep)]
    for prefix in filter(None, [*prefixes, *SYSTEM_PREFIXES]):
        folders += [Path(prefix, "share/cmake/pybind11"), *Path(prefix).glob("lib*/cmake/pybind11")]
        folders += Path(prefix).glob("lib/*/cmake/pybind11")
    for folder in folders:
        version = folder / "pybind11ConfigVersion.cmake"
        found = re.search(r'PACKAGE_VERSION "(.*?)"', version.read_text()) if version.exists() else None
        if found and _numbers(found[1]) >= (2, 10):
            return folder
    return None


def has_cmake():
    cmake = shutil.which("cmake")
    if cmake is None:
        return False
    output = subprocess.run([cmake, "--version"], capture_output=True, text=True, check=False).stdout
    return _numbers(output) >= (3, 22)


def has_maker():
    generator = os.environ.get("CMAKE_GENERATOR", "Unix Makefiles")
    return shutil.which("ninja" if generator.startswith("Ninja") else "make") is not None


#: Requirement as text, its Debian package, and a check whether it is available.
NEEDS = (
    ("setuptools 61", "python3-setuptools", has_setuptools),
    ("wheel", "python3-wheel", has_wheel),
    ("numpy with its headers", "python3-numpy", has_numpy),
    ("the headers of Python", "python3-dev", has_headers),
    ("pybind11 2.10", "pybind11-dev", lambda: pybind11_folder() is not None),
    ("CMake 3.22", "cmake", has_cmake),
    ("make, or ninja if CMAKE_GENERATOR selects it", "make", has_maker),
    ("a C compiler", "gcc", lambda: _program("CC", ("cc", "gcc", "clang")) is not None),
    ("a C++ compiler", "g++", lambda: _program("CXX", ("c++", "g++", "clang++")) is not None),
)


def missing():
    """Returns one sentence with the missing requirements; empty if there are none."""
    absent = [(words, package) for words, package, is_there in NEEDS if not is_there()]
    if not absent:
        return ""
    words = ", ".join(f"{words} (Debian: {package})" for words, package in absent)
    hint = ""
    if sys.executable != "/usr/bin/python3" and any(package.startswith("python3-") for _, package in absent):
        hint = "; Debian packages are for /usr/bin/python3 only"
    if any("pip-build-env" in folder for folder in sys.path):
        hint = "; pip hides installed packages from this build: use --no-build-isolation"
    return f"Shapeton cannot be built with {sys.executable}, which lacks {words}{hint}."
