#!/usr/bin/env python3
"""Generates code from the declarations of options, Modules/*/*/options/<Struct>.json.

usage: options.py header DECLARATION.json FOLDER    writes shapeton<Struct>.h and shapeton<Struct>Methods.h
       options.py xml TOOL.xml OUTPUT               expands <option of="Struct" names="a b"/>
       options.py python TEMPLATE.py.in OUTPUT      expands {options Struct: a b} and the like
       options.py readme README.md                  rewrites the tables after <!-- options Struct: a b -->

The guide describes the declarations: Documentation/developer-guide.md, section "Options".
"""

from __future__ import annotations

import copy
import fractions
import functools
import json
import pathlib
import re
import sys
import textwrap
from typing import Any, Callable

ROOT = pathlib.Path(__file__).resolve().parent.parent
OWN_KEYS = {"sentence", "bases", "include", "defaults", "options"}
OPTION_KEYS = {
    "name", "type", "enum", "words", "unit", "default", "minimum", "maximum", "above", "below", "step", "label",
    "sentence", "open",
}  # fmt: skip

# type: (C++ type, element of a tool's XML, Python annotation)
TYPES = {
    "bool": ("bool", "boolean", "bool"),
    "int": ("int", "integer", "int"),
    "uint": ("unsigned int", "integer", "int"),
    "uint64": ("std::uint64_t", "integer", "int"),
    "double": ("double", "double", "float"),
    "string": ("std::string", "string", "str"),
    "word": ("", "string-enumeration", "str"),
    "pair": ("std::array<double, 2>", "double-vector", "Tuple[float, float]"),
    "point": ("itk::Point<double, 3>", "point", "Point"),
}


def fail(text: str) -> None:
    sys.exit(f"options.py: {text}")


def camel(word: str) -> str:
    """solid-angle -> SolidAngle"""
    return "".join(part[:1].upper() + part[1:] for part in re.split(r"[-_ ]", word))


def snake(name: str) -> str:
    """timeSteps -> time_steps, seriesUID -> series_uid"""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower()


def words_of(name: str) -> str:
    """timeSteps -> Time steps, seriesUID -> Series UID"""
    parts = re.split(r"(?<=[a-z0-9])(?=[A-Z])", name)
    return " ".join([camel(parts[0])] + [part if part.isupper() else part.lower() for part in parts[1:]])


def number(value: Any) -> float | int:
    """A JSON number, or a fraction such as "1/12"."""
    return float(fractions.Fraction(value)) if isinstance(value, str) else value


def text_of(value: Any) -> str:
    """A number in words: 1e-6 instead of 1e-06."""
    return re.sub(r"e(-?)0(\d)$", r"e\1\2", str(value))


def plain(value: float | int) -> str:
    """The shortest decimal text without exponent, for XML."""
    text = repr(value)
    return f"{value:.20f}".rstrip("0") if "e" in text else text


