"""page.py OUTPUT: writes OUTPUT/benchmark.html: overlaps with published masks, and the worst cases with their pictures."""

import os
import statistics
import sys
from html import escape

from cohort.files import write_whole
from cohort.page import Page
from cohort.report import OUTCOMES
from cohort.results import read_examination
from cohort.table import read_table
from cohort.truth import read_series
from collection.overlap import read_overlaps, series_of

WORST = 20  # cases with pictures
PICTURES = ("segmentation/report/slices-coronal.png", "segmentation/report/projection-coronal.png")
MEASURES = (("dice", "Dice"), ("assd", "mean distance of the surfaces, mm"), ("hd95", "95 % of the distances, mm"))


def main():
    output = sys.argv[1]
    subjects = read_table(f"{output}/cohort.tsv")
    overlaps = {row["series"]: row for row in read_overlaps(f"{output}/overlaps.tsv")}
    examinations = {subject: read_examination(f"{output}/examinations", subject, rows) for subject, rows in subjects.items()}
    cases = [case_of(*one, examinations[one[0]], subjects, overlaps) for one in series_of(output)]
    write_whole(f"{output}/benchmark.html", page_of(cases, overlaps, output))
    print(f"the worst of {len(cases)} series: {os.path.abspath(output)}/benchmark.html")


def case_of(subject, position, series, exam, examination, subjects, overlaps):
    """What counts for the order of a series, the worst first, and for its caption."""
    row = next(one for one in subjects[subject] if one.series == series)
    truth = read_series(subject, exam, row.truth) if row.truth and examination.outcome == "done" else None
    missed = sum(score == 0.0 for score in truth.polyps) if truth else 0
    dice = overlaps.get(series, {}).get("dice", "")
    gaps = examination.series[subjects[subject].index(row)]["gaps"] or 0
    words = [examination.message] if examination.outcome != "done" else []
    words += [f"{missed} of {len(truth.polyps)} polyps missed, {len(truth.false_scores)} other candidates"] if truth else []
    words += [f"Dice {dice}"] if dice else []
    words += [f"bridged gaps: {gaps}"] if gaps else []
    return {
        "key": (OUTCOMES.index(examination.outcome), -missed, float(dice or 1.0), -gaps, subject, position),
        "title": f"{subject}, {position}: {'; '.join(words) or 'nothing to remark'}",
        "pictures": [f"{exam}/{name}" for name in PICTURES if os.path.exists(f"{exam}/{name}")],
    }


def page_of(cases, overlaps, output):
    page = Page(f"Benchmark of {len(cases)} series")
    page.paragraph("For research use. This is not a diagnosis and not a medical device.")
    page.paragraph("FROC, sensitivities, failures and times are in examinations/report.html; the selected series in selection.tsv.")
    compared = [row for row in overlaps.values() if row["dice"]]
    if overlaps:
        page.heading("Lumen beside published masks")
        page.table(
            ["Measure", "Series", "Median", "Worst"],
            [[title, len(compared), *spread(name, [float(row[name]) for row in compared])] for name, title in MEASURES],
            "Gas and fluid of the lumen. Published masks have faults of their own: look at the worst cases.",
        )
        faults = [[row["subject"], row["position"], row["fault"]] for row in overlaps.values() if row["fault"]]
        if faults:
            page.table(["Subject", "Position", "Why"], faults, "Masks that cannot be compared.")
    page.heading("Worst cases")
    for case in sorted(cases, key=lambda one: one["key"])[:WORST]:
        places = [escape(os.path.relpath(path, output)) for path in case["pictures"]]
        page.figure("".join(f'<img src="{place}" width="480" alt=""/>' for place in places), case["title"])
    return page.text()


def spread(name, values):
    if not values:
        return None, None
    return statistics.median(values), min(values) if name == "dice" else max(values)


if __name__ == "__main__":
    main()
