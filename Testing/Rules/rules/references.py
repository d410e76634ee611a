"""Doxygen comments of the modules: marks of equations and groups."""

import re

from .modules import Module, folder_of
from .tree import Fault, line_at

COMMENT = re.compile(r"/\*\*(?!/)(.*?)\*/", re.DOTALL)
EQUATION = re.compile(r"\\equation\{([^}]*)\}")
GROUP = re.compile(r"\\(?:ingroup|addtogroup)\s+(\w+)")
NEW_GROUP = re.compile(r"\\defgroup\s+(\w+)")
NAMES = re.compile(r"\\(class|struct|ingroup|addtogroup)\s+\w+")
WANTED = ("2.4", "3.10", "5.5", "6.7", "8.5")


def comments(tree):
    """Yields file, line and text of the Doxygen comments of modules."""
    for file in tree.sources("Modules"):
        text = tree.text(file)
        for match in COMMENT.finditer(text):
            yield file, line_at(text, match.start()), match[1]


def equations(tree):
    """Each formula of the dissertation is marked at most once, by `\\equation{n.m}` at the code that computes it;
    the formulas in WANTED must be marked."""
    marked = {}
    for file, line, text in comments(tree):
        for number in EQUATION.findall(text):
            if number in marked:
                yield Fault(str(file), line, f"marks equation ({number}), which {marked[number]} marks")
            marked.setdefault(number, file)
    for number in WANTED:
        if number not in marked:
            yield Fault("Modules", 0, f"no comment marks equation ({number})")


def group_only(tree):
    """No comment of a public header consists of the class name and group only."""
    for file, line, text in comments(tree):
        rest, count = NAMES.subn("", text)
        if file.parent.name == "include" and count and not rest.strip(" *\t\r\n"):
            yield Fault(str(file), line, "a comment contains only a group")


def groups(tree):
    """The group of a comment is its module, or is defined by a comment of the module. Doxygen ignores other groups."""
    known = {}
    for file, _, text in comments(tree):
        folder = folder_of(file)
        known.setdefault(folder, {folder.name, Module(tree, folder).name}).update(NEW_GROUP.findall(text))
    for file, line, text in comments(tree):
        for name in GROUP.findall(text):
            if name not in known[folder_of(file)]:
                yield Fault(str(file), line, f"names the group {name}, which is not a group of its module")