class Option:
    """One option of a declaration."""

    def __init__(self, data: dict[str, Any], where: str) -> None:
        self.name: str = data.get("name", "?")
        if unknown := set(data) - OPTION_KEYS:
            fail(f"{where}: the option {self.name} has the unknown key {min(unknown)}")
        for key in ("name", "type", "sentence"):
            if key not in data:
                fail(f"{where}: the option {self.name} lacks \"{key}\"")
        self.kind, self.suffix = re.fullmatch(r"(\w+)(\[\]|\?)?", data["type"]).groups()
        if self.kind not in TYPES:
            fail(f"{where}: the option {self.name} has the unknown type {self.kind}")
        self.enum: str = data.get("enum", "")
        words = data.get("words", [])
        self.is_open = data.get("open", False)  # the library accepts further words
        self.words: dict[str, str] = words if isinstance(words, dict) else {word: camel(word) for word in words}
        self.default: Any = data.get("default")
        self.bounds = {key: data[key] for key in ("minimum", "maximum", "above", "below") if key in data}
        self.step = data.get("step")
        self.unit: str = data.get("unit", "")
        self.label: str = data.get("label", words_of(self.name))
        self.sentence: str = data["sentence"]

    @property
    def is_number(self) -> bool:
        return self.kind in ("int", "uint", "uint64", "double")

    def having(self, **members: Any) -> Option:
        """A copy with other members."""
        other = copy.copy(self)
        other.__dict__.update(members)
        return other

    def with_default(self, default: Any) -> Option:
        return self.having(default=default)

    def with_minimum(self, minimum: Any) -> Option:
        return self.having(bounds={**self.bounds, "minimum": minimum})

    def with_unset(self, text: str) -> Option:
        """The same option with another value as its default, for example "-1: from the preset"."""
        value = text.split(":")[0]
        other = self.with_default(value if self.words else json.loads(value))
        if self.words:
            other.words = {value: "", **self.words}
        else:
            other.bounds = {"minimum": min(self.bounds["minimum"], other.default),
                            "maximum": max(self.bounds["maximum"], other.default)}  # fmt: skip
        other.sentence, other.unit = f"{self.description()[:-1]}; {text}.", ""
        return other

    def optional(self) -> Option:
        """The same option in a function that also accepts None."""
        return self.having(suffix="?")

    # ---- in words ----

    def range(self) -> str:
        """For example "0 to 1000" or "more than 0, at most 1/12"."""
        if {"minimum", "maximum"} <= set(self.bounds):
            return f"{text_of(self.bounds['minimum'])} to {text_of(self.bounds['maximum'])}"
        words = {"minimum": "at least", "above": "more than", "maximum": "at most", "below": "less than"}
        return ", ".join(f"{words[key]} {text_of(self.bounds[key])}" for key in words if key in self.bounds)

    def description(self) -> str:
        """The sentence, the unit and the range, without the default."""
        facts = ", ".join(filter(None, [self.unit and f"in {self.unit}", self.range()]))
        return self.sentence + (f" {facts[:1].upper()}{facts[1:]}." if facts else "")

    def default_in_words(self) -> str:
        if self.default is None or self.default == []:
            return "none" if self.suffix else ""
        if isinstance(self.default, list):
            return ",".join(map(text_of, self.default))
        return {True: "on", False: "off"}.get(self.default, "") if self.kind == "bool" else text_of(self.default)

    # ---- C++ ----

    def cpp_type(self) -> str:
        single = TYPES[self.kind][0] or self.enum
        return {None: single, "[]": f"std::vector<{single}>", "?": f"std::optional<{single}>"}[self.suffix]

    def cpp_argument(self) -> str:
        """The type for arguments and results: numbers and enumerations by value."""
        is_small = not self.suffix and self.kind not in ("string", "pair", "point")
        return self.cpp_type() if is_small else f"const {self.cpp_type()} &"

    def cpp_default(self, value: Any = None) -> str:
        value = self.default if value is None else value
        if value is None or value == []:
            return ""
        if isinstance(value, list):
            return ", ".join(map(self.cpp_default, value))
        if self.kind == "word":
            return f"{self.enum}::{self.words[value]}"
        if self.kind == "bool":
            return str(value).lower()
        if self.kind == "string":
            return json.dumps(value)
        return self.cpp_number(value)

    def cpp_number(self, value: Any) -> str:
        if isinstance(value, str):
            top, bottom = value.split("/")
            return f"{top}.0 / {bottom}.0"
        text = repr(value)
        return text if self.kind != "double" or set(text) & set(".e") else text + ".0"

    def cpp_info(self) -> str:
        """The expression of its OptionInfo."""
        setters = {"minimum": "AtLeast", "above": "Above", "maximum": "AtMost", "below": "Below"}
        calls = [f'.{setters[key]}({float(number(value))!r}, "{text_of(value)}")' for key, value in self.bounds.items()]
        if self.words and not self.is_open:
            calls.append(".Words({ " + ", ".join(map(json.dumps, self.words)) + " })")
        return f'OptionInfo("{self.name}")' + "".join(calls)

    # ---- XML ----

    def xml(self, hidden: bool = False) -> str:
        tag = TYPES["word" if self.words else self.kind][1]
        tag += "-vector" if self.suffix == "[]" and self.kind != "point" else ""
        tag = "string" if self.suffix == "?" and self.is_number else tag  # a number or "auto"
        attributes = ' multiple="true" coordinateSystem="lps"' if self.kind == "point" else ' hidden="true"' if hidden else ""
        lines = [
            f"<name>{self.name}</name>",
            f"<longflag>{self.name}</longflag>",
            f"<label>{self.label}{self.unit and f' ({self.unit})'}</label>",
            f"<description><![CDATA[{self.sentence}{self.unit and f' In {self.unit}.'}]]></description>",
        ]
        lines += [f"<default>{self.xml_default()}</default>"] if self.kind != "point" else []
        lines += [f"<element>{word}</element>" for word in self.words]
        if self.bounds and self.is_number and not self.suffix:
            lines.append(f"<constraints>{self.xml_constraints()}</constraints>")
        return "".join([f"<{tag}{attributes}>\n"] + [f"      {line}\n" for line in lines] + [f"    </{tag}>"])

    def xml_default(self) -> str:
        if self.default is None or self.default == []:
            return "auto" if self.suffix == "?" and self.is_number else ""
        if isinstance(self.default, list):
            return ",".join(map(str, self.default))
        if self.kind == "bool":
            return str(self.default).lower()
        return plain(number(self.default)) if self.is_number else str(self.default)

    def xml_constraints(self) -> str:
        step = self.step if self.step is not None else 1
        parts = {
            "minimum": self.bounds.get("minimum", self.bounds.get("above")),
            "maximum": self.bounds.get("maximum", self.bounds.get("below")),
            "step": step,
        }
        return "".join(f"<{key}>{plain(number(value))}</{key}>" for key, value in parts.items() if value is not None)

    # ---- Python ----

    def python_parameter(self) -> str:
        single = TYPES[self.kind][2]
        several = "Points" if self.kind == "point" else f"Sequence[{single}]"
        kinds = {None: single, "[]": several, "?": f"Optional[{single}]"}
        return f"{snake(self.name)}: {kinds[self.suffix]} = {self.python_default()}"

    def python_default(self) -> str:
        if self.suffix == "[]":
            return repr(tuple(self.default or ()))
        if self.default is None:
            return '""' if self.kind == "string" and not self.suffix else "None"
        if self.is_number:
            return repr(number(self.default)) if self.kind != "double" else repr(float(number(self.default)))
        return json.dumps(self.default) if isinstance(self.default, str) else repr(self.default)


