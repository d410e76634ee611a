"""Pages, links, data, sizes and texts of the whole repository."""

import os
import re
from pathlib import Path

from .modules import DECLARATION
from .tree import Fault, find, is_source, line_at
from .xml_tree import options

LARGEST_FILE = 1_000_000
LONGEST_TOOL = 150
LONGEST_PAGES = (  # kind, regular expression of the path, words; the first that matches applies
    ("the changelog", r"CHANGELOG\.md", 400),
    ("the first page", r"README\.md", 1000),
    ("the page of a module", r"Modules/.*", 350),
    ("the page of a tool", r"Applications/.*", 550),
    ("a page of validation", r"Documentation/validation/.*", 1700),
    ("the developer guide", r"Documentation/developer-guide\.md", 2600),
    ("the page of figures", r"Documentation/figures\.md", 3700),
    ("a page of Documentation", r"Documentation/.*", 1500),
    ("another page", r".*", 800),
)
LONGEST_DOCUMENTATION = 60_000
TABLES = "Documentation/validation/tables"
CODE = re.compile(r"`[^`]*`")
LINK = re.compile(r'\]\(\s*<?([^)>\s]+)|^\s*\[[^\]]+\]:\s*(\S+)|(?:src|href)="([^"]+)"')
WEB = re.compile(r"[A-Za-z][A-Za-z0-9+.-]*:")
TABLE_LINK = re.compile(r"\]\((tables/[^)]+)\)(?:\s\((\d+) failed\))?")
HEADING = re.compile(r"^#+ +(.*?) *#*$", re.MULTILINE)
MACHINE = re.compile(r"/(?:home|root|work|Users)/|:\\Users")
LICENSE = re.compile(r"General[ ]Public License|All rights[ ]reserved|Copyright[ ]\(")
# ITK's loops: nested calls may deadlock, and if progress throws, a call returns while its threads are still running.
LOOP = re.compile(r"(?:MultiThreaderBase::New|GetMultiThreader)\(\)->Parallelize")
PI = re.compile(r"\bM_PI\b")
THREAD = re.compile(r"std::async\(|std::thread(?:>| \w+[({])")


def links(markdown):
    """Yields the line and the target of each link and picture of a Markdown text, except in code."""
    in_block = False
    for number, line in enumerate(markdown.split("\n"), 1):
        in_block ^= "```" in line
        if not in_block:
            for match in LINK.finditer(CODE.sub("", line)):
                yield number, match[match.lastindex]


def anchors(markdown):
    """Returns the anchors that a Markdown viewer generates for the headings."""
    return {"".join(c.lower() for c in heading.replace(" ", "-") if c.isalnum() or c in "-_" or c > "\x7f")
            for heading in HEADING.findall(markdown)}


def fault_of_link(tree, page, target):
    """Returns the fault of a link inside the repository, or None."""
    path, has_anchor, anchor = target.partition("#")
    file = Path(os.path.normpath(page.parent / path)) if path else page
    if file.parts[:1] == ("..",):
        return "leaves the repository"
    if not (tree.root / file).exists():
        return "points to a missing file"
    if has_anchor and file.suffix == ".md" and anchor not in anchors(tree.text(file)):
        return "points to a missing heading"
    return None


def broken_links(tree):
    """Every link of a Markdown file points to an existing file or heading of the repository, or to the web."""
    for page in tree.files:
        for line, target in links(tree.text(page)) if page.suffix == ".md" else ():
            fault = None if WEB.match(target) else fault_of_link(tree, page, target)
            if fault:
                yield Fault(str(page), line, f"the link {target} {fault}")


