"""Module descriptions of tools: 3D Slicer's ModuleDescriptionParser must accept them, Slicer's command-line logic must
pass arguments that the tool accepts, and they must follow the tool contract.

The checks yield an element and what is wrong with it."""

import re
from xml.parsers import expat

from .tree import Fault
from .xml_tree import parse, text_of

ANY = ()
BOOLEAN = ("false", "true")
HIDDEN, MULTIPLE = {"hidden": BOOLEAN}, {"multiple": BOOLEAN}
FILES, REFERENCE = {"fileExtensions": ANY}, {"reference": ANY}
SYSTEM = {"coordinateSystem": ("ijk", "lps", "ras")}
# Attributes that Slicer's parser reads for each kind of parameter, with their values.
KINDS = {
    **dict.fromkeys(("integer", "float", "double", "string"), HIDDEN | MULTIPLE),
    **dict.fromkeys(("integer-vector", "float-vector", "double-vector", "string-vector"), {}),
    **dict.fromkeys(("integer-enumeration", "float-enumeration", "double-enumeration", "string-enumeration"), HIDDEN),
    "boolean": HIDDEN,
    "point": MULTIPLE | SYSTEM,
    "region": MULTIPLE | SYSTEM,
    "pointfile": MULTIPLE | FILES | SYSTEM | {"type": ("any", "point", "line", "angle", "curve", "closedcurve")},
    "file": MULTIPLE | FILES,
    "directory": MULTIPLE,
    "transform": MULTIPLE | FILES | REFERENCE | {"type": ("linear", "nonlinear", "bspline")},
    "image": MULTIPLE | FILES | REFERENCE | HIDDEN | {"type": (
        "any", "scalar", "label", "tensor", "diffusion-weighted", "vector", "signal", "multichannel",
        "dynamic-contrast-enhanced")},
    "geometry": MULTIPLE | FILES | REFERENCE | {"type": ("fiberbundle", "model"), "aggregate": BOOLEAN},
    "table": MULTIPLE | FILES | REFERENCE | HIDDEN | {"type": ("color",)},
    "measurement": MULTIPLE | FILES | REFERENCE | HIDDEN | {"type": ANY},
}
NODES = {"image", "geometry", "transform", "table", "measurement", "pointfile"}  # files made from nodes of Slicer's scene
HEAD = {"category", "title", "description", "version", "documentation-url", "license", "contributor", "location",
        "acknowledgements", "index", "parameters"}
REQUIRED = ("category", "title", "version", "license", "contributor")
PARAMETER = {"name", "flag", "longflag", "label", "description", "default", "channel", "index", "element", "constraints",
             "reference"}
RESERVED = {"help", "version", "xml", "quiet", "echo", "returnparameterfile", "processinformationaddress", "serialize",
            "deserialize"}  # options that shapeton::CommandLine or Slicer adds to every tool
# Options that a tool must have if it has an input of this kind, or if it has one of these options that is not in APART.
# A tool that only refers to the slices of a series selects the series by seriesUID; it may move slices by deshear, but
# not add or drop them.
SHARED = {
    ("image", "volume"): {"deshear": "boolean", "dropDuplicates": "boolean", "resampleGaps": "boolean",
                          "seriesUID": "string"},
    ("geometry", "surface"): {"component": "integer", "part": "string", "unit": "string-enumeration"},
}
APART = {"seriesUID", "deshear"}


def is_numeric(kind):
    return kind.split("-")[0] in ("integer", "float", "double")


def is_enumeration(kind):
    return kind.endswith("-enumeration")


def number(text, kind):
    """Converts text to a number of the given kind; returns None if this fails."""
    if kind.startswith("integer"):
        return int(text) if re.fullmatch("-?[0-9]+", text) and -2**31 <= int(text) < 2**31 else None
    return float(text) if re.fullmatch(r"-?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?", text) else None


def limit(parameter, name):
    """Returns the constraint "minimum", "maximum" or "step" of a parameter, or None."""
    return number((parameter.findtext(f"constraints/{name}") or "").strip(), parameter.tag)


def has(element, *children):
    return any(element.find(child) is not None for child in children)


def label(element):
    """Returns the name of an element in faults: "<image> input"."""
    return f"<{element.tag}> {text_of(element, 'name')}".rstrip()


def attributes(element, allowed):
    for name, value in element.items():
        if name not in allowed:
            yield element, f'<{element.tag}> has no attribute "{name}"'
        elif allowed[name] and value not in allowed[name]:
            values = ", ".join(sorted(allowed[name]))
            yield element, f'attribute "{name}" of <{element.tag}> is "{value}", not one of {values}'


