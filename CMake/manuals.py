#!/usr/bin/env python3
"""Writes a manual page and completions for bash, zsh and fish, for each tool.

usage: manuals.py FOLDER DATE TOOL.xml...    replaces the folder, which has the layout of /usr/share

DATE is that of the version, as in the header of a mail. The descriptions must be expanded by options.py. Equal input gives
equal bytes.
"""

from __future__ import annotations

import email.utils
import gzip
import pathlib
import re
import shutil
import sys
import textwrap
import xml.etree.ElementTree as ElementTree
from typing import Sequence

WIDTH = 78  # of lines of a page

# Options of shapeton::CommandLine: name, value, description.
STANDARD = (
    ("quiet", "", "Print no progress."),
    ("echo", "", "Print the values of the parameters."),
    ("returnparameterfile", "file", "Write the return values as lines name = value."),
    ("processinformationaddress", "address", "Passed by module hosts; no effect in a separate process."),
    ("xml", "", "Print the description of the tool for 3D Slicer."),
    ("version", "", "Print the version."),
    ("help", "", "Print the options."),
)

EXIT_STATUS = (
    ("0", "Done, also with warnings."),
    ("1", "Any other failure: output not writable, disk full, out of memory."),
    ("2", "Usage error: an option is missing, unknown, out of range or contradicts another."),
    ("3", "The input is missing, unreadable, malformed or unsuitable."),
)


#: What the value of a parameter is, as in --help; a file without extensions may be a folder.
KINDS = {"image": "volume", "geometry": "surface", "directory": "folder", "point": "x,y,z", "boolean": "",
         "string-enumeration": "word"}  # fmt: skip


def kind_of(element: ElementTree.Element) -> str:
    """What follows an option."""
    tag = element.tag
    if tag in KINDS:
        return KINDS[tag]
    if tag.split("-")[0] in ("integer", "double", "float"):
        return ("integer" if tag.startswith("integer") else "number") + (",..." if tag.endswith("-vector") else "")
    if tag.startswith("string"):
        return "number|auto" if element.findtext("default") == "auto" else "text"
    return "file" if element.get("fileExtensions") else "path"


class Parameter:
    """A parameter of a tool."""

    def __init__(self, element: ElementTree.Element) -> None:
        def text(path: str) -> str:
            return (element.findtext(path) or "").strip()

        self.name = text("name")
        self.label = text("label")
        self.flag = text("flag")
        self.index = int(text("index") or -1)
        self.is_option = bool(text("longflag"))
        self.is_multiple = element.get("multiple") == "true"
        self.words = [(word.text or "").strip() for word in element.findall("element")]
        self.range = (text("constraints/minimum"), text("constraints/maximum"))
        self.value = kind_of(element)
        self.default = text("default") if self.value else ""
        self.description = text("description")

    @property
    def facts(self) -> str:
        """Sentences about words, range and default."""
        minimum, maximum = self.range
        ranges = f"{minimum} to {maximum}" if minimum and maximum else minimum and f"at least {minimum}"
        ranges = ranges or maximum and f"at most {maximum}"
        values = {"Values": ", ".join(self.words), "Range": ranges, "Default": self.default}
        return "".join(f" {name}: {value}." for name, value in values.items() if value)


class Tool:
    """The description of a tool."""

    def __init__(self, path: pathlib.Path) -> None:
        root = ElementTree.parse(path).getroot()
        self.name = path.stem
        self.category = root.findtext("category", "").strip()
        self.version = root.findtext("version", "").strip()
        self.description = root.findtext("description", "").strip()
        # label, description, parameters
        self.groups = [
            (
                group.findtext("label", "").strip(),
                group.findtext("description", "").strip(),
                [Parameter(element) for element in group if element.find("name") is not None],
            )
            for group in root.findall("parameters")
        ]
        self.parameters = [parameter for _, _, parameters in self.groups for parameter in parameters]
        self.options = [parameter for parameter in self.parameters if parameter.is_option]

    @property
    def summary(self) -> str:
        """The beginning of the description, for the line of whatis."""
        text = re.split(r"[.:;](?:\s|$)", self.description)[0]
        return text[0].lower() + text[1:] if text[1].islower() else text

    def names_in_text(self, names: set[str]) -> set[str]:
        texts = [self.description] + [text for _, text, _ in self.groups] + [p.description for p in self.parameters]
        return names & set(re.findall(r"\w+", " ".join(texts)))


# ---- manual page ----


def roff(text: str) -> str:
    """Text of a line: options with minus signs that can be copied, no character with a special meaning."""
    for character, escape in (("\\", r"\e"), ("^", r"\(ha"), ("~", r"\(ti"), ("'", r"\(aq"), ("`", r"\(ga")):
        text = text.replace(character, escape)
    return re.sub(r"(?<!\w)-(?=[\w-])", r"\-", text)


def paragraph(text: str) -> str:
    lines = textwrap.wrap(roff(text), WIDTH, break_long_words=False, break_on_hyphens=False)
    return "".join(r"\&" * line.startswith(".") + line + "\n" for line in lines)


def item(head: str, text: str) -> str:
    return f".TP\n{head}\n{paragraph(text)}"


def option_head(name: str, value: str, flag: str = "") -> str:
    return rf"\fB\-{flag}\fR, " * bool(flag) + rf"\fB\-\-{name}\fR" + rf" \fI{value}\fR" * bool(value)


