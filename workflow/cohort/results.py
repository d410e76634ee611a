"""Results of each examination of a cohort, from the files of its run: values for the tables, and doubts."""

import csv
import dataclasses
import os

from cohort.files import file_of, read_json

# Measures of a series: name in the tables, unit, heading of the page.
SERIES_MEASURES = {
    "length": ("mm", "Length of the centerline"),
    "distended": ("%", "Distended: caliber of at least 10 mm"),
    "assessable": ("%", "Evaluable wall"),
    "caliber": ("mm", "Mean caliber"),
    "gaps": ("", "Bridged gaps"),
    "flexures": ("", "Flexures found"),
    "flexureConfidence": ("", "Minimum confidence of a flexure"),
    "candidates": ("", "Polyp candidates"),
}
PAIR_MEASURES = {
    "pairConfidence": ("", "Confidence of the registration"),
    "matchedShare": ("%", "Matched folds"),
}
RUN_MEASURES = {"seconds": ("s", "Time of the run"), "memoryMB": ("MB", "Memory of the run")}


@dataclasses.dataclass
class Examination:
    subject: str
    outcome: str  # done, unsuitable, failed, not run
    message: str
    series: list  # measures of each series in the table
    pair: dict
    run: dict
    report: str  # path of its page below the folder of the cohort, or empty
    unsent: str = ""  # reason why its results did not reach the PACS
    doubts: list = dataclasses.field(default_factory=list)

    def measures(self):
        """Returns all measures by column name, with the number of the series."""
        values = {f"{name}{number}": value for number, one in enumerate(self.series, 1) for name, value in one.items()}
        return {**values, **self.pair, **{name: self.run.get(name) for name in RUN_MEASURES}}


def read_examination(output, subject, rows):
    folder = os.path.join(output, subject)
    outcome, message = _end_of(folder)
    exam = os.path.join(folder, "exam")
    examination = Examination(
        subject=subject,
        outcome=outcome,
        message=message,
        series=[_series(place) for place in (exam, os.path.join(exam, "second"))[: len(rows)]],
        pair=_pair(exam) if len(rows) == 2 else {},
        run=read_json(f"{folder}/attempt.json"),
        report=f"{subject}/exam/report.html" if os.path.exists(f"{exam}/report.html") else "",
        unsent=_send_fault(folder),
    )
    examination.doubts = _doubts(examination, rows)
    return examination


def _end_of(folder):
    """Returns outcome and message; an attempt killed with its job only has a start."""
    status, attempt = read_json(f"{folder}/status.json"), read_json(f"{folder}/attempt.json")
    if status:
        return status["outcome"], status["message"]
    if not attempt:
        return "not run", _fetch_fault(folder) or "not started; see the log of Snakemake"
    message = attempt.get("message") or f"its job was killed, with {attempt['askedMB']} MB requested"
    return "failed", f"{message} (attempt {attempt['attempt']})"


def _fetch_fault(folder):
    """Returns the reason why a series did not arrive."""
    for number in (1, 2):
        if not os.path.isdir(f"{folder}/source/{number}") and os.path.exists(f"{folder}/fetch-{number}.txt"):
            return _last_line(f"{folder}/fetch-{number}.txt")
    return ""


def _send_fault(folder):
    """Returns the reason why the results did not reach the PACS."""
    is_unsent = os.path.exists(f"{folder}/send.txt") and not os.path.exists(f"{folder}/sent.json")
    return _last_line(f"{folder}/send.txt") if is_unsent else ""


def _last_line(path):
    with open(path, encoding="utf-8", errors="replace") as file:
        return ([line.strip() for line in file if line.strip()] or [""])[-1]


def _series(place):
    quality = read_json(file_of(place, "quality"))
    landmarks = read_json(file_of(place, "landmarks"))
    centerline, whole = quality.get("centerline", {}), quality.get("distension", {}).get("whole", {})
    assessable = quality.get("assessability", {}).get("whole", {})
    found = [flexure["confidence"] for flexure in landmarks.get("flexures", []) if flexure["found"]]
    return {
        "length": _rounded(centerline.get("length"), 0),
        "distended": _percent(whole.get("share")),
        "assessable": _percent(assessable.get("assessableShare")),
        "caliber": _rounded(whole.get("meanCaliber"), 1),
        "gaps": len(centerline["gaps"]) if "gaps" in centerline else None,
        "flexures": len(found) if landmarks else None,
        "flexureConfidence": _rounded(min(found), 2) if found else None,
        "candidates": _count_of_rows(file_of(place, "candidates")),
    }


def _pair(exam):
    confidence = read_json(file_of(exam, "registration")).get("confidence", {})
    return {
        "pairConfidence": _rounded(confidence.get("whole"), 2),
        "matchedShare": _percent(confidence.get("matchedShare")),
        "flagged": int(confidence["flagged"]) if confidence else None,
    }


def _doubts(examination, rows):
    doubts = []
    for row, series in zip(rows, examination.series):
        name = row.position if row.position != "auto" else f"series {rows.index(row) + 1}"
        if series["gaps"]:
            doubts.append(f"{name}: gaps are bridged")
        if series["flexures"] is not None and series["flexures"] < 4:
            doubts.append(f"{name}: {4 - series['flexures']} of 4 flexures not found")
    if examination.pair.get("flagged"):
        doubts.append("the registration is flagged")
    return doubts


def _rounded(value, digits):
    return None if value is None else round(value, digits) if digits else round(value)


def _percent(share):
    return None if share is None else round(100.0 * share, 1)


def _count_of_rows(path):
    if not os.path.exists(path):
        return None
    with open(path, newline="", encoding="utf-8") as file:
        return sum(1 for _ in csv.DictReader(file))