def pages(tree):
    """Every module and tool has a README.md that Documentation/index.md links; Data/README.md names all data."""
    index, data = Path("Documentation/index.md"), Path("Data/README.md")
    linked = {os.path.normpath(index.parent / target) for _, target in links(tree.text(index))} \
        if index in tree.known else set()
    for file in tree.files:
        is_tool = len(file.parts) == 3 and file.parts[0] == "Applications" and file.name == "CMakeLists.txt"
        if is_tool or file.name == DECLARATION and len(file.parts) > 1:
            page = file.parent / "README.md"
            if page not in tree.known:
                yield Fault(str(file.parent), 0, "has no README.md")
            if str(page) not in linked:
                yield Fault(str(index), 0, f"has no link to {page}")
    text = tree.text(data) if data in tree.known else ""
    for name in sorted({file.parts[1] for file in tree.below("Data")} - {"README.md"}):
        if name not in text:
            yield Fault(f"Data/{name}", 0, "Data/README.md does not state its source and license")


def sizes(tree):
    """Files have at most 1 MB."""
    for file in tree.files:
        size = (tree.root / file).stat().st_size
        if size > LARGEST_FILE:
            yield Fault(str(file), 0, f"has {size} bytes, more than 1 MB")


def short_pages(tree):
    """Pages have at most the words of LONGEST_PAGES, and LONGEST_DOCUMENTATION together; measured tables are CSV files."""
    total = 0
    for page in tree.files:
        if page.suffix != ".md":
            continue
        words = len(tree.text(page).split())
        total += words
        kind, limit = next((kind, limit) for kind, path, limit in LONGEST_PAGES if re.fullmatch(path, str(page)))
        if words > limit:
            yield Fault(str(page), 0, f"has {words} words; {kind} has at most {limit}")
    if total > LONGEST_DOCUMENTATION:
        yield Fault("README.md", 0, f"all pages have {total} words, more than {LONGEST_DOCUMENTATION}")


def stated_failures(tree):
    """Each table of a validation is linked with the number of its failed rows: [measures](tables/a.csv) (2 failed)."""
    linked = set()
    for page in tree.below("Documentation/validation"):
        for match in TABLE_LINK.finditer(tree.text(page)) if page.suffix == ".md" else ():
            file = page.parent / match[1]
            failed = sum("FAIL" in row for row in tree.text(file).split("\n")) if file in tree.known else 0
            linked.add(file)
            if failed != int(match[2] or 0):
                line = line_at(tree.text(page), match.start())
                yield Fault(str(page), line, f"must state that {failed} rows of {file.name} failed")
    for file in tree.below(TABLES):
        if file not in linked:
            yield Fault(str(file), 0, "is not linked by a page of Documentation/validation")


def texts(tree):
    """Texts contain no machine-specific paths; sources contain no license or copyright notice, which would indicate
    copied code, and use only the parallel loops of shapetonParallelFor.h and the constants of shapetonPi.h."""
    for file in tree.files:
        if "\0" in tree.text(file):
            continue
        yield from find(tree, file, MACHINE, "contains a machine-specific path: ")
        if is_source(file):
            yield from find(tree, file, LICENSE, "contains a foreign license: ")
            yield from find(tree, file, LOOP, "has a loop that does not use shapetonParallelFor.h: ")
            yield from find(tree, file, PI, "does not use shapetonPi.h: ")
            if file.parts[0] == "Modules" and "test" not in file.parts:
                yield from find(tree, file, THREAD, "starts a thread without shapetonParallelFor.h: ")


def option_tables(tree):
    """Tables of options are those that their declarations generate."""
    for page in tree.files:
        if page.suffix == ".md" and options.expand_readme(tree.text(page)) != tree.text(page):
            yield Fault(str(page), 0, "has an old table of options: run CMake/options.py readme")


def short_tools(tree):
    """Tools have at most 150 lines: a tool parses options, calls modules and writes results."""
    for file in tree.sources("Applications"):
        lines = len(tree.text(file).splitlines())
        if len(file.parts) == 3 and lines > LONGEST_TOOL:
            yield Fault(str(file), 0, f"has {lines} lines, more than {LONGEST_TOOL}; move code to a module")
