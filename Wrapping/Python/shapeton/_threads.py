"""Number of threads."""

from . import _shapeton
from ._calls import public


@public
def set_threads(number: int) -> None:
    """Sets the number of threads of all functions of this process, 0 to 128; 0: all cores. Results do not depend on it."""
    _shapeton.set_threads(number)


@public
def threads() -> int:
    """The number of threads of all functions of this process."""
    return _shapeton.threads()
