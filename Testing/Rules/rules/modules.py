"""Declarations of modules: the list of CMake/Modules.cmake and the itk-module.cmake of each folder."""

import re
from pathlib import Path

LIST = Path("CMake/Modules.cmake")
DECLARATION = "itk-module.cmake"
PREFIX = "Shapeton"  # a module may declare its folder's name with this prefix
KEYWORDS = {"DEPENDS", "COMPILE_DEPENDS", "PRIVATE_DEPENDS", "TEST_DEPENDS", "ENABLE_SHARED", "EXCLUDE_FROM_DEFAULT",
            "DESCRIPTION", "FACTORY_NAMES"}


def arguments(text, opening):
    """Returns the words between `opening` and the next closing parenthesis of a CMake file."""
    _, _, rest = re.sub(r"#[^\n]*", "", text).partition(opening)
    return rest.split(")")[0].split()


class Module:
    """A module: its folder, the name that it declares, and the names after each keyword."""

    def __init__(self, tree, folder):
        self.folder = Path(folder)
        self.file = self.folder / DECLARATION
        self.text = tree.text(self.file) if self.file in tree.known else ""
        words = arguments(self.text, "itk_module(")
        self.is_named = words[:1] in ([self.folder.name], [PREFIX + self.folder.name])
        self.name = words[0] if self.is_named else self.folder.name
        self.words, keyword = {}, None
        for word in words[1:]:
            keyword = word if word in KEYWORDS else keyword
            self.words.setdefault(keyword, []).extend([] if word in KEYWORDS else [word])

    def names(self, *keywords):
        """Returns the words after the keywords."""
        return [name for keyword in keywords for name in self.words.get(keyword, ())]


def declared(tree):
    """Returns the modules below Modules by folder."""
    return {file.parent: Module(tree, file.parent) for file in tree.below("Modules") if file.name == DECLARATION}


def listed(tree, variable):
    """Returns the words of a variable that CMake/Modules.cmake sets."""
    return arguments(tree.text(LIST), f"set({variable}")


def folder_of(file):
    """Returns Modules/Group/Name of a file of a module."""
    return Path(*file.parts[:3])
