"""Writes type stubs of the compiled module from its docstrings, for type checkers and editors.

usage: make_stub.py [--check] shapeton/_shapeton.pyi

Writes the file; with --check it exits with status 1 if the file is out of date. The package must be importable.
"""

import ast
import inspect
import sys
from pathlib import Path

from shapeton import _shapeton

HEAD = '''"""Written by make_stub.py from the docstrings of the module; do not edit."""

import os
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

from numpy.typing import ArrayLike, NDArray

from .image import Image
from .mesh import Curves, Mesh
'''

#: Python names of C++ types, for parameters and results.
PARAMETERS = {"List": "Sequence", "ndarray": "ArrayLike", "Curves": "Union[Curves, NDArray[Any]]", "PathLike": "Union[str, os.PathLike[str]]"}
RESULTS = {"ndarray": "NDArray[Any]", "dict": "Dict[str, Any]", "tuple": "Tuple[Any, ...]"}

#: Types missing in the docstrings: (function, parameter or "return").
HINTS = {
    ("__init__", "edges"): "ArrayLike",
    ("diffuse_heat", "snapshot"): "Optional[Callable[[int, Image], object]]",
    ("read_surface", "return"): "Mesh",
    ("read_volume", "return"): "Image",
    ("write_volume", "image"): "Image",
    ("find", "return"): "Tuple[NDArray[Any], NDArray[Any]]",
    ("map_points", "return"): "Tuple[NDArray[Any], NDArray[Any], NDArray[Any]]",
}


class Types(ast.NodeTransformer):
    """Replaces the type names of pybind11 by Python names."""

    def __init__(self, names):
        self.names = names

    def named(self, name):
        return ast.parse(self.names.get(name, name), mode="eval").body

    def visit_Name(self, node):
        return self.named(node.id)

    def visit_Attribute(self, node):
        return self.named(node.attr)  # shapeton.Image, numpy.ndarray

    def visit_Subscript(self, node):
        if isinstance(node.value, ast.Attribute) and node.value.attr == "ndarray":
            return self.named("ndarray")  # element type and shape are documented in the text
        if isinstance(node.slice, ast.Constant):
            return self.visit(node.value)  # float[3] of List[float[3]]
        return self.generic_visit(node)


def annotation(text, names):
    return ast.unparse(Types(names).visit(ast.parse(text, mode="eval").body))


def docstring(text, indent):
    lines = text.strip().replace('"""', "'''").splitlines()
    if len(lines) > 1:
        lines.append("")
    quoted = ("\n" + indent).join(lines).replace("\n" + indent + "\n", "\n\n")
    return f'{indent}"""{quoted}"""'


def function(name, doc, indent=""):
    line, _, words = doc.partition("\n")
    (signature,) = ast.parse(f"def {line.strip()}: ...").body
    arguments = signature.args
    for argument in arguments.posonlyargs + arguments.args + arguments.kwonlyargs:
        if argument.arg == "self":
            argument.annotation = None
            continue
        hint = HINTS.get((name, argument.arg)) or annotation(ast.unparse(argument.annotation), PARAMETERS)
        argument.annotation = ast.parse(hint, mode="eval").body
    ellipsis = ast.Constant(value=...)
    arguments.defaults = [ellipsis for _ in arguments.defaults]
    arguments.kw_defaults = [default and ellipsis for default in arguments.kw_defaults]
    result = HINTS.get((name, "return")) or annotation(ast.unparse(signature.returns), RESULTS)
    head = f"{indent}def {name}({ast.unparse(arguments)}) -> {result}:"
    return f"{head}\n{docstring(words, indent + '    ')}\n{indent}    ...\n" if words.strip() else f"{head} ...\n"


def property_of(name, member):
    result = annotation(member.fget.__doc__.splitlines()[0].rpartition(" -> ")[2], RESULTS)
    return f"    @property\n    def {name}(self) -> {result}:\n{docstring(member.__doc__, ' ' * 8)}\n        ...\n"


def class_of(name, kind):
    bases = ", ".join(base.__name__ for base in kind.__bases__ if base.__name__ not in ("pybind11_object", "object"))
    parts = [f"class {name}({bases}):" if bases else f"class {name}:", docstring(kind.__doc__, "    ")]
    for member_name, member in sorted(vars(kind).items()):
        if isinstance(member, property):
            parts.append(property_of(member_name, member))
        elif member_name == "__init__" and member.__doc__.startswith("__init__(self: "):
            parts.append(function(member_name, member.__doc__, "    "))
        elif inspect.isroutine(member) and not member_name.startswith("_"):
            parts.append(function(member_name, member.__doc__, "    "))
    return "\n".join(parts) + "\n"


def stub():
    members = sorted((n, m) for n, m in vars(_shapeton).items() if not n.startswith("_"))
    errors = ["Error", "ParameterError", "InputError", "OutputError", "Aborted"]
    classes = [(n, m) for n, m in members if inspect.isclass(m) and n not in errors]
    ordered = [(n, getattr(_shapeton, n)) for n in errors] + classes
    parts = [HEAD] + [class_of(n, m) for n, m in ordered]
    parts += [function(n, m.__doc__) for n, m in members if not inspect.isclass(m)]
    return "\n".join(parts)


def main(arguments):
    check = "--check" in arguments
    path = Path(next(a for a in arguments if a != "--check"))
    text = stub()
    if check and path.read_text() != text:
        print(f"{path} is out of date; run make_stub.py")
        return 1
    if not check:
        path.write_text(text)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
