"""A page with the style sheet of Shapeton's reports."""

from html import escape
from pathlib import Path

STYLE = (Path(__file__).parents[2] / "Modules/Core/Pages/styles/page.css").read_text(encoding="utf-8")
CELLS = """
td.far { background: #fff6df; font-weight: 600; }
td:first-child { white-space: nowrap; }
"""


def text_of(value):
    """Returns a value as text; empty if unknown."""
    return "" if value is None else f"{value:g}" if isinstance(value, float) else str(value)


class Page:
    """Collects the body; text() returns the page."""

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
        """`links`: addresses for the first cells of the rows. `far`: highlighted cells (row, column)."""
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
