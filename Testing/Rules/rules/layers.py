"""Layers of modules: CMake/Modules.cmake lists groups and modules, each after the modules that it uses."""

import re
from collections import Counter
from pathlib import Path

from .modules import DECLARATION, LIST, PREFIX, Module, declared, folder_of, listed
from .tree import Fault, find, line_at

# Dependencies whose headers the files of a part of a module may include.
VISIBLE = {"include": ("DEPENDS", "COMPILE_DEPENDS"),
           "src": ("DEPENDS", "COMPILE_DEPENDS", "PRIVATE_DEPENDS"),
           "test": ("DEPENDS", "COMPILE_DEPENDS", "PRIVATE_DEPENDS", "TEST_DEPENDS")}
USED_IN = {"DEPENDS": "include", "PRIVATE_DEPENDS": "src", "TEST_DEPENDS": "test"}
# Headers of ITK modules that modules must declare; ITKCommon is used everywhere.
ITK_HEADERS = {
    "ITKConnectedComponents": r"itkConnectedComponent\w+\.h",
    "ITKDistanceMap": r"itk\w+DistanceMap\w+\.h",
    "ITKExpat": r"(itk_)?expat\.h",
    "ITKGDCM": r"gdcm\w+\.h",
    "ITKGoogleTest": r".*",
    "ITKIOGDCM": r"itkGDCM\w+\.h",
    "ITKIOImageBase": r"itkImage(IOBase|FileReader|FileWriter|SeriesReader)\.h",
    "ITKIOMeta": r"itkMetaImageIO\.h",
    "ITKIONIFTI": r"itkNiftiImageIO\.h",
    "ITKIONRRD": r"itkNrrdImageIO\.h",
    "ITKIOPNG": r"itkPNGImageIO\.h",
    "ITKImageFunction": r"itk\w+ImageFunction\.h",
    "ITKImageGrid": r"itk(ChangeInformation|RegionOfInterest)ImageFilter\.h",
    "ITKImageSources": r"itkGenerateImageSource\.h",
    "ITKMesh": r"itk(Mesh|MeshSource|\w+MeshFilter)\.h",
    "ITKQuadEdgeMesh": r"itkQuadEdge\w+\.h",
    "ITKSmoothing": r"itk\w+GaussianImageFilter\.h",
    "ITKZLIB": r"(itk_)?zlib\.h",
}
# Code for POSIX systems, and headers that only it includes.
POSIX_FOLDER = Path("Modules/Core/Common/src/posix")
SYSTEM_CALL = re.compile(r"\b(?:gmtime|localtime)_r\(|/proc/self/exe")
SYSTEM_HEADER = re.compile(r"sys/.*|(fcntl|poll|pthread|sched|signal|spawn|termios|unistd)\.h")
ITK_NAMESPACE = re.compile(r"^\s*namespace itk\b", re.MULTILINE)
OPTION = re.compile(r"--[a-zA-Z]")


def basename(header):
    """Returns the file name of an include path."""
    return header.rsplit("/", 1)[-1]


class Layers:
    """The modules of a tree in order, and the modules that own its headers."""

    def __init__(self, tree):
        self.tree = tree
        self.folders = [f"Modules/{entry}" for entry in listed(tree, "Shapeton_MODULES")]
        self.modules = {module.name: module for module in (Module(tree, folder) for folder in self.folders)}
        self.order = {name: position for position, name in enumerate(self.modules)}
        self.owners = {}  # header: modules
        self.test_headers = {}  # header: file
        for name, module in self.modules.items():
            exports = {f"{name}Export.h", f"{module.folder.name}Export.h"}
            for header in [*exports, *(file.name for file in tree.below(module.folder / "include"))]:
                self.owners.setdefault(header, []).append(name)
            self.test_headers |= {file.name: file for file in tree.below(module.folder / "test") if file.suffix == ".h"}

    def included(self, module, part):
        """Returns the headers that the files of a part include, also through shared test headers, and through sources
        that tests include."""
        headers, files = set(), self.tree.sources(module.folder / part)
        while files:
            for _, path in self.tree.includes(files.pop()):
                header = basename(path)
                source = module.folder / "src" / header
                if header not in headers:
                    headers.add(header)
                    files += [self.test_headers[header]] if header in self.test_headers else []
                    files += [source] if part == "test" and source in self.tree.known else []
        return headers

    def is_used(self, name, headers):
        """Whether one of the headers belongs to a module."""
        if name in self.modules:
            tests = {header for header, file in self.test_headers.items() if folder_of(file) == self.modules[name].folder}
            return any(header in tests or name in self.owners.get(header, ()) for header in headers)
        pattern = re.compile(ITK_HEADERS.get(name, r"(itk[A-Z]|gtest).*"))
        return any(pattern.fullmatch(header) for header in headers)

    def reachable(self, module, part):
        """Returns the modules whose headers a part of a module may include."""
        reached, names = {module.name}, module.names(*VISIBLE[part])
        while names:
            name = names.pop()
            if name in self.modules and name not in reached:
                reached.add(name)
                names += self.modules[name].names(*VISIBLE["include"])
        return reached


def system_headers(tree):
    """Only one folder includes headers of POSIX and of the system; other code uses shapetonOperatingSystem.h."""
    for file in tree.sources("Modules", "Applications", "Wrapping"):
        is_test = {"test", "Testing", "tests"} & set(file.parts)
        if is_test or POSIX_FOLDER in file.parents:
            continue
        yield from find(tree, file, SYSTEM_CALL, f"calls POSIX; only {POSIX_FOLDER} may, see shapetonOperatingSystem.h: ")
        for line, header in tree.includes(file):
            if SYSTEM_HEADER.fullmatch(header):
                yield Fault(str(file), line, f"includes {header}; only {POSIX_FOLDER} may, see shapetonOperatingSystem.h")


