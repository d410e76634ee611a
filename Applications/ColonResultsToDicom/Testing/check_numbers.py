#!/usr/bin/env python3
"""check_numbers.py TOOL_FOLDER SERIES EXAM WORK_FOLDER

Checks that the size, score and place of each candidate are the same numbers in all results: candidates.csv, table and card of
the report, viewer, report of the reader as page and table, DICOM reports (program, CAD, reader) and FHIR. A reader accepts all
candidates. Numbers are compared as printed: sizes in 0.1 mm, scores in 0.01, distances in 0.1 cm."""

import csv
import html
import json
import pathlib
import re
import shutil
import subprocess
import sys
from decimal import ROUND_HALF_UP, Decimal

import check_objects
import pydicom
from check_objects import check, contents

LARGEST = "Polyp size, largest dimension"


def printed(value, step):
    return str(Decimal(str(value)).quantize(Decimal(step), ROUND_HALF_UP))


def numbers(size, score=None, millimeters=None):
    """Size, score and distance as printed; what a result does not state is None."""
    distance = None if millimeters is None else printed(Decimal(str(millimeters)) / 10, "0.1")
    return printed(size, "0.1"), None if score is None else printed(score, "0.01"), distance


def rows_of(path):
    with open(path, encoding="utf-8") as table:
        return list(csv.DictReader(table))


def score_in_report(score):
    return "< 0.01" if score < 0.01 else "> 0.99" if score > 0.99 else printed(score, "0.01")


