"""Files of a repository and faults in them."""

import os
import re
from functools import cache
from pathlib import Path
from typing import NamedTuple

IGNORED = {".git", ".cache", "compile_commands.json", "__pycache__"}
STRING_OR_COMMENT = re.compile(r"""//[^\n]*|/\*.*?\*/|'(?:\\[^']+|\\'|[^\\\n])'|"(?:\\.|[^"\\])*["]""", re.DOTALL)
ESCAPE = re.compile(r"\\(.)", re.DOTALL)
INCLUDE = re.compile(r"""^[ \t]*#[ \t]*include[ \t]*["<]([^">]+)[">]""", re.MULTILINE)


class Fault(NamedTuple):
    """Violation of a rule. Line 0 means the whole file."""
    file: str
    line: int
    message: str

    def __str__(self):
        return f"{self.file}{f':{self.line}' if self.line else ''}: {self.message}"


class Tree:
    """The files of a repository, except git's own files and ignored files; their paths are relative to its root."""

    def __init__(self, root):
        self.root = Path(root)
        self.files = []
        for folder, folders, names in os.walk(self.root):
            at_top = Path(folder) == self.root
            folders[:] = [n for n in folders if n not in IGNORED and not n.endswith(".egg-info")
                          and not (at_top and (n.startswith("build") or n == "demo-output"))]
            self.files += [Path(folder, n).relative_to(self.root) for n in names
                           if n not in IGNORED and os.path.isfile(os.path.join(folder, n))]
        self.files.sort()
        self.known = set(self.files)
        self.text = cache(self.text)
        self.includes = cache(self.includes)
        self.strings = cache(self.strings)

    def text(self, file):
        """Returns the content of a file; bytes that are not UTF-8 are kept as surrogates."""
        return (self.root / file).read_bytes().decode("utf-8", "surrogateescape")

    def below(self, folder):
        """Returns the files below a folder."""
        parts = Path(folder).parts
        return [file for file in self.files if file.parts[:len(parts)] == parts]

    def sources(self, *folders):
        """Returns the C++ files; if folders are given, only the files below them."""
        files = [file for folder in folders for file in self.below(folder)] if folders else self.files
        return [file for file in files if is_source(file)]

    def includes(self, file):
        """Returns the line and the header of each include of a C++ file."""
        text = self.text(file)
        return [(line_at(text, match.start()), match[1]) for match in INCLUDE.finditer(text)]

    def strings(self, file):
        """Returns the line and the text of each string literal of a C++ file. Joins adjacent literals; skips comments.

        Raw strings are not supported, because they do not contain messages."""
        source, found, end = self.text(file), [], 0
        for token in STRING_OR_COMMENT.finditer(source):
            is_next = source[end:token.start()].strip() == ""
            if token[0].startswith('"'):
                if not (found and is_next):
                    found.append((line_at(source, token.start()), ""))
                found[-1] = found[-1][0], found[-1][1] + ESCAPE.sub(r"\1", token[0][1:-1])
                end = token.end()
            elif token[0].startswith("/") and is_next:
                end = token.end()
        return found


def is_source(file):
    """Whether a file is a C++ source or header."""
    return file.suffix in (".h", ".hxx", ".cxx")


def line_at(text, position):
    """Returns the line number of a position."""
    return text.count("\n", 0, position) + 1


def find(tree, file, pattern, message):
    """Yields a fault for each match of a pattern in a file."""
    text = tree.text(file)
    for match in pattern.finditer(text):
        yield Fault(str(file), line_at(text, match.start()), message + match[0])