def layers_kept(tree):
    """The modules form the layers that CMake/Modules.cmake lists:
    - the list matches the folders; a module has the name of its folder; the groups are in the order of the list;
    - a module depends only on earlier modules and on ITK modules;
    - a file includes only headers of its own module and of the declared dependencies;
    - each dependency is used by a file of that part of the module;
    - include paths stay in their folder; header names are unique, because headers are installed into one folder."""
    layers = Layers(tree)
    yield from faults_of_list(tree, layers)
    for module in layers.modules.values():
        yield from faults_of_declaration(module) if module.file in tree.known else ()
        yield from faults_of_dependencies(layers, module)
        for part in VISIBLE:
            yield from faults_of_includes(layers, module, part)
    for header, names in layers.owners.items():
        for name in names[1:]:
            folder = layers.modules[name].folder
            yield Fault(str(folder / "include" / header), 0, f"the header name {header} is taken by the module {names[0]}")


def faults_of_list(tree, layers):
    """Yields the faults of CMake/Modules.cmake."""
    groups, highest = listed(tree, "Shapeton_GROUPS"), 0
    for folder, count in Counter(layers.folders).items():
        *_, group, name = Path(folder).parts
        if count > 1:
            yield Fault(str(LIST), 0, f"names the module {name} twice")
        if Path(folder, DECLARATION) not in tree.known:
            yield Fault(str(LIST), 0, f"names the module {group}/{name}, which has no itk-module.cmake")
        if group not in groups:
            yield Fault(str(LIST), 0, f"names the module {name} in the unknown group {group}")
        elif groups.index(group) < highest:
            yield Fault(str(LIST), 0, f"names the module {name} of {group} after a module of {groups[highest]}")
        else:
            highest = groups.index(group)
    if not layers.folders:
        yield Fault(str(LIST), 0, "does not list any module")
    for folder, module in declared(tree).items():
        if str(folder) not in layers.folders:
            yield Fault(str(module.file), 0, "is not listed in CMake/Modules.cmake")


def faults_of_declaration(module):
    """Yields what an itk-module.cmake lacks; some are requirements of ITK's build for remote modules."""
    name = module.folder.name
    if not module.is_named:
        yield Fault(str(module.file), 0, f"must declare itk_module({name}) or itk_module({PREFIX}{name})")
    if "EXCLUDE_FROM_DEFAULT" not in module.words:
        yield Fault(str(module.file), 0, "must set EXCLUDE_FROM_DEFAULT, so that ITK does not build the module by default")
    if ";" in re.sub(r"#[^\n]*", "", module.text):
        yield Fault(str(module.file), 0, "contains a semicolon, which ITK takes for an argument separator")


def faults_of_dependencies(layers, module):
    """Yields the dependencies that are unknown, not earlier in the list, or unused."""
    for kind in VISIBLE["test"]:
        part = USED_IN.get(kind)
        headers = layers.included(module, part) if part else set()
        for name in module.names(kind):
            if name not in layers.modules and not name.startswith("ITK"):
                yield Fault(str(module.file), 0, f"{kind} names {name}, which is not a module")
            elif layers.order.get(name, -1) >= layers.order[module.name]:
                yield Fault(str(module.file), 0, f"{kind} names {name}, which is not an earlier module")
            if part and not layers.is_used(name, headers):
                yield Fault(str(module.file), 0, f"{kind} names {name}, which no file in {part} uses")


def faults_of_includes(layers, module, part):
    """Yields the includes of a part of a module that leave their folder or reach undeclared modules."""
    reachable = layers.reachable(module, part)
    for file in layers.tree.sources(module.folder / part):
        for line, header in layers.tree.includes(file):
            if ".." in header:
                yield Fault(str(file), line, f"includes {header}, which leaves its folder")
            owner = layers.owners.get(basename(header), [module.name])[0]
            if owner not in reachable:
                is_later = layers.order[owner] > layers.order[module.name]
                rest = ", a later module" if is_later else ", which its itk-module.cmake does not name"
                yield Fault(str(file), line, f"includes {header} of {owner}{rest}")


def library_texts(tree):
    """No file of a module opens the namespace itk; no string of a module below the group Tools names an option
    (`--flag`): libraries name parameters, tools name options."""
    for file in tree.sources("Modules"):
        for match in ITK_NAMESPACE.finditer(tree.text(file)):
            yield Fault(str(file), line_at(tree.text(file), match.end()), "opens the namespace itk; use shapeton")
        for line, text in tree.strings(file) if file.parts[1] != "Tools" and "test" not in file.parts else ():
            if OPTION.search(text):
                yield Fault(str(file), line, 'names an option; name the parameter, for example: the parameter \\"p\\"')


def graph(tree):
    """Yields one line per module with its dependencies, and totals of modules, dependencies and public headers."""
    layers = Layers(tree)
    arrows, used = 0, set()
    for module in layers.modules.values():
        names = [name for name in module.names("DEPENDS", "PRIVATE_DEPENDS") if name in layers.modules]
        arrows += len(names)
        yield f"{module.folder.relative_to('Modules')}:{''.join(f' {name}' for name in names)}"
    for file in tree.sources("Modules", "Applications", "Testing", "Examples"):
        for _, path in tree.includes(file):
            owner = layers.owners.get(basename(path))
            if owner and layers.modules[owner[0]].folder not in file.parents:
                used.add(basename(path))
    public = {header for header in layers.owners if header.endswith(".h") and not header.endswith("Export.h")}
    yield (f"{len(layers.modules)} modules, {arrows} arrows, {len(public)} public headers, "
           f"{len(public & used)} used outside their module")
