"""prepare.py DATA OUTPUT TOOLS --columns FILE [--polyps FILE]... [--noPolyps FILE]...: lists the series of a collection, selects
those of each examination, and writes to OUTPUT the table cohort.tsv for run-cohort, the reasons of the selection, selection.tsv,
and the polyps of each series below truth."""

import argparse
import csv
import io
import os
import sys

from collection.listing import patients_of, read_series
from collection.selection import select
from collection.sheets import SheetError, read_columns, read_patients, read_polyps
from cohort.files import write_whole

TRUTH_COLUMNS = ("id", "diameter", "x", "y", "z", "baseX", "baseY", "baseZ", "low", "high")


def main():
    parser = argparse.ArgumentParser()
    for name in ("data", "output", "tools"):
        parser.add_argument(name)
    parser.add_argument("--columns", required=True)
    parser.add_argument("--polyps", action="append", default=[])
    parser.add_argument("--noPolyps", action="append", default=[])
    given = parser.parse_args()
    if not os.path.isdir(given.data):
        sys.exit(f"{given.data} is not a folder; give the folder of the downloaded collection")
    patients = patients_of(given.data)
    if not patients:
        sys.exit(f"{given.data} contains no folder of a patient; give the folder of the downloaded collection")
    try:
        truth = Truth(given, {os.path.basename(folder): subject for subject, folder in patients.items()})
    except SheetError as error:
        sys.exit(str(error))
    os.makedirs(f"{given.output}/series", exist_ok=True)
    cohort, selection = [("subject", "position", "source", "series", "truth")], [SELECTION_COLUMNS]
    for number, (subject, folder) in enumerate(patients.items(), 1):
        print(f"{number} of {len(patients)}: {os.path.basename(folder)}", end="\r", file=sys.stderr)
        series, message = read_series(given.tools, folder, f"{given.output}/series/{subject}.json")
        chosen, reasons = select(series)
        for one in chosen:
            place = truth.write(given.output, subject, one)
            cohort.append((subject, one.position, one.folder, one.uid, place))
        selection += rows_of(subject, series, chosen, reasons, message)
    write_whole(f"{given.output}/cohort.tsv", tabs(cohort))
    write_whole(f"{given.output}/selection.tsv", tabs(selection))
    write_whole(f"{given.output}/faults.txt", "".join(f"{fault}\n" for fault in truth.faults))
    examinations = {row[0] for row in cohort[1:]}
    print(f"{len(patients)} patients: {len(examinations)} examinations, {len(cohort) - 1} series, {truth.placed} polyps with a slice")
    for fault in truth.faults:
        print(f"  {fault}")
    if not examinations:
        sys.exit(f"no patient has a suitable series; {given.output}/selection.tsv gives the reasons")


SELECTION_COLUMNS = ("subject", "series", "number", "description", "position", "slices", "spacing", "selected", "reason")


def rows_of(subject, series, chosen, reasons, message):
    """Rows of the selection: all series of a patient, or why there is none."""
    if not series:
        return [(subject, *[""] * (len(SELECTION_COLUMNS) - 3), "no", message or "no series")]
    return [
        (subject, one.uid, one.number, one.description, one.position, one.slices, f"{one.spacing:g}",
         "yes" if one in chosen else "no", reasons.get(one.uid, "") or one.doubt)
        for one in series
    ]


class Truth:
    """The polyps of the spreadsheets. A series gets a truth if each polyp of its patient has a slice in it, because other
    candidates then count as false; or if its patient is listed without polyps."""

    def __init__(self, given, subjects):
        self.faults, self.placed = [], 0
        self._polyps, self._healthy = {}, set()
        columns = read_columns(given.columns)
        for path in given.polyps:
            polyps, faults = read_polyps(path, columns, subjects)
            self.faults += faults
            for polyp in polyps:
                self._polyps.setdefault(polyp.subject, []).append(polyp)
        for path in given.noPolyps:
            found, faults = read_patients(path, columns, subjects)
            self.faults += faults
            self._healthy.update(found)
        for subject in sorted(self._healthy & self._polyps.keys()):
            self.faults.append(f"{subject}: listed with and without polyps; its polyps are used")

    def write(self, output, subject, series):
        """Returns the folder with the truth of a series, relative to the table; empty if its polyps are not known."""
        polyps = self._polyps.get(subject, [])
        if not polyps and subject not in self._healthy:
            return ""
        rows = [self._row(number, polyp, series) for number, polyp in enumerate(polyps, 1)]
        if not all(rows):
            return ""
        self.placed += len(rows)
        place = f"truth/{subject}/{series.position}"
        os.makedirs(f"{output}/{place}", exist_ok=True)
        text = io.StringIO()
        table = csv.DictWriter(text, TRUTH_COLUMNS, restval="", lineterminator="\n")
        table.writeheader()
        table.writerows(rows)
        write_whole(f"{output}/{place}/polyps.csv", text.getvalue())
        return place

    def _row(self, number, polyp, series):
        """The row of a polyp, whose place is known along the axis of the body only; None if it has no slice in the series."""
        instance = polyp.slices.get(series.position)
        point = series.point(instance) if instance is not None else None
        if point is None:
            reason = "no slice" if instance is None else f"slice {instance} is missing"
            self.faults.append(f"{polyp.source}: {reason} in the selected {series.position} series; it has no truth")
            return None
        ends = [series.point(end)[2] for end in series.places]
        places = {"z": point[2], "low": min(ends), "high": max(ends)}
        return {"id": number, "diameter": polyp.diameter, **{name: f"{place:.3f}" for name, place in places.items()}}


def tabs(rows):
    return "".join("\t".join(" ".join(str(cell).split()) for cell in row) + "\n" for row in rows)


if __name__ == "__main__":
    main()
