"""XML elements with their lines."""

from xml.etree.ElementTree import TreeBuilder
from xml.parsers import expat


def parse(document):
    """Returns the root element and the line of each element. Raises expat.ExpatError."""
    builder, parser, lines = TreeBuilder(), expat.ParserCreate(), {}

    def start(tag, attributes):
        lines[builder.start(tag, attributes)] = parser.CurrentLineNumber

    parser.StartElementHandler = start
    parser.EndElementHandler = builder.end
    parser.CharacterDataHandler = builder.data
    parser.Parse(document.encode("utf-8", "surrogateescape"), True)
    return builder.close(), lines


def text_of(element, child):
    """Returns the trimmed text of the first child of that name, or an empty string."""
    return element.findtext(child, "").strip()
