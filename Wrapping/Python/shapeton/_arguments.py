"""Checks of arguments: each message names the argument, what it must be, and what to do."""

from __future__ import annotations

import collections.abc
import difflib
import inspect
import numbers
import os
import typing
from typing import Any, Callable, Dict, Sequence, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from ._graphs import graph_of
from ._shapeton import Graph, InputError, ParameterError
from .image import Image
from .mesh import Curves, refuse_mask

Path = Union[str, os.PathLike[str]]
Progress = Callable[[float, str], object]
Values = Union[Sequence[float], Sequence[Sequence[float]], NDArray[Any]]
Point = Union[Tuple[float, float, float], Sequence[float], NDArray[Any]]
Points = Union[Sequence[Point], NDArray[Any]]
Lines = Union[Curves, NDArray[Any]]
Pairs = Union[Sequence[Tuple[int, int]], Sequence[Sequence[int]], NDArray[Any]]


class MissingFileError(InputError, FileNotFoundError):
    """A file or folder to be read does not exist; also a FileNotFoundError."""


def _shape(value: Any) -> Tuple[int, ...]:
    """The shape of an array of numbers; (-1,) for anything else."""
    try:
        array = np.asarray(value)
    except ValueError:  # rows of different lengths
        return (-1,)
    return array.shape if array.dtype.kind in "iuf" else (-1,)


def _are_points(value: Any) -> bool:
    shape = _shape(value)
    return shape == (0,) or (len(shape) == 2 and shape[1] == 3)


def _are_rows(value: Any) -> bool:
    return isinstance(value, np.ndarray) and _are_points(value)


def _is_number(value: Any, kind: type) -> bool:
    return isinstance(value, kind) and not isinstance(value, (bool, np.bool_))


#: Annotations in words, and their tests.
_KINDS: Dict[Any, Tuple[str, Callable[[Any], bool]]] = {
    Any: ("anything", lambda value: True),
    int: ("a whole number", lambda value: _is_number(value, numbers.Integral)),
    float: ("a number", lambda value: _is_number(value, numbers.Real)),
    bool: ("True or False", lambda value: isinstance(value, (bool, np.bool_))),
    str: ("a str", lambda value: isinstance(value, str)),
    type(None): ("None", lambda value: value is None),
    Path: ("a path", lambda value: isinstance(value, (str, os.PathLike))),
    Values: ("numbers", lambda value: _shape(value) != (-1,)),
    Point: ("three numbers", lambda value: _shape(value) == (3,)),
    Points: ("k x 3 numbers", _are_points),
    Lines: ("a shapeton.Curves or an array of n x 3 numbers", lambda value: isinstance(value, Curves) or _are_rows(value)),
    Pairs: ("m x 2 whole numbers", lambda value: _shape(value) != (-1,)),
}

#: What to do with an array where an object with a position in space is required.
_ADVICE = {
    "a shapeton.Image": "; wrap it in shapeton.Image(array, spacing)",
    "a shapeton.Mesh": "; wrap it in shapeton.Mesh(vertices, faces)",
}

#: Converters of objects of other packages; each raises TypeError for an unknown object.
_CONVERTERS: Dict[Any, Callable[[Any], Any]] = {Image: Image.of, Graph: graph_of}


#: Names of an argument in other functions.
_OTHER_NAMES = {"mask": "domain", "domain": "mask"}


def bound(name: str, signature: inspect.Signature, arguments: Any, options: Any) -> inspect.BoundArguments:
    """The arguments of a call by name; a TypeError suggests the nearest name of an unknown one."""
    known = [parameter for parameter in signature.parameters if parameter != "self"]
    for option in options:
        if option not in known:
            near = [other for other in (_OTHER_NAMES.get(option),) if other in known]
            near = near or difflib.get_close_matches(option, known, 1)
            advice = f"; did you mean \"{near[0]}\"?" if near else f"; it has {', '.join(known) or 'none'}"
            raise TypeError(f"{name}() has no argument \"{option}\"{advice}")
    try:
        return signature.bind(*arguments, **options)
    except TypeError as error:
        raise TypeError(f"{name}(): {error}{_advice_by_name(signature, arguments)}") from None


def _advice_by_name(signature: inspect.Signature, arguments: Any) -> str:
    """For more positional arguments than allowed: how to pass the first one too many."""
    parameters = signature.parameters.values()
    positional = sum(parameter.kind is not inspect.Parameter.KEYWORD_ONLY for parameter in parameters)
    surplus = arguments[positional] if len(arguments) > positional else None
    kind = type(surplus).__name__
    for parameter in parameters:
        if parameter.kind is inspect.Parameter.KEYWORD_ONLY and parameter.annotation in (kind, f"Optional[{kind}]"):
            return f"; give it by name, for example {parameter.name}={surplus!r}"
    return ""


