"""Messages do not give advice that the tool rejects."""

import re
import sys
from pathlib import Path

from .modules import arguments, declared, folder_of
from .tree import Fault
from .xml_tree import parse, text_of

sys.path.append(str(Path(__file__).resolve().parents[3] / "CMake"))
from options import expand_xml  # noqa: E402

BUILT_IN = {"help", "version", "xml", "quiet", "echo", "returnparameterfile", "processinformationaddress"}
# Values in messages that a tool rejects but never prints. `component` = -1 is omitted if
# SurfaceReadOptions::takesOneComponent is set; the test SurfaceReader.ASurfaceThatIsNotManifoldIsCutIntoComponents and
# the tests of Testing/Advice check this.
CONDITIONAL = {("component", "-1")}
VERBS = {"needs", "says", "is", "takes", "and", "belongs", "has", "or"}  # words after an option that are not its value
# Another tool, its option and the next word; or a parameter and its value.
MENTION = re.compile(r'(?:(\w+) \()?(?:--([A-Za-z]\w*)(?:[ =]([^\s,;:)"]+))?|'
                     r'the parameter "(\w+)"(?: = ([^\s,;)"]+))?)', re.ASCII)
NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)


def parameters_of(tree, xml):
    """Returns the parameters that a tool declares, by name."""
    root, _ = parse(expand_xml(tree.text(xml)))
    return {text_of(element, "name"): element for element in root.iter()
            if element.find("name") is not None and element.tag != "parameters"}


def folders_of(tree, cmake, folders, modules):
    """Returns the folders of a tool and of the modules that it links, also transitively. All tools link CommandLine."""
    reached, names = {cmake.parent}, [*arguments(tree.text(cmake), "shapeton_add_tool("), "CommandLine"]
    while names:
        folder = folders.get(names.pop())
        if folder and folder not in reached:
            reached.add(folder)
            names += modules[folder].names("DEPENDS", "COMPILE_DEPENDS", "PRIVATE_DEPENDS")
    return reached


def is_rejected(value, parameter):
    """Whether a parameter rejects a value: a number out of its range, or a word that its enumeration lacks."""
    number = NUMBER.match(value)
    minimum, maximum = (parameter.findtext(f"constraints/{bound}") for bound in ("minimum", "maximum"))
    is_beyond = number and (minimum and float(number[0]) < float(minimum) or maximum and float(number[0]) > float(maximum))
    elements = [(element.text or "").strip() for element in parameter.findall("element")]
    is_other = parameter.tag == "string-enumeration" and value not in VERBS and value not in elements
    return is_beyond or is_other


def accepted_advice(tree):
    """An option that a tool names (`--p`, or `the parameter "p"`) is built in or declared by its XML; a parameter that
    a module names is declared by a tool that links the module; each such tool accepts the value after it. An option
    after the name of another tool and an opening parenthesis is an option of that tool."""
    modules = declared(tree)
    folders = {name: folder for folder, module in modules.items() for name in (module.name, folder.name)}
    tools = {}  # name: parameters, folders whose messages the tool may print
    for xml in tree.below("Applications"):
        if xml.suffix == ".xml" and xml.stem == xml.parent.name:
            reached = folders_of(tree, xml.parent / "CMakeLists.txt", folders, modules)
            tools[xml.stem] = parameters_of(tree, xml), reached
    for file in tree.sources("Applications", "Modules"):
        if "test" not in file.parts:
            yield from faults_of(tree, file, tools)


def faults_of(tree, file, tools):
    """Yields the faults of a source."""
    names_options = file.parts[0] == "Applications" or file.parts[:2] == ("Modules", "Tools")
    folder = folder_of(file) if file.parts[0] == "Modules" else Path(*file.parts[:2])
    for line, text in tree.strings(file):
        for other, option, next_word, parameter, value in MENTION.findall(text):
            name, value = option or parameter, value or next_word
            if name in BUILT_IN or not (names_options or parameter):
                continue
            speakers = {other} if other in tools else {t for t, (_, folders) in tools.items() if folder in folders}
            declaring = [tool for tool in sorted(speakers) if name in tools[tool][0]]
            if not declaring:
                rest = f"{other} does not declare" if other in tools else "no tool that may print it declares"
                yield Fault(str(file), line, f"names the option --{name}, which {rest}")
            for tool in declaring:
                if value and (name, value) not in CONDITIONAL and is_rejected(value, tools[tool][0][name]):
                    yield Fault(str(file), line, f"names --{name} {value}, which {tool} rejects")
