"""Writes type stubs of the compiled classes from their docstrings, for type checkers and editors.

usage: make_stub.py [--check] shapeton/_shapeton.pyi

Writes the file; with --check it exits with status 1 if the file is out of date. The package must be importable.
"""

import ast
import inspect
import sys
from pathlib import Path

from shapeton import _shapeton, colon, graphs, shapes  # noqa: F401  (the latter define constructors)

HEAD = '''"""Written by make_stub.py from the docstrings of the classes; do not edit."""

from typing import Any, Dict, List, Optional, Sequence, Tuple

from numpy.typing import ArrayLike, NDArray

from ._arguments import Lines, Pairs
from .image import Image
from .mesh import Curves, Mesh

def __getattr__(name: str) -> Any: ...  # the functions, which only the package calls
'''

#: Python names of C++ types, for parameters and results.
PARAMETERS = {"List": "Sequence", "ndarray": "ArrayLike"}
RESULTS = {"ndarray": "NDArray[Any]", "dict": "Dict[str, Any]", "tuple": "Tuple[Any, ...]"}

#: Result types missing in the docstrings, by method.
HINTS = {
    "find": "Tuple[NDArray[Any], NDArray[Any]]",
    "map_points": "Tuple[NDArray[Any], NDArray[Any], NDArray[Any]]",
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


def method(name, doc):
    line, _, words = doc.partition("\n")
    (signature,) = ast.parse(f"def {line.strip()}: ...").body
    arguments = signature.args
    for argument in arguments.posonlyargs + arguments.args + arguments.kwonlyargs:
        if argument.arg == "self":
            argument.annotation = None
            continue
        argument.annotation = Types(PARAMETERS).visit(argument.annotation)
    result = HINTS.get(name) or annotation(ast.unparse(signature.returns), RESULTS)
    return definition(f"{name}({ast.unparse(arguments)}) -> {result}", words)


def constructor(function):
    """The Python function that checks the arguments of a compiled constructor."""
    return definition(f"__init__{inspect.signature(function)}".replace("'", ""), function.__doc__)


def definition(head, words):
    if not words.strip():
        return f"    def {head}: ...\n"
    return f"    def {head}:\n{docstring(words, ' ' * 8)}\n"


def property_of(name, member):
    result = annotation(member.fget.__doc__.splitlines()[0].rpartition(" -> ")[2], RESULTS)
    return f"    @property\n    def {name}(self) -> {result}:\n{docstring(member.__doc__, ' ' * 8)}\n"


def class_of(name, kind):
    bases = ", ".join(base.__name__ for base in kind.__bases__ if base.__name__ not in ("pybind11_object", "object"))
    parts = [f"class {name}({bases}):" if bases else f"class {name}:", docstring(kind.__doc__, "    ")]
    for member_name, member in sorted(vars(kind).items()):
        if isinstance(member, property):
            parts.append(property_of(member_name, member))
        elif member_name == "__init__" and inspect.isfunction(member):
            parts.append(constructor(member))
        elif inspect.isroutine(member) and not member_name.startswith("_"):
            parts.append(method(member_name, member.__doc__))
    return "\n".join(parts) + "\n"


def stub():
    classes = {n: m for n, m in sorted(vars(_shapeton).items()) if inspect.isclass(m) and not n.startswith("_")}
    errors = ["Error", "ParameterError", "InputError", "OutputError", "Aborted"]
    ordered = errors + [name for name in classes if name not in errors]
    return "\n".join([HEAD] + [class_of(name, classes[name]) for name in ordered])


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
