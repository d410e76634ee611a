"""Scripts of pages and their tests. The modules of a folder `scripts` are joined with their imports into one script, so
their top-level names must be unique."""

import os
import re
import shutil
import subprocess
from pathlib import Path

from .tree import Fault, line_at

WIDTH = 140  # characters of a line
LONGEST = 60  # lines of a function or method at the top level or in a class
IN_LINES = {
    r"https?://": "contains a network address",
    r"\s$": "ends with a blank",
    r"\t": "contains a tab",
    rf"^.{{{WIDTH + 1},}}$": f"has more than {WIDTH} characters",
}
NETWORK = r"\b(fetch|XMLHttpRequest|WebSocket|EventSource|sendBeacon|importScripts)\b"
ONLINE = {Path("Modules/Tools/LiveSession/scripts/connection.mjs")}  # the only script with a connection, to its own server
IN_CODE = {
    NETWORK: "uses the network",
    r"\b(eval|Function)\s*\(": "evaluates text as code",
    r"\b(var|debugger|alert)\b[^.,;:'’]": "is not allowed",
    r"[^=!]==[^=]|!=[^=]": "compares without ===",
    r"innerHTML(?! = [A-Z]+;)": "creates elements from nonconstant text",
}
STRING, COMMENT = re.compile(r"""(['"])(?:\\.|(?!\1).)*\1"""), re.compile(r"(^|\s)//.*")
# Blocks that start in column 0 or 2 and end with a brace in the same column.
BLOCK = re.compile(r"^(?=((?:export )?(?:async )?function .*\{$(?:\n.*)*?\n\}$|"
                   r"  (?:async |get )?\w+\(.*\) \{$(?:\n.*)*?\n  \}$))", re.MULTILINE)
IMPORT = re.compile(r"^import \{ ([^}]*) \} from '([^']*)'", re.MULTILINE)
RELATIVE = re.compile(r"^import [^;]* from '(\.[^']*)'", re.MULTILINE)
TOP_LEVEL = re.compile(r"^(export )?(?:async )?(?:const|let|function|class) (\w+)", re.MULTILINE)
# Prints the positions of the scripts that have syntax errors; one process is much faster than one per script.
PARSE = """const { SourceTextModule } = require('vm'), { readFileSync } = require('fs');
process.argv.slice(1).forEach((file, i) => {
  try { new SourceTextModule(readFileSync(file, 'utf8')); } catch { console.log(i); }
});"""
ERROR = re.compile(r":(\d+)\n.*?^(\w+Error: .*?)$", re.MULTILINE | re.DOTALL)


def page_scripts(tree):
    """Scripts are valid and short, and contain no network access, unused imports or exports, or forbidden code."""
    scripts = [file for file in tree.files if file.suffix == ".mjs"]
    yield from faults_of_syntax(tree, scripts)
    for file in scripts:
        text = tree.text(file)
        for number, line in enumerate(text.split("\n"), 1):
            code = COMMENT.sub("", STRING.sub("''", line))
            for patterns, searched in ((IN_LINES, line), (IN_CODE, code)):
                for pattern, message in patterns.items():
                    if re.search(pattern, searched) and not (pattern == NETWORK and file in ONLINE):
                        yield Fault(str(file), number, message)
        for match in BLOCK.finditer(text):
            lines = match[1].count("\n")
            if lines > LONGEST:
                yield Fault(str(file), line_at(text, match.start()), f"is a function of {lines} lines, more than {LONGEST}")
        for names, source in IMPORT.findall(text):
            for name in names.split(", "):
                if len(re.findall(rf"\b{name}\b", text)) < 2:
                    yield Fault(str(file), 1, f"imports {name} and does not use it")
            if source.startswith(".") and imported(file, source) not in tree.known:
                yield Fault(str(file), 1, f"imports {source}, which is missing")
            elif not source.startswith((".", "node:")):
                yield Fault(str(file), 1, f"imports the package {source}")
    for folder in sorted({file.parent for file in scripts if file.parent.name == "scripts"}):
        yield from faults_of_joined(tree, folder, scripts)


def imported(file, source):
    """Returns the file that a relative import names."""
    return Path(os.path.normpath(file.parent / source))


def faults_of_syntax(tree, scripts):
    """Yields the syntax errors that node finds, if it is installed."""
    node = shutil.which("node")
    if node and scripts:
        files = [str(tree.root / file) for file in scripts]
        run = subprocess.run([node, "--no-warnings", "--experimental-vm-modules", "-e", PARSE, *files],
                             stdout=subprocess.PIPE, text=True, check=True)
        for place in map(int, run.stdout.split()):
            errors = subprocess.run([node, "--check", files[place]], stderr=subprocess.PIPE, text=True, check=False).stderr
            line, message = ERROR.search(errors).groups()
            yield Fault(str(scripts[place]), int(line), message)


def faults_of_joined(tree, folder, scripts):
    """Yields the faults of the script that consists of the modules of a folder and all their imports."""
    joined = [file for file in scripts if file.parent == folder]
    for file in joined:  # grows during the iteration
        imports = [imported(file, source) for source in RELATIVE.findall(tree.text(file))]
        joined += [other for other in dict.fromkeys(imports) if other not in joined and other in scripts]
    owner = {}
    for file in sorted(joined):
        for exported, name in TOP_LEVEL.findall(tree.text(file)):
            if name in owner:
                yield Fault(str(file), 1, f"has the top-level name {name} of {owner[name].name}")
            owner[name] = file
            used = re.compile(rf"^import [^;]*\b{name}\b", re.MULTILINE)
            if exported and not name.startswith("start") and not any(
                    used.search(tree.text(other)) for other in scripts if other != file):
                yield Fault(str(file), 1, f"exports {name}, which no module imports")
