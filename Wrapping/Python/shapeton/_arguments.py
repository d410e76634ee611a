"""Checks of arguments: each message names the argument, what it must be, and what to do."""

from __future__ import annotations

import collections.abc
import difflib
import inspect
import numbers
import os
import typing
from typing import Any, Callable, Dict, Union

import numpy as np

from ._shapeton import InputError

_Function = Callable[..., Any]

#: What to do with an array where an object with a position in space is required.
_WRAPPING = {
    "Image": "wrap it in shapeton.Image(array, spacing)",
    "Mesh": "wrap it in shapeton.Mesh(points, triangles)",
}


class MissingFileError(InputError, FileNotFoundError):
    """A file or folder to be read does not exist; also a FileNotFoundError."""


def bound(function: _Function, signature: inspect.Signature, arguments: Any, options: Any) -> inspect.BoundArguments:
    """The arguments of a call by name; a TypeError suggests the nearest name of an unknown one."""
    name = function.__qualname__.replace(".__init__", "")
    for option in options:
        if option not in signature.parameters:
            near = difflib.get_close_matches(option, signature.parameters, 1, 0.6)
            advice = f"; did you mean \"{near[0]}\"?" if near else f"; it has {', '.join(signature.parameters)}"
            raise TypeError(f"{name}() has no argument \"{option}\"{advice}")
    try:
        return signature.bind(*arguments, **options)
    except TypeError as error:
        raise TypeError(f"{name}(): {error}") from None


def check(function: _Function, hints: Dict[str, Any], values: Dict[str, Any]) -> None:
    """Raises TypeError for a value that is not of the annotated type, MissingFileError for a path of nothing."""
    for name, value in values.items():
        hint = hints.get(name, Any)
        if not _is(value, hint):
            place = f"{function.__qualname__.replace('.__init__', '')}(): the argument \"{name}\""
            raise TypeError(f"{place} must be {_words(hint)}, not {_kind(value)}{_advice(value, hint)}")
        if hint == PATH and function.__name__.startswith(("read_", "list_")) and not os.path.exists(value):
            raise MissingFileError(f"{os.fspath(value)}: does not exist")


#: The annotation of names of files and folders.
PATH = Union[str, "os.PathLike[str]"]


def _is(value: Any, hint: Any) -> bool:
    origin, inner = typing.get_origin(hint), typing.get_args(hint)
    if hint is Any:
        return True
    if hint == PATH:
        return isinstance(value, (str, os.PathLike))
    if origin is Union:
        return any(_is(value, one) for one in inner)
    if origin is tuple and Ellipsis not in inner:
        return _is_sequence(value) and len(value) == len(inner) and all(map(_is, value, inner))
    if origin in (tuple, list, collections.abc.Sequence):
        return _is_sequence(value) and all(_is(one, inner[0]) for one in value)
    if origin is collections.abc.Callable:
        return callable(value)
    if hint in (int, float):
        kind = numbers.Integral if hint is int else numbers.Real
        return isinstance(value, kind) and not isinstance(value, (bool, np.bool_))
    if hint is bool:
        return isinstance(value, (bool, np.bool_))
    return isinstance(value, origin or hint)


def _is_sequence(value: Any) -> bool:
    return isinstance(value, (list, tuple, range, np.ndarray))


def _words(hint: Any) -> str:
    """A type in words."""
    origin, inner = typing.get_origin(hint), typing.get_args(hint)
    if hint == PATH:
        return "a path"
    if origin is Union:
        return " or ".join(_words(one) for one in inner)
    if origin is tuple and Ellipsis not in inner:
        return f"a sequence of {len(inner)} numbers"
    if origin in (tuple, list, collections.abc.Sequence):
        return "a sequence" + {int: " of whole numbers", float: " of numbers"}.get(inner[0], "")
    if origin is collections.abc.Callable:
        return "a function"
    words = {int: "a whole number", float: "a number", bool: "True or False", str: "a str", type(None): "None"}
    return words.get(hint, f"a shapeton.{getattr(hint, '__name__', hint)}")


def _kind(value: Any) -> str:
    return "an array" if isinstance(value, np.ndarray) else "None" if value is None else f"{type(value).__name__} {value!r:.40}"


def _advice(value: Any, hint: Any) -> str:
    names = [getattr(one, "__name__", "") for one in (hint, *typing.get_args(hint))]
    found = [_WRAPPING[name] for name in names if name in _WRAPPING and isinstance(value, np.ndarray)]
    return f"; {found[0]}" if found else ""