def children(element, allowed, repeatable=()):
    """Only known children, each once unless repeatable, and no text between them."""
    text = "".join([element.text or "", *(child.tail or "" for child in element)]).strip()
    if text:
        yield element, f'<{element.tag}> contains unexpected text "{text}"'
    seen = set()
    for child in element:
        if child.tag not in allowed:
            yield child, f"<{child.tag}> is not allowed in <{element.tag}>"
        elif child.tag in seen and child.tag not in repeatable:
            yield child, f"<{child.tag}> appears twice in <{element.tag}>"
        seen.add(child.tag)
        if child.tag not in KINDS and child.tag not in ("parameters", "constraints"):
            if len(child):
                yield child, f"<{child.tag}> contains elements where only text is allowed"
            if child.tag != "reference":
                yield from attributes(child, {})  # shapeton::CommandLine reads no alias of a flag


def texts(element, *required):
    """The required children contain text, and the description is a sentence."""
    for child in (*required, "description"):
        if not text_of(element, child):
            yield element, f"{label(element)} lacks <{child}>"
    if text_of(element, "description")[-1:] not in ("", "."):
        yield element, f"the <description> of {label(element)} must end with a period"


def position(parameter):
    value = number(text_of(parameter, "index"), "integer")
    return -1 if value is None else value


def basics(parameter):
    """Names, flags, channel and position."""
    kind = parameter.tag
    name, flag, longflag, channel = (text_of(parameter, child) for child in ("name", "flag", "longflag", "channel"))
    is_option, is_positional = has(parameter, "flag", "longflag"), has(parameter, "index")
    is_return = channel == "output" and (is_numeric(kind) or kind == "boolean" or kind.startswith("string"))
    return [message for is_violated, message in (
        (not re.fullmatch("[a-z][A-Za-z0-9]*", name),
         "<name> must be camelCase: letters and digits, a small letter first"),
        (has(parameter, "longflag") and longflag != name, f'<longflag> "{longflag}" differs from <name>'),
        (name in RESERVED, "the name is reserved"),
        (has(parameter, "flag") and not re.fullmatch("[A-Za-gi-z]", flag),
         f'<flag> "{flag}" must be one letter other than h'),
        (has(parameter, "flag") and not has(parameter, "longflag"), "a <flag> needs a <longflag>"),
        (has(parameter, "channel") and channel not in ("input", "output"),
         f'<channel> is "{channel}", not one of input, output'),
        (kind in NODES | {"file", "directory"} and not has(parameter, "channel"), "lacks <channel>"),
        (not (is_option or is_positional or is_return),
         "needs a <longflag> or an <index>; only a return value, a simple type with the channel output, has neither"),
        (is_positional and is_option, "<index> excludes <flag> and <longflag>"),
        (is_positional and kind in ("point", "region", "boolean"), "cannot be positional"),
        (kind == "directory" and (channel == "output" or not is_positional),
         "must be a <file>, which may stay empty in Slicer's panel; its field for a <directory> never is"),
        (is_positional and position(parameter) < 0, "<index> must be a non-negative integer"),
    ) if is_violated]


def constraints(parameter):
    for place in parameter.findall("constraints"):
        if not is_numeric(parameter.tag) or is_enumeration(parameter.tag):
            yield "cannot have <constraints>"
            return
        for child in place:
            if number((child.text or "").strip(), parameter.tag) is None:
                yield f'<{child.tag}> "{(child.text or "").strip()}" is not a number of the type'
        minimum, maximum, step = (limit(parameter, name) for name in ("minimum", "maximum", "step"))
        if minimum is not None and maximum is not None and minimum > maximum:
            yield "<minimum> is greater than <maximum>"
        if step is not None and step <= 0:
            yield "<step> must be greater than 0"


def elements(parameter):
    values = [(child.text or "").strip() for child in parameter.findall("element")]
    for place, value in enumerate(values):
        if value in values[:place]:
            yield f'<element> "{value}" appears twice'
        if is_numeric(parameter.tag) and number(value, parameter.tag) is None:
            yield f'<element> "{value}" is not a number of the type'
    if is_enumeration(parameter.tag) != bool(values):
        yield "is not an enumeration but has <element>" if values else "lacks <element>"
    if values and has(parameter, "default") and text_of(parameter, "default") not in values:
        yield f'<default> "{text_of(parameter, "default")}" is not one of its elements'


def default(parameter):
    kind, value = parameter.tag, text_of(parameter, "default")
    is_vector = kind.endswith("-vector")
    if not value:
        # Slicer always passes a scalar option, with an empty value if it has no default.
        if (is_numeric(kind) and not is_vector or is_enumeration(kind)) and has(parameter, "longflag"):
            yield "lacks <default>"
        return
    if kind == "boolean" and value != "false":
        yield "the <default> of a boolean must be false"
    if kind in NODES:
        yield "cannot have a <default>: Slicer would use it as the name of a node"
    if has(parameter, "index"):
        yield "a positional argument is required and cannot have a <default>"
    if is_numeric(kind) and not is_enumeration(kind):
        minimum, maximum = limit(parameter, "minimum"), limit(parameter, "maximum")
        for part in value.split(",") if is_vector else [value]:
            single = number(part, kind)
            if single is None:
                yield f'<default> "{part}" is not a number of the type'
            elif minimum is not None and single < minimum or maximum is not None and single > maximum:
                yield f"<default> {part} is outside its constraints"


