"""Comments, messages and pages are in plain American English."""

import re

from .tree import Fault, find, is_source, line_at

PAGES = {".md", ".xml", ".py", ".mjs", ".js", ".cmake", ".sh", ".txt", ".json"}
METAPHOR = re.compile(r"\b(told|wanders?|hangs? on|belongs? beside)\b")
GENITIVE = re.compile(r"(/\*\*|//[/!]?<?|^ *\*) Of [a-z]", re.MULTILINE)
NEGATION = re.compile(r"\b(is|are) (no|none)\b")
EXISTENCE = re.compile(r"\bthere (is|are) no\b")
# In lower case, also inside of identifiers. codespell finds other words and typing errors.
BRITISH = re.compile(
    r"centre|colour|neighbour|behaviour|favour|caec|haemo|grey|[lm]etres?\b|(label|model)l(ed|ing)\b|cancell(ed|ing)|"
    r"calibre|licence|programmes?\b|analys(e|ed|ing)\b|(normal|factor|quant|equal|initial|optim|minim|maxim|vector|"
    r"raster|linear|recogn|general|parameter|visual|summar|character|symmetr)is(e|ed|es|ing|ation)\b")


def plain_english(tree):
    """No comment begins with a bare genitive ("Of the ..."), no message says that something "is no" or "is none",
    nothing is told, wanders, hangs on or belongs beside, and spelling is American, in identifiers, too."""
    for file in tree.files:
        if file.name == "wording.py" or not (is_source(file) or file.suffix in PAGES):
            continue
        yield from find(tree, file, METAPHOR, "is not plain English: ")
        for match in BRITISH.finditer(tree.text(file).lower()):
            yield Fault(str(file), line_at(tree.text(file), match.start()), f"is not American spelling: {match[0]}")
        if is_source(file):
            yield from find(tree, file, GENITIVE, "begins a comment with a bare genitive: ")
            for line, text in tree.strings(file):
                for match in NEGATION.finditer(EXISTENCE.sub("", text)):
                    yield Fault(str(file), line, f"says what is not by: {match[0]}")
