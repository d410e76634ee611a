"""What users see of the package: names in `dir`, names of classes, `repr` of results."""

from __future__ import annotations

import inspect
from types import ModuleType
from typing import Any

import numpy as np

_MOST = 6  # maximum number of values shown


def _short(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:g}"
    if isinstance(value, np.ndarray):
        if value.size <= _MOST:
            return _short(value.tolist())
        return f"<array {' x '.join(str(n) for n in value.shape)}, {value.dtype}>"
    if isinstance(value, list) and value and _is_described(value[0]):
        return f"<{len(value)} of {_name_of(value[0])}>"
    if isinstance(value, (list, tuple, dict)) and len(value) > _MOST:
        return f"<{len(value)} values>"
    if isinstance(value, (list, tuple)):
        inside = ", ".join(_short(one) for one in value)
        return f"[{inside}]" if isinstance(value, list) else f"({inside})"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key!r}: {_short(one)}" for key, one in value.items()) + "}"
    return f"<{_name_of(value)}>" if _is_described(value) else repr(value)


def _is_described(value: Any) -> bool:
    return type(value).__repr__ is _describe


def _name_of(value: Any) -> str:
    return f"{type(value).__module__}.{type(value).__qualname__}"


def _describe(result: Any) -> str:
    members = [name for name, member in vars(type(result)).items() if isinstance(member, property)]
    values = ", ".join(f"{name}={_short(getattr(result, name))}" for name in members)
    return f"<{_name_of(result)} {values}>"


def describe_results(compiled: ModuleType) -> None:
    """Adds a `repr` that lists the attributes to classes of the compiled module that lack one."""
    for thing in vars(compiled).values():
        if inspect.isclass(thing) and not issubclass(thing, BaseException) and "__repr__" not in vars(thing):
            thing.__repr__ = _describe  # type: ignore[method-assign]


def show_public_names(module: ModuleType) -> None:
    """`dir` lists only public names of the module, and its classes are named after it."""
    names = sorted([*module.__all__, *(name for name in vars(module) if name.startswith("__"))])
    setattr(module, "__dir__", lambda: names)
    for thing in (getattr(module, name) for name in module.__all__):
        if inspect.isclass(thing):
            thing.__module__ = module.__name__