#: Arguments that tell where an image is not zero.
_MASKS = ("domain", "mask")


def as_mask(name: str, value: Any) -> Any:
    """A mask as bool, whatever the type of its voxels; other arguments as they are."""
    if name not in _MASKS or not isinstance(value, Image) or value.array.dtype.kind not in "iuf":
        return value
    if value.array.dtype == np.uint8:
        return value
    if not np.all(np.isfinite(value.array)):
        raise InputError(f"the parameter \"{name}\" contains NaN or infinity; a mask requires zero and other numbers")
    return value.like(value.array != 0)


def adapted(hint: Any, value: Any) -> Any:
    """The value, as an image or a graph if the annotation is one and the value is one of another package."""
    inner = _without_none(hint) or hint
    if inner in _CONVERTERS and value is not None:
        try:
            return _CONVERTERS[inner](value)
        except TypeError:
            return value  # reported by check()
    if typing.get_origin(inner) is collections.abc.Sequence and isinstance(value, (list, tuple)):
        return [adapted(typing.get_args(inner)[0], one) for one in value]
    return value


def check(name: str, hints: Dict[str, Any], values: Dict[str, Any]) -> None:
    """Raises TypeError for a value that is not of the annotated type."""
    for argument, value in values.items():
        refuse_mask(argument, value)
        hint = hints.get(argument, Any)
        if not _is(value, hint):
            words = _words(hint)
            advice = next((text for kind, text in _ADVICE.items() if kind in words and isinstance(value, np.ndarray)), "")
            advice = "; use shapeton.Mesh.from_vtk(surface)" if "a shapeton.Mesh" in words and hasattr(value, "GetPolys") else advice
            advice = "; use shapeton.graphs.as_graph(edges)" if (name, argument) == ("Graph", "nodes") else advice
            raise TypeError(f"{name}(): the argument \"{argument}\" must be {words}, not {_kind(value)}{advice}")


def check_extension(path: Any, *extensions: str) -> None:
    """Raises ParameterError unless the path of an output has one of the extensions."""
    if not os.fspath(path).lower().endswith(extensions):
        raise ParameterError(f"the parameter \"path\": {os.fspath(path)} does not end with {' or '.join(extensions)}")


def check_steps(**lists: Sequence[int]) -> None:
    """Raises ParameterError for a negative time step; the names are those of the arguments."""
    for name, steps in lists.items():
        for step in steps:
            if step < 0:
                raise ParameterError(f"the parameter \"{name}\": {step} is out of range")


def lacks_file(hints: Dict[str, Any], values: Dict[str, Any]) -> bool:
    """Whether an argument is the path of nothing."""
    return any(hints.get(name) == Path and not os.path.exists(value) for name, value in values.items())


def _without_none(hint: Any) -> Any:
    """The type T of Optional[T]; None for any other type."""
    inner = typing.get_args(hint)
    if typing.get_origin(hint) is not Union or type(None) not in inner:
        return None
    return Union[tuple(one for one in inner if one is not type(None))]


def _is(value: Any, hint: Any) -> bool:
    if hint in _KINDS:
        return _KINDS[hint][1](value)
    optional = _without_none(hint)
    if optional is not None:
        return value is None or _is(value, optional)
    origin, inner = typing.get_origin(hint), typing.get_args(hint)
    if origin is tuple:
        return _is_sequence(value) and len(value) == len(inner) and all(map(_is, value, inner))
    if origin is collections.abc.Sequence:
        return _is_sequence(value) and all(_is(one, inner[0]) for one in value)
    return callable(value) if origin is collections.abc.Callable else isinstance(value, hint)


def _is_sequence(value: Any) -> bool:
    return isinstance(value, (list, tuple, range, np.ndarray))


def _words(hint: Any) -> str:
    """A type in words."""
    if hint in _KINDS:
        return _KINDS[hint][0]
    optional = _without_none(hint)
    if optional is not None:
        return f"{_words(optional)} or None"
    origin, inner = typing.get_origin(hint), typing.get_args(hint)
    if origin is tuple:
        return f"({', '.join(map(_words, inner))})"
    if origin is collections.abc.Sequence:
        return f"a sequence of ({_words(inner[0])})" if typing.get_args(inner[0]) else f"a sequence, each {_words(inner[0])}"
    return "a function" if origin is collections.abc.Callable else f"a {hint.__module__}.{hint.__qualname__}"


def _kind(value: Any) -> str:
    """A value in words."""
    if isinstance(value, np.ndarray):
        return f"an array of shape {value.shape}"
    return "None" if value is None else f"{type(value).__name__} {value!r:.40}"