def parameter_item(parameter: Parameter) -> str:
    head = option_head(parameter.name, parameter.value, parameter.flag) if parameter.is_option else rf"\fI{parameter.name}\fR"
    return item(head, parameter.description + parameter.facts)


def synopsis(tool: Tool) -> str:
    positional = sorted((p for p in tool.parameters if p.index >= 0), key=lambda p: p.index)
    names = "".join(rf" \fI{p.name}\fR" + "..." * p.is_multiple for p in positional)
    return rf"\fB{tool.name}\fR{names} [\fIoptions\fR]" + "\n"


def see_also(tool: Tool, tools: list[Tool]) -> str:
    """Tools of the same category, and those that the text names."""
    names = {other.name for other in tools if other.category == tool.category}
    names = (names | tool.names_in_text({other.name for other in tools})) - {tool.name}
    return "".join(f".BR {name} (1),\n" for name in sorted(names))[: -len(",\n")] + "\n" if names else ""


def page(tool: Tool, tools: list[Tool], date: str) -> str:
    parts = [
        f'.\\" Generated from {tool.name}.xml.\n'
        f'.TH {tool.name.upper()} 1 {date} "Shapeton {tool.version}" "Shapeton"\n',
        ".SH NAME\n" + paragraph(f"{tool.name} - {tool.summary}").replace(" - ", r" \- ", 1),
        f".SH SYNOPSIS\n{synopsis(tool)}",
        f".SH DESCRIPTION\n{paragraph(tool.description)}",
        ".SH OPTIONS\n",
    ]
    for label, description, parameters in tool.groups:
        items = [parameter_item(p) for p in parameters if p.is_option or p.index >= 0]
        parts += [f'.SS "{label}"\n{paragraph(description)}', *items] if items else []
    parts += ['.SS "Options of all tools"\n']
    parts += [item(option_head(name, value, "h" * (name == "help")), text) for name, value, text in STANDARD]
    parts += [".SH EXIT STATUS\n"] + [item(rf"\fB{status}\fR", text) for status, text in EXIT_STATUS]
    others = see_also(tool, tools)
    parts += [f".SH SEE ALSO\n{others}"] if others else []
    return "".join(parts)


# ---- completions: options, words of enumerations, names of files ----


def bash(tool: Tool) -> str:
    """Without words, bash itself completes names of files (-o default)."""
    options = [f"--{p.name}" for p in tool.options] + [f"--{name}" for name, _, _ in STANDARD]
    words = "".join(f"    --{p.name}) words='{' '.join(p.words)}' ;;\n" for p in tool.options if p.words)
    return f"""# bash completion of {tool.name}, generated from {tool.name}.xml
_shapeton_{tool.name}() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} option=${{COMP_WORDS[COMP_CWORD - 1]}} words=''
  if [[ $word == = ]]; then # --option=word consists of three words
    word=''
  elif [[ $option == = ]]; then
    option=${{COMP_WORDS[COMP_CWORD - 2]}}
  fi
  case $option in
{words}    *) [[ $word != -* ]] || words='{" ".join(options)}' ;;
  esac
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}}
complete -o default -F _shapeton_{tool.name} {tool.name}
"""


def zsh(tool: Tool) -> str:
    def option(name: str, label: str, value: str = "", words: Sequence[str] = (), is_multiple: bool = False) -> str:
        text = re.sub(r"([\\:\[\]])", r"\\\1", label)
        action = f"({' '.join(words)})" if words else "_files"
        specification = f"{'*' * is_multiple}--{name}" + (f"=[{text}]:{value}:{action}" if value else f"[{text}]")
        return "  '" + specification.replace("'", r"'\''") + "' \\\n"

    options = [option(p.name, p.label, p.value, p.words, p.is_multiple) for p in tool.options]
    options += [option(*standard) for standard in standard_labels()]
    return f"#compdef {tool.name}\n_arguments -S \\\n" + "".join(options) + "  '*:file:_files'\n"


def fish(tool: Tool) -> str:
    def option(name: str, label: str, value: str = "", words: Sequence[str] = ()) -> str:
        text = re.sub(r"([\\'])", r"\\\1", label)
        argument = f" -x -a '{' '.join(words)}'" if words else " -r" * bool(value)
        return f"complete -c {tool.name} -l {name}{argument} -d '{text}'\n"

    options = [option(p.name, p.label, p.value, p.words) for p in tool.options]
    return "".join(options + [option(*standard) for standard in standard_labels()])


def standard_labels() -> list[tuple[str, str, str]]:
    """Name, label and value of the standard options."""
    return [(name, text.rstrip("."), value) for name, value, text in STANDARD]


def write(path: pathlib.Path, content: bytes) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)


def main(arguments: list[str]) -> None:
    if len(arguments) < 3:
        sys.exit(__doc__)
    folder, date = pathlib.Path(arguments[0]), email.utils.parsedate_to_datetime(arguments[1]).date().isoformat()
    tools = [Tool(pathlib.Path(argument)) for argument in arguments[2:]]
    shutil.rmtree(folder, ignore_errors=True)
    for tool in tools:
        manual = gzip.compress(page(tool, tools, date).encode(), mtime=0)
        write(folder / f"man/man1/{tool.name}.1.gz", manual)
        write(folder / f"bash-completion/completions/{tool.name}", bash(tool).encode())
        write(folder / f"zsh/vendor-completions/_{tool.name}", zsh(tool).encode())
        write(folder / f"fish/vendor_completions.d/{tool.name}.fish", fish(tool).encode())


if __name__ == "__main__":
    main(sys.argv[1:])
