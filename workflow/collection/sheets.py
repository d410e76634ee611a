"""Spreadsheets of polyps (.xls, .xlsx, .csv, .tsv), read by a file that names their columns."""

import csv
import dataclasses
import os
import re

FIELDS = ("patient", "size", "supineSlice", "proneSlice", "segment")
REQUIRED = ("patient",)
CENTIMETER = 10.0  # mm


class SheetError(Exception):
    """A spreadsheet that cannot be read at all."""


@dataclasses.dataclass
class Polyp:
    subject: str
    diameter: float  # mm
    slices: dict  # position: instance number
    segment: str
    source: str  # file and line


def read_columns(path):
    """Reads lines "field = heading"; returns {field: headings in lower case}. A field may have several lines."""
    columns = {field: [] for field in FIELDS}
    with open(path, encoding="utf-8") as file:
        for number, line in enumerate(file, 1):
            text = line.split("#")[0].strip()
            if not text:
                continue
            field, _, heading = (part.strip() for part in text.partition("="))
            if field not in columns or not heading:
                raise SheetError(f'{path}, line {number}: "{text}" is not FIELD = HEADING with a field of {", ".join(FIELDS)}')
            columns[field].append(heading.lower())
    return columns


def read_polyps(path, columns, subjects):
    """Returns the polyps of a spreadsheet, and the faults of rows that cannot be read. `subjects`: {name of the patient's
    folder: subject}."""
    polyps, faults = [], []
    for line, row in _rows(path, columns):
        source = f"{path}, line {line}"
        try:
            polyps.append(_polyp(row, subjects, source))
        except ValueError as error:
            faults.append(f"{source}: {error}")
    return polyps, faults


def read_patients(path, columns, subjects):
    """Returns the subjects that a spreadsheet lists, and the faults of its rows."""
    found, faults = [], []
    for line, row in _rows(path, columns):
        try:
            found.append(_subject(row, subjects))
        except ValueError as error:
            faults.append(f"{path}, line {line}: {error}")
    return found, faults


def _polyp(row, subjects, source):
    slices = {}
    for position, field in (("supine", "supineSlice"), ("prone", "proneSlice")):
        number = _instance(row.get(field, ""))
        if number is not None:
            slices[position] = number
    return Polyp(_subject(row, subjects), _millimeters(row.get("size", "")), slices, row.get("segment", ""), source)


def _subject(row, subjects):
    """The patient of a row: a folder of this name, or whose name ends with it after a dot."""
    name = row["patient"]
    found = [subject for folder, subject in subjects.items() if folder == name or (name and folder.endswith("." + name))]
    if len(found) != 1:
        raise ValueError(f'the patient "{name}" has {len(found) or "no"} folder{"s" if len(found) > 1 else ""} in the data')
    return found[0]


def _millimeters(text):
    match = re.fullmatch(r"([0-9]+(?:\.[0-9]+)?) *(mm|cm)?", text.lower())
    if not match or float(match[1]) == 0.0:
        raise ValueError(f'the size "{text}" is not a number of mm')
    return float(match[1]) * (CENTIMETER if match[2] == "cm" else 1.0)


def _instance(text):
    """The number of a slice; the middle of a range such as 120-126; None for an empty cell or a word such as "not seen"."""
    numbers = [int(number) for number in re.findall(r"\b[0-9]+\b", re.sub(r"\.0$", "", text))]
    if not numbers:
        return None
    if len(numbers) > 2:
        raise ValueError(f'"{text}" is not the number of a slice, or a range')
    return sum(numbers) // len(numbers)


def _rows(path, columns):
    """Yields (line, {field: cell}) below the row of headings, the first one that names the patient."""
    places = None
    for line, cells in enumerate(_cells(path), 1):
        if not any(cells):
            continue
        if places is None:
            places = _places(cells, columns)
            continue
        yield line, {field: cells[place] for field, place in places.items() if place < len(cells)}
    if places is None:
        heads = ", ".join(f'"{heading}"' for heading in columns["patient"])
        raise SheetError(f"{path}: no row has the heading of the patient, {heads}; name the columns by --columns")


def _places(cells, columns):
    """The column of each field in a row of headings; None if it is another row."""
    heads = [cell.lower() for cell in cells]
    found = {field: heads.index(name) for field, names in columns.items() for name in names if name in heads}
    return found if all(field in found for field in REQUIRED) else None


def _cells(path):
    """The cells of each row as text."""
    kind = os.path.splitext(path)[1].lower()
    try:
        if kind == ".xls":
            import xlrd

            sheet = xlrd.open_workbook(path).sheet_by_index(0)
            return [[_text(value) for value in sheet.row_values(row)] for row in range(sheet.nrows)]
        if kind == ".xlsx":
            import openpyxl

            sheet = openpyxl.load_workbook(path, read_only=True, data_only=True).worksheets[0]
            return [[_text(value) for value in row] for row in sheet.iter_rows(values_only=True)]
        with open(path, newline="", encoding="utf-8-sig") as file:
            return [[cell.strip() for cell in row] for row in csv.reader(file, delimiter="\t" if kind == ".tsv" else ",")]
    except OSError as error:
        raise SheetError(f"{path}: {error.strerror or error}; check the path") from None
    except Exception as error:  # xlrd and openpyxl have many kinds
        raise SheetError(f"{path}: not a spreadsheet ({error}); save it as .xlsx or .csv") from None


def _text(value):
    if value is None:
        return ""
    return str(int(value)) if isinstance(value, float) and value.is_integer() else str(value).strip()