class Declaration:
    """The options of a struct, those of its bases first."""

    def __init__(self, path: pathlib.Path) -> None:
        self.path = path
        self.struct = path.stem
        self.module = path.parent.parent.name
        try:
            data = json.loads(path.read_text(encoding="utf-8"))
        except ValueError as error:
            fail(f"{path}: {error}")
        if unknown := set(data) - OWN_KEYS:
            fail(f"{path}: unknown key {min(unknown)}")
        self.sentence: str = data["sentence"]
        self.include: list[str] = data.get("include", [])
        self.bases = [declaration(base) for base in data.get("bases", [])]
        self.defaults: dict[str, Any] = data.get("defaults", {})
        self.own = [Option(option, str(path)) for option in data["options"]]

    def options(self) -> list[Option]:
        return [o.with_default(self.defaults.get(o.name, o.default)) for o in self.inherited()] + self.own

    def inherited(self) -> list[Option]:
        return [option for base in self.bases for option in base.options()]

    def chosen(self, names: str) -> list[Option]:
        """The options with these names; all if `names` is "*"."""
        by_name = {option.name: option for option in self.options()}
        wanted = list(by_name) if names.strip() == "*" else names.split()
        for name in wanted:
            if name not in by_name:
                fail(f"{self.struct} has no option {name}; it has {', '.join(by_name)}")
        return [by_name[name] for name in wanted]


