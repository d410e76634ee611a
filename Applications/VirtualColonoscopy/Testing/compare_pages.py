"""Checks that quantities agree wherever the pages and tables of a run state them: compare_pages.py RUN [LEAST]

Exits with 1 and names the quantity and its values if they differ, or if fewer than LEAST quantities were compared.
"""

import csv
import json
import math
import sys
from html.parser import HTMLParser
from pathlib import Path


class Tables(HTMLParser):
    """The tables of a page as lists of rows of cells, and the card that each belongs to, if any."""

    def __init__(self, path):
        super().__init__()
        self.tables, self.cards, self.card, self._cell = [], [], None, None
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        self.card = dict(attrs).get("id", self.card) if tag == "section" else self.card
        if tag == "table":
            self.tables.append([])
            self.cards.append(self.card)
        elif tag == "tr":
            self.tables[-1].append([])
        elif tag in ("td", "th"):
            self._cell = ""

    def handle_endtag(self, tag):
        self.card = None if tag == "section" else self.card
        if tag in ("td", "th"):
            self.tables[-1][-1].append(" ".join(self._cell.split()))
            self._cell = None

    def handle_data(self, data):
        if self._cell is not None:
            self._cell += data

    def with_column(self, *names):
        """The rows of the first table with these columns, as dictionaries by lower-case name without its unit."""
        for table in self.tables:
            head = [cell.lower().split(" (")[0].split(",")[0] for cell in table[0]] if table else []
            if all(name in head for name in names):
                return [dict(zip(head, row)) for row in table[1:]]
        return []


class Quantities:
    """Values by quantity, each with the pages that state them."""

    def __init__(self):
        self.values = {}

    def add(self, quantity, page, value):
        self.values.setdefault(quantity, {})[page] = value

    def differing(self):
        return {name: pages for name, pages in self.values.items() if len(set(pages.values())) > 1}

    def compared(self):
        return sum(len(pages) > 1 for pages in self.values.values())


def cm(millimeters):
    return f"{math.floor(float(millimeters) + 0.5) / 10:.1f}"  # halves are rounded up, as on the pages


def probability(value):
    value = float(value)
    return "< 0.01" if value < 0.01 else "> 0.99" if value > 0.99 else f"{value:.2f}"


def add_landmarks(found, page, tables):
    for row in tables.with_column("flexure", "confidence"):
        distance = row.get("distance from the anal verge", row.get("from the anal verge", ""))
        for name, value in (("distance", distance), ("confidence", row["confidence"])):
            found.add(f"{row['flexure']} flexure: {name}", page, value)
    for row in tables.with_column("taenia", "mean confidence"):
        found.add(f"taenia {row['taenia']}: length", page, row.get("length", row.get("length on the wall")))
        found.add(f"taenia {row['taenia']}: confidence", page, row["mean confidence"])


def add_candidates(found, page, tables):
    for row in tables.with_column("candidate", "score", "segment"):
        for name, value in row.items():
            if name != "candidate":
                found.add(f"candidate {row['candidate']}: {name}", page, value)


def add_cards(found, page, tables):
    for card, table in zip(tables.cards, tables.tables):
        for name, value in table if (card or "").startswith("candidate-") else []:
            found.add(f"card of {card}: {name}", page, value)


def add_documents(found, run):
    landmarks = json.loads((run / "landmarks/landmarks.json").read_text())
    for flexure in landmarks["flexures"]:
        if flexure["found"]:
            found.add(f"{flexure['name']} flexure: distance", "landmarks.json", cm(flexure["arcLength"]))
            found.add(f"{flexure['name']} flexure: confidence", "landmarks.json", probability(flexure["confidence"]))
    with open(run / "segments.csv", newline="") as file:
        for row in csv.DictReader(file):
            for name in ("begin", "end"):
                found.add(f"{row['segment']}: {name}", "segments.csv", cm(row[name]))
    for segment in landmarks["segments"]:
        for name in ("begin", "end"):
            if segment[name] is not None and segment["name"] != "unknown":
                found.add(f"{segment['name']}: {name}", "landmarks.json", cm(segment[name]))
    with open(run / "polyps/candidates.csv", newline="") as file:
        for row in csv.DictReader(file):
            key = f"candidate {row['candidate']}: "
            found.add(key + "score", "candidates.csv", probability(row["score"]))
            found.add(key + "segment", "candidates.csv", row["segment"])
            found.add(key + "at", "candidates.csv", cm(row["arcLength"]))


def main():
    run, least = Path(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 1
    found = Quantities()
    report = Tables(run / "report.html")
    for row in report.with_column("segment", "from", "to"):
        found.add(f"{row['segment']}: begin", "report", row["from"])
        found.add(f"{row['segment']}: end", "report", row["to"])
    add_landmarks(found, "report", report)
    add_candidates(found, "report", report)
    add_cards(found, "report", report)
    add_landmarks(found, "landmarks", Tables(run / "landmarks/report/index.html"))
    add_candidates(found, "polyps", Tables(run / "polyps/report/index.html"))
    add_cards(found, "polyps", Tables(run / "polyps/report/index.html"))
    add_documents(found, run)
    for name, pages in found.differing().items():
        print(f"{name}: {pages}")
    print(f"{found.compared()} quantities compared")
    return 1 if found.differing() or found.compared() < least else 0


if __name__ == "__main__":
    sys.exit(main())
