"""What pip calls, as pyproject.toml says: the functions of setuptools, once everything that the build needs is there."""

import sys

from build_needs import missing

if missing():
    sys.exit(missing())

from setuptools.build_meta import *  # noqa: E402, F401, F403  (which may be missing)