@functools.lru_cache(maxsize=None)
def declaration(struct: str) -> Declaration:
    paths = list(ROOT.glob(f"Modules/*/*/options/{struct}.json"))
    if len(paths) != 1:
        fail(f"{len(paths)} declarations Modules/*/*/options/{struct}.json instead of one")
    return Declaration(paths[0])


def comment(text: str, indent: str = "") -> str:
    text = text.replace("ingroup ", "ingroup\xa0")  # on one line with its group
    lines = [line.replace("\xa0", " ") for line in textwrap.wrap(text, 120 - len(indent) - 7)]
    return "\n".join([f"{indent}/** {lines[0]}"] + [f"{indent} * {line}" for line in lines[1:]]) + " */"


# ---- headers ----


def member(option: Option) -> str:
    default = f"{{ {option.cpp_default()} }}" if option.cpp_default() else ""
    if not default and option.is_number and not option.suffix:
        fail(f"the option {option.name} lacks a default")
    return f"{comment(option.description(), '  ')}\n  {option.cpp_type()} {option.name}{default};\n"


def struct_header(d: Declaration) -> str:
    includes = [f"shapeton{base.struct}.h" for base in d.bases]
    text = "".join(f'#include "{name}"\n' for name in sorted({"shapetonOptions.h", *includes, *d.include}))
    inherited = {option.name: option for option in d.inherited()}
    defaults = "".join(
        f"    this->{name} = {inherited[name].cpp_default(value)};\n" for name, value in d.defaults.items()
    )
    constructor = f"  {d.struct}()\n  {{\n{defaults}  }}\n" if defaults else ""
    visits = "".join(f"    visit({o.cpp_info()}, options.{o.name});\n" for o in d.own)
    base_visits = "".join(f"    {base.struct}::VisitOptions(options, visit);\n" for base in d.bases)
    bases = ", ".join(base.struct for base in d.bases)
    return f"""// Generated from {d.path.relative_to(ROOT)}.
#ifndef shapeton{d.struct}_h
#define shapeton{d.struct}_h

{text}
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace shapeton
{{
{comment(f"{d.sentence} " + chr(92) + f"ingroup Shapeton{d.module}")}
struct {d.struct}{f" : {bases}" if bases else ""}
{{
{constructor}{"".join(map(member, d.own))}
  /** Calls `visit(info, member)` for each option, those of the bases first. */
  template <typename TOptions, typename TVisitor>
  static void
  VisitOptions(TOptions & options, const TVisitor & visit)
  {{
{base_visits}{visits}  }}
}};
}} // namespace shapeton

#endif
"""


def methods(option: Option) -> str:
    name = option.name[:1].upper() + option.name[1:]
    on = f"  itkBooleanMacro({name});\n" if option.cpp_type() == "bool" else ""
    return f"""{comment(option.description() + f" Default {option.default_in_words()}." * bool(option.default_in_words()), "  ")}
  virtual void
  Set{name}({option.cpp_argument()} value)
  {{
    this->SetOption(this->m_Options.{option.name}, value);
  }}
  virtual {option.cpp_argument()}
  Get{name}() const
  {{
    return this->m_Options.{option.name};
  }}
{on}"""


def methods_header(d: Declaration) -> str:
    return f"""// Generated from {d.path.relative_to(ROOT)}.
#ifndef shapeton{d.struct}Methods_h
#define shapeton{d.struct}Methods_h

#include "shapeton{d.struct}.h"

#include "itkMacro.h"

namespace shapeton
{{
/** \\class {d.struct}Methods
 * \\brief Set and Get methods of the members of {d.struct} that its bases lack.
 *
 * \\tparam TFilter a class derived from FilterWithOptions whose options are derived from the struct.
 * \\ingroup Shapeton{d.module} */
template <typename TFilter>
class {d.struct}Methods : public TFilter
{{
public:
{chr(10).join(map(methods, d.own))}
protected:
  using TFilter::TFilter;
  ~{d.struct}Methods() override = default;
}};
}} // namespace shapeton

#endif
"""