def extensions(parameter):
    value = parameter.get("fileExtensions")
    for part in value.split(",") if value else ():
        if not re.fullmatch(r"\..+", part):
            yield f'file extension "{part}" must begin with a period'


def single(parameter):
    """One parameter."""
    yield from attributes(parameter, KINDS[parameter.tag])
    yield from children(parameter, PARAMETER, {"element", "reference"})
    yield from texts(parameter, "label")
    for place in parameter.findall("constraints"):
        yield from attributes(place, {})
        yield from children(place, {"minimum", "maximum", "step"})
    for check in (basics, constraints, elements, default, extensions):
        for message in check(parameter):
            colon = "" if message.startswith(("cannot", "is not", "lacks", "needs")) else ":"
            yield parameter, f"{label(parameter)}{colon} {message}"


def unique(parameters):
    for child, message in (("name", "the name"), ("flag", "<flag> {}"), ("index", "<index> {}")):
        seen = set()
        for parameter in parameters:
            value = text_of(parameter, child)
            if has(parameter, child) and value in seen:
                yield parameter, f"{label(parameter)}: {message.format(value)} is taken"
            seen.add(value)


def positions(parameters):
    """Indices are consecutive and start at 0; only the last positional argument may take several values."""
    order = sorted((p for p in parameters if has(p, "index")), key=position)
    for expected, parameter in enumerate(order):
        if position(parameter) != expected:
            yield parameter, f"{label(parameter)}: the indices must be consecutive and start at 0"
            return
        if parameter.get("multiple") == "true" and parameter is not order[-1]:
            yield parameter, f"{label(parameter)}: only the last positional argument may be multiple"


def references(parameters):
    known = {text_of(parameter, "name") for parameter in parameters}
    for parameter in parameters:
        for child in parameter.findall("reference"):
            yield from attributes(child, {"role": ANY, "parameter": ANY})
        targets = [(parameter, parameter.get("reference"))]
        targets += [(child, child.get("parameter")) for child in parameter.findall("reference")]
        for place, name in targets:
            if name and name not in known:
                yield place, f'the reference to "{name}" does not match any parameter'


def shared(root, parameters):
    """Every tool has the option threads; tools that take a volume or a surface share options."""
    by_name = {text_of(parameter, "name"): parameter for parameter in reversed(parameters)}
    threads = by_name.get("threads")
    if threads is None:
        yield root, "the option threads is missing"
    elif not (threads.tag == "integer" and text_of(threads, "default") == "0" and has(threads, "longflag")
              and limit(threads, "minimum") == 0):
        yield threads, "threads must be an <integer> option with the default 0 and the minimum 0"
    for (kind, what), options in SHARED.items():
        takes_it = any(p.tag == kind and text_of(p, "channel") == "input" for p in parameters)
        if takes_it or by_name.keys() & options.keys() - APART:
            for name, option in options.items():
                if name not in by_name:
                    yield root, f"a tool that takes a {what} must have the option {name}"
                elif by_name[name].tag != option or not has(by_name[name], "longflag"):
                    yield by_name[name], f"{name} must be a <{option}> option"


def executable(root, version):
    """The whole description."""
    if root.tag != "executable":
        yield root, f"the root element must be <executable>, not <{root.tag}>"
        return
    yield from attributes(root, {})
    yield from children(root, HEAD, {"parameters"})
    yield from texts(root, *REQUIRED)
    for child, value in (("version", version), ("license", "Apache-2.0")):
        if text_of(root, child) not in ("", value):
            yield root.find(child), f'<{child}> is "{text_of(root, child)}", must be "{value}"'
    parameters = []
    for group in root.findall("parameters"):
        yield from attributes(group, {"advanced": BOOLEAN})
        yield from texts(group, "label")
        yield from children(group, {"label", "description", *KINDS}, KINDS)
        own = [child for child in group if child.tag in KINDS]
        for parameter in own:
            yield from single(parameter)
        if not own:
            yield group, "<parameters> does not contain any parameter"
        parameters += own
    yield from unique(parameters)
    yield from positions(parameters)
    yield from references(parameters)
    yield from shared(root, parameters)


def faults_of_xml(xml, file, version):
    """Returns the faults of a description; `version` is the required content of <version>."""
    if not xml.startswith("<?xml "):
        yield Fault(file, 1, 'must begin with <?xml version="1.0" encoding="utf-8"?>')
    try:
        root, lines = parse(xml)
    except expat.ExpatError as error:
        yield Fault(file, error.lineno, f"is not well-formed: {expat.ErrorString(error.code)}")
    else:
        for element, message in executable(root, version):
            yield Fault(file, lines[element], message)
