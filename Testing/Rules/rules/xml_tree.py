"""XML elements with their lines."""

import importlib.util
from pathlib import Path
from xml.etree.ElementTree import TreeBuilder
from xml.parsers import expat

_script = importlib.util.spec_from_file_location("options", Path(__file__).parents[3] / "CMake/options.py")
options = importlib.util.module_from_spec(_script)
_script.loader.exec_module(options)


def parse(document):
    """Returns the root element and the line of each element, after expansion of declared options. Raises
    expat.ExpatError."""
    builder, parser, lines = TreeBuilder(), expat.ParserCreate(), {}

    def start(tag, attributes):
        lines[builder.start(tag, attributes)] = parser.CurrentLineNumber

    parser.StartElementHandler = start
    parser.EndElementHandler = builder.end
    parser.CharacterDataHandler = builder.data
    parser.Parse(options.expand_xml(document).encode("utf-8", "surrogateescape"), True)
    return builder.close(), lines


def text_of(element, child):
    """Returns the trimmed text of the first child of that name, or an empty string."""
    return element.findtext(child, "").strip()
