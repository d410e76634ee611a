"""Build backend of pyproject.toml: the functions of setuptools, after a check of the build requirements."""

import sys

from build_needs import missing

if missing():
    sys.exit(missing())

from setuptools.build_meta import *  # noqa: E402, F401, F403  (which may be missing)
