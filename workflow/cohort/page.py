"""A page in the look of Shapeton's reports (Modules/Core/Report), which a test compares with its own."""

from html import escape

STYLE = """
:root { color-scheme: light; }
body { font: 16px/1.5 system-ui, sans-serif; color: #1a1a1a; background: #fff; max-width: 72rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.7rem; margin-bottom: .3rem; }
h2 { font-size: 1.25rem; margin-top: 2.2rem; border-bottom: 1px solid #ddd; padding-bottom: .2rem; }
figure { margin: 1rem 0; }
img { max-width: 100%; height: auto; border: 1px solid #ddd; }
figcaption { color: #555; font-size: .92rem; }
.table { overflow-x: auto; margin: .5rem 0 1.2rem; }
table { border-collapse: collapse; font-size: .92rem; }
caption { text-align: left; color: #555; padding-bottom: .3rem; }
th, td { text-align: left; padding: .25rem 1rem .25rem 0; border-bottom: 1px solid #eee; vertical-align: top; }
th { font-weight: 600; vertical-align: bottom; }
.facts th { vertical-align: top; }
.number { text-align: right; }
td.number { white-space: nowrap; font-variant-numeric: tabular-nums; }
.swatch { display: inline-block; width: 2em; height: 1em; border: 1px solid #999; vertical-align: -.1em; }
@media print { .table { overflow: visible; } }
.note { background: #fff6df; border-left: 4px solid #e0a100; padding: .5rem .8rem; margin: .6rem 0; }
summary { cursor: pointer; }
"""
CELLS = """
td.far { background: #fff6df; font-weight: 600; }
td:first-child { white-space: nowrap; }
"""


def text_of(value):
    """A value for people; nothing where it is not known."""
    return "" if value is None else f"{value:g}" if isinstance(value, float) else str(value)


class Page:
    """Collects the body; write out with text()."""

    def __init__(self, title):
        self._title = title
        self._body = []

    def heading(self, text):
        self._body.append(f"<h2>{escape(text)}</h2>")

    def paragraph(self, text):
        self._body.append(f"<p>{escape(text)}</p>")

    def note(self, text):
        self._body.append(f'<p class="note">{escape(text)}</p>')

    def facts(self, facts):
        rows = "\n".join(f"<tr><th>{escape(name)}</th><td>{escape(text_of(value))}</td></tr>" for name, value in facts)
        self._body.append(f'<div class="table"><table class="facts">\n{rows}\n</table></div>')

    def figure(self, drawing, caption):
        self._body.append(f"<figure>{drawing}<figcaption>{escape(caption)}</figcaption></figure>")

    def table(self, heads, rows, caption, links=(), far=frozenset()):
        """Links: addresses for the first cells of the rows. Far: places (row, column) that stand out."""
        numbers = [all(isinstance(row[column], (int, float, type(None))) for row in rows) for column in range(len(heads))]
        lines = ["".join(f"<th{_class(is_number, False)}>{escape(name)}</th>" for name, is_number in zip(heads, numbers))]
        for index, row in enumerate(rows):
            cells = [_cell(value, links[index] if links and column == 0 else "") for column, value in enumerate(row)]
            classes = [_class(numbers[column], (index, column) in far) for column in range(len(row))]
            lines.append("".join(f"<td{name}>{cell}</td>" for name, cell in zip(classes, cells)))
        body = "\n".join(f"<tr>{line}</tr>" for line in lines)
        self._body.append(f'<div class="table"><table><caption>{escape(caption)}</caption>\n{body}\n</table></div>')

    def text(self):
        title, body = escape(self._title), "\n".join(self._body)
        return (
            f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8"/>\n<title>{title}</title>\n'
            f"<style>{STYLE}{CELLS}</style>\n</head>\n<body>\n<h1>{title}</h1>\n{body}\n</body>\n</html>\n"
        )


def _class(is_number, is_far):
    names = " ".join(name for name, wanted in (("number", is_number), ("far", is_far)) if wanted)
    return f' class="{names}"' if names else ""


def _cell(value, link):
    text = escape(text_of(value))
    return f'<a href="{escape(link)}">{text}</a>' if link else text
