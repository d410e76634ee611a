"""The table of a cohort: one row per series, tab-separated; the rows of a subject form one examination."""

import csv
import dataclasses
import os
import re

SUBJECT = "[A-Za-z0-9][A-Za-z0-9_-]*"
REQUIRED = ("subject", "position", "source", "series")
OPTIONAL = ("truth",)
POSITIONS = ("auto", "supine", "prone", "leftDecubitus", "rightDecubitus")
QUERY = re.compile(r"pacs:(StudyInstanceUID|AccessionNumber|PatientID)=(\S+)")
UID = re.compile(r"[0-9]+(\.[0-9]+)+")


class TableError(Exception):
    """All errors in a table, one per line."""


@dataclasses.dataclass
class Series:
    """A row. The source is a folder, or a query "pacs:KEY=VALUE"."""

    line: int
    subject: str
    position: str
    source: str
    series: str
    truth: str = ""

    @property
    def query(self):
        """Returns KEY=VALUE of a query, otherwise None."""
        match = QUERY.fullmatch(self.source)
        return f"{match[1]}={match[2]}" if match else None


def read_table(path, is_done=lambda subject: True):
    """Returns subjects with one or two series, in table order. TableError lists all errors, and the missing source folders
    of subjects that are not done."""
    faults = []
    rows = _rows(path, faults)
    for row in rows:
        _check_row(row, faults)
    subjects = {}
    for row in rows:
        subjects.setdefault(row.subject, []).append(row)
    for series in subjects.values():
        _check_subject(series, faults)
    if not rows and not faults:
        faults.append((1, "no rows found below the header; add one per series"))
    for row in rows:
        if not is_done(row.subject):
            _check_source(row, faults)
    if faults:
        raise TableError("\n".join(f"{path}, line {line}: {fault}" for line, fault in sorted(faults)))
    return subjects


def _rows(path, faults):
    try:
        with open(path, newline="", encoding="utf-8-sig") as file:
            lines = list(csv.reader(file, delimiter="\t", quoting=csv.QUOTE_NONE))
    except OSError as error:
        raise TableError(f"{path}: {error.strerror}; check the path of the table") from None
    except UnicodeDecodeError:
        raise TableError(f"{path}: not UTF-8 text; export the table as tab-separated text") from None
    heads = lines[0] if lines else []
    for name in [name for name in REQUIRED if name not in heads]:
        faults.append((1, f'the column "{name}" is missing; the required columns are {", ".join(REQUIRED)}, separated by tabs'))
    for name in [name for name in heads if name not in REQUIRED + OPTIONAL]:
        faults.append((1, f'the column "{name}" is unknown; columns are {", ".join(REQUIRED + OPTIONAL)}'))
    if faults:
        return []
    base = os.path.dirname(os.path.abspath(path))
    rows = [_row(heads, number, cells, base, faults) for number, cells in enumerate(lines[1:], 2) if any(cells)]
    return [row for row in rows if row]


def _row(heads, line, cells, base, faults):
    if len(cells) != len(heads):
        faults.append((line, f"found {len(cells)} cells for {len(heads)} columns; separate cells by one tab"))
        return None
    row = Series(line, **{name: cell.strip() for name, cell in zip(heads, cells)})
    if row.source and not row.source.startswith("pacs:"):
        row.source = os.path.normpath(os.path.join(base, row.source))
    if row.truth:
        row.truth = os.path.normpath(os.path.join(base, row.truth))
    return row


def _check_row(row, faults):
    def require(condition, column, fault):
        if not condition:
            faults.append((row.line, f"column {column}: {fault}"))

    require(re.fullmatch(SUBJECT, row.subject), "subject", f'"{row.subject}" is not a valid name; use letters, digits, _ and -')
    require(row.position in POSITIONS, "position", f'"{row.position}" is not one of {", ".join(POSITIONS)}')
    require(row.source, "source", "empty; use a folder with a DICOM series, or pacs:KEY=VALUE")
    if row.source.startswith("pacs:"):
        keys = "StudyInstanceUID, AccessionNumber or PatientID"
        require(row.query, "source", f'"{row.source}" is not a query; write pacs:KEY=VALUE, where KEY is {keys}')
        require(row.series, "series", "a query requires the Series Instance UID; workflow/pacs/find lists the series of a study")
    require(not row.series or UID.fullmatch(row.series), "series", f'"{row.series}" is not a Series Instance UID')
    require(not row.truth or os.path.isdir(row.truth), "truth", f"{row.truth} is not a folder; correct the path")


def _check_source(row, faults):
    if row.source and not row.source.startswith("pacs:") and not os.path.isdir(row.source):
        faults.append((row.line, f"column source: {row.source} is not a folder; mount it, or correct the path"))


def _check_subject(series, faults):
    for row in series[2:]:
        faults.append((row.line, f'column subject: "{row.subject}" already has two series, the maximum of an examination'))
    if len(series) < 2:
        return
    first, second = series[:2]
    if (first.source, first.series) == (second.source, second.series):
        faults.append((second.line, f"column source: same series as in line {first.line}; use another folder or series"))
    if first.position == second.position != "auto":
        faults.append((second.line, f"column position: line {first.line} is also {first.position}; correct one, or use auto"))