# ---- expansion of templates ----

REFERENCE = r"(\w+): ?([\w* ]+)"


def expand_xml(text: str) -> str:
    def element(match: re.Match[str]) -> str:
        attributes = dict(re.findall(r'(\w+)="([^"]*)"', match[1]))
        if unknown := set(attributes) - {"of", "names", "default", "minimum", "unset", "automatic", "hidden"}:
            fail(f"<option> has the unknown attribute {min(unknown)}")
        chosen = declaration(attributes["of"]).chosen(attributes["names"])
        if "default" in attributes:
            chosen = [option.with_default(json.loads(attributes["default"])) for option in chosen]
        if "minimum" in attributes:
            chosen = [option.with_minimum(json.loads(attributes["minimum"])) for option in chosen]
        if "automatic" in attributes:
            chosen = [option.optional().with_default(None) for option in chosen]
        if "unset" in attributes:
            chosen = [option.with_unset(attributes["unset"]) for option in chosen]
        hidden = "hidden" in attributes  # from panels of 3D Slicer
        return "\n    ".join(option.xml(hidden) for option in chosen)

    return re.sub(r"<option ([^>]*)/>", element, text)


def expand_python(text: str) -> str:
    def expansion(pattern: str, make: Callable[[Option], str]) -> None:
        nonlocal text
        text = re.sub(
            rf"^( *)\{{{pattern} {REFERENCE}\}}\n",
            lambda m: "".join(textwrap.indent(make(o), m[1]) + "\n" for o in declaration(m[2]).chosen(m[3])),
            text,
            flags=re.M,
        )

    expansion("options", lambda option: option.python_parameter() + ",")
    expansion("optional", lambda option: option.optional().python_parameter() + ",")
    expansion("unset", lambda option: option.optional().with_default(None).python_parameter() + ",")
    expansion("values", lambda option: f'"{option.name}": {snake(option.name)},')
    expansion("sentences", lambda option: textwrap.fill(
        f"{snake(option.name)}: {option.description()}", 110, subsequent_indent="    "))  # fmt: skip
    return re.sub(rf"{{default {REFERENCE}}}", lambda m: declaration(m[1]).chosen(m[2])[0].default_in_words(), text)


def readme_row(option: Option) -> str:
    has_unnamed_words = any(word not in option.sentence for word in option.words)
    words = f" Values: {', '.join(option.words)}." if has_unnamed_words else ""
    default = option.xml_default() if option.default is None else option.default_in_words()
    return f"| `--{option.name}` | {default or 'none'} | {option.description()}{words} |\n"


def readme_table(options: list[Option]) -> str:
    return "| Option | Default | Meaning |\n|---|---|---|\n" + "".join(map(readme_row, options))


def expand_readme(text: str) -> str:
    return re.sub(
        rf"(<!-- options {REFERENCE} -->\n)(?:\|.*\n)*",
        lambda m: m[1] + readme_table(declaration(m[2]).chosen(m[3])),
        text,
    )


def write(path: pathlib.Path, text: str) -> None:
    """Keeps the time of an unchanged file, so that nothing is compiled again."""
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def main(arguments: list[str]) -> None:
    if len(arguments) < 2:
        sys.exit(__doc__)
    command, source = arguments[0], pathlib.Path(arguments[1]).resolve()
    if command == "header":
        d = declaration(source.stem)
        write(pathlib.Path(arguments[2]) / f"shapeton{d.struct}.h", struct_header(d))
        write(pathlib.Path(arguments[2]) / f"shapeton{d.struct}Methods.h", methods_header(d))
    elif command == "readme":
        write(source, expand_readme(source.read_text(encoding="utf-8")))
    elif command in ("xml", "python"):
        expand = {"xml": expand_xml, "python": expand_python}[command]
        write(pathlib.Path(arguments[2]), expand(source.read_text(encoding="utf-8")))
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main(sys.argv[1:])