def tables(page):
    """The tables of a page as lists of rows of texts; the first row is the header."""
    for table in re.findall(r"<table>(.*?)</table>", page, re.S):
        rows = re.findall(r"<tr>(.*?)</tr>", table, re.S)
        yield [[html.unescape(cell) for cell in re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", row, re.S)] for row in rows]


def in_table(page, number, size, score=None, place=None):
    """Numbers by candidate from the tables with these columns."""
    found = {}
    for header, *rows in tables(page):
        if number in header and size in header:
            for row in (dict(zip(header, row)) for row in rows):
                where = row.get(place)
                found[row[number]] = (row[size], row.get(score), where)
    return found


def in_cards(page):
    found = {}
    for number, card in re.findall(r'<section class="card" id="candidate-(\d+)">(.*?)</section>', page, re.S):
        facts = dict(re.findall(r"<tr><th>([^<]*)</th>\s*<td>([^<]*)</td>", card))
        place = re.search(r"([\d.]+) cm from the anal verge", card)
        size, score = facts["Largest diameter"].split(" mm")[0], html.unescape(facts["Score"]).split(",")[0]
        found[number] = (size, score, place.group(1) if place else None)
    return found


def in_viewer(folder):
    text = (folder / "data" / "info.js").read_text(encoding="utf-8")
    info = json.loads(text[len('block("info",null,') : text.rindex(")")])
    return info, {c["candidate"]: numbers(c["diameter"], c["score"], c["arcLength"]) for c in info["positions"][0]["candidates"]}


def in_dicom(path, group, size):
    """Numbers of the groups with this meaning that name a candidate."""
    found = {}
    value = lambda one, name: next((c.MeasuredValueSequence[0].NumericValue for c in contents(one, name)), None)
    for one in contents(pydicom.dcmread(path), group):
        name = next((c.TextValue for c in contents(one, "Tracking Identifier")), "")
        if name.startswith("candidate "):
            certainty = value(one, "Certainty of Finding")
            found[name.split()[-1]] = numbers(value(one, size), certainty and certainty / 100, value(one, "Distance from anus"))
    return found


def in_fhir(path, size):
    found = {}
    for resource in (entry["resource"] for entry in json.loads(path.read_text(encoding="utf-8"))["entry"]):
        values = {c["code"]["text"]: c["valueQuantity"]["value"] for c in resource.get("component", []) if "valueQuantity" in c}
        if resource["resourceType"] == "Observation" and size in values:
            score = values.get("Certainty of Finding")
            number = resource["code"]["text"].split()[-1]
            found[number] = numbers(values[size], score and Decimal(str(score)) / 100, values.get("Distance from anus"))
    return found


def accept_all(info, rows, path):
    """Writes the verdicts of a reader who accepts all candidates and enters no size."""
    candidates = [{"id": row["candidate"], "verdict": "polyp", "note": ""} for row in rows]
    verdicts = {"version": 2, "exam": info["exam"], "candidates": candidates, "findings": [], "bookmarks": []}
    path.write_text(json.dumps({**verdicts, "assessment": {"colonic": "C3", "extracolonic": "", "note": ""}}), encoding="utf-8")


def same(where, found, expected):
    """Each result states all candidates, and what it states is equal."""
    check(sorted(found) == sorted(expected), f"{where}: candidates {sorted(found)}, expected {sorted(expected)}")
    for number in found.keys() & expected.keys():
        for name, here, there in zip(("size", "score", "distance"), found[number], expected[number]):
            check(here is None or here == there, f"{where}, candidate {number}: {name} {here}, expected {there}")
    check(all(one[0] for one in found.values()), f"{where}: every size is stated")


def main(tools, series, exam, work):
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    run = lambda name, *arguments: subprocess.run([tools / name, *arguments, "--quiet"], check=True)
    run("ColonViewer", exam, work / "viewer")
    rows = rows_of(exam / "polyps" / "candidates.csv")
    info, viewer = in_viewer(work / "viewer")
    accept_all(info, rows, work / "verdicts.json")
    run("ColonViewer", exam, work / "read", "--verdicts", work / "verdicts.json")
    run("ColonResultsToDicom", exam, work / "dicom", "--source", series, "--verdicts", work / "verdicts.json", "--fhir")

    expected = {row["candidate"]: numbers(row["diameter"], row["score"], row["arcLength"]) for row in rows}
    in_words = {row["candidate"]: score_in_report(float(row["score"])) for row in rows}
    report = {number: (size, in_words[number], place) for number, (size, _, place) in expected.items()}
    page = (exam / "report.html").read_text(encoding="utf-8")
    listed = in_table(page, "Candidate", "Size (mm)", "Score", "At (cm)")
    check(len(listed) > 1, "the report lists candidates")
    same("report.html", listed, {number: report[number] for number in report if number in listed})
    same("cards", in_cards((exam / "polyps/report/index.html").read_text(encoding="utf-8")), report)
    same("viewer", viewer, expected)
    accepted = [row for row in rows_of(work / "read" / "reader-report.csv") if row["verdict"] == "polyp"]
    read = {row["id"]: numbers(row["size"], row["score"], row["arcLength"]) for row in accepted}
    same("reader-report.csv", read, expected)
    page = (work / "read" / "reader-report.html").read_text(encoding="utf-8")
    same("reader-report.html", in_table(page, "Number", "Size (mm)", None, "From anal verge (cm)"), expected)
    for name, group, size in (
        ("sr", "Measurement Group", "Diameter"),
        ("sr-reader", "Measurement Group", LARGEST),
        ("cad", "Single Image Finding", LARGEST),
    ):
        same(name + ".dcm", in_dicom(work / "dicom" / (name + ".dcm"), group, size), expected)
    same("fhir.json", in_fhir(work / "dicom" / "fhir.json", "Diameter, Maximum"), expected)
    same("fhir.json, reader", in_fhir(work / "dicom" / "fhir.json", LARGEST), expected)
    return 1 if check_objects.failures else 0


if __name__ == "__main__":
    if len(sys.argv) != 5 or "--help" in sys.argv:
        print(__doc__)
        sys.exit(0 if "--help" in sys.argv else 2)
    sys.exit(main(*(pathlib.Path(argument) for argument in sys.argv[1:])))
