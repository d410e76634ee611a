"""report.py OUTPUT: writes report.html, cohort.tsv and runs.tsv from the results of a cohort. Status 1 if a run failed.

cohort.tsv contains only results, so it is byte-identical on every machine; times and memory are in runs.tsv."""

import os
import sys

from cohort.drawings import curve, strips
from cohort.files import read_json, write_whole
from cohort.outliers import FEWEST, LIMIT, find_outliers
from cohort.page import Page, text_of
from cohort.results import PAIR_MEASURES, RUN_MEASURES, SERIES_MEASURES, read_examination
from cohort.table import read_table
from cohort.truth import REACH, accuracy, false_per_patient, froc, read_series, registration_error, wilson

OUTCOMES = ("failed", "not run", "unsuitable", "done")  # order on the page
RUN_COLUMNS = ("attempt", "seconds", "processorSeconds", "memoryMB", "askedMB", "begin", "host", "job")


def main():
    output = sys.argv[1]
    settings = read_json(f"{output}/cohort.json")
    subjects = read_table(settings["table"])
    examinations = [read_examination(output, subject, rows) for subject, rows in subjects.items()]
    write_whole(f"{output}/cohort.tsv", results_table(examinations))
    write_whole(f"{output}/runs.tsv", runs_table(examinations))
    done = {one.subject: subjects[one.subject] for one in examinations if one.outcome == "done"}
    write_whole(f"{output}/report.html", page_of(examinations, read_truth(output, done), settings))
    print(f"{counts(examinations)}: {os.path.abspath(output)}/report.html")
    for _, *words in faults_of(examinations):
        print("  " + ": ".join(words))
    sys.exit(any(examination.outcome in ("failed", "not run") for examination in examinations))


def faults_of(examinations):
    """Returns (examination, subject, problem, reason) of all failures."""
    faults = [(one, one.subject, one.outcome, one.message) for one in examinations if one.outcome != "done"]
    return faults + [(one, one.subject, "results not sent", one.unsent) for one in examinations if one.unsent]


def counts(examinations):
    outcomes = [examination.outcome for examination in examinations]
    return ", ".join(f"{outcomes.count(name)} {name}" for name in reversed(OUTCOMES) if name in outcomes)


def columns_of_results():
    return [f"{name}{number}" for number in (1, 2) for name in SERIES_MEASURES] + [*PAIR_MEASURES, "flagged"]


def results_table(examinations):
    columns = columns_of_results()
    rows = [
        [one.subject, one.outcome, one.message, *(one.measures().get(name) for name in columns), "; ".join(one.doubts)]
        for one in examinations
    ]
    return _tabs([["subject", "outcome", "message", *columns, "doubts"], *rows])


def runs_table(examinations):
    rows = [[one.subject, *(one.run.get(name) for name in RUN_COLUMNS)] for one in examinations]
    return _tabs([["subject", *RUN_COLUMNS], *rows])


def _tabs(rows):
    return "".join("\t".join(text_of(cell).replace("\t", " ") for cell in row) + "\n" for row in rows)


def read_truth(output, subjects):
    """Returns series with ground truth, and the registration errors of pairs. Unfinished runs are excluded."""
    series, errors = [], []
    for subject, rows in subjects.items():
        exam = f"{output}/{subject}/exam"
        for row, place in zip(rows, (exam, f"{exam}/second")):
            one = read_series(subject, place, row.truth) if row.truth else None
            series += [one] if one else []
        error = registration_error(exam) if len(rows) == 2 and rows[1].truth else None
        errors += [] if error is None else [error]
    return series, errors


def page_of(examinations, truth, settings):
    outliers = find_outliers(examinations)
    order = sorted(range(len(examinations)), key=lambda index: _urgency(examinations[index], outliers[index]))
    examinations, outliers = [examinations[index] for index in order], [outliers[index] for index in order]
    page = Page(f"Cohort of {len(examinations)} examinations")
    page.paragraph("For research use. This is not a diagnosis and not a medical device.")
    page.heading("Summary")
    page.facts(_summary(examinations, outliers))
    page.heading("Missing or doubtful results")
    _add_missing(page, examinations)
    page.heading("Examinations")
    _add_examinations(page, examinations, outliers)
    page.heading("Distribution of the measures")
    _add_strips(page, examinations, outliers)
    _add_truth(page, *truth)
    page.heading("Time and memory")
    _add_runs(page, examinations, outliers)
    page.heading("Provenance")
    page.facts([("Table", os.path.basename(settings["table"])), ("Options", " ".join(settings["options"]) or "none")])
    return page.text()


def _urgency(examination, outliers):
    """Sort key: missing results first, then the farthest outliers, then doubts; ties in table order."""
    farthest = max(map(abs, _of_results(outliers).values()), default=0.0)
    return OUTCOMES.index(examination.outcome), -farthest, not examination.doubts


def _of_results(outliers):
    """Returns outliers except time and memory, which are highlighted in a separate table."""
    return {name: score for name, score in outliers.items() if name not in RUN_MEASURES}


def _summary(examinations, outliers):
    done = [one for one in examinations if one.outcome == "done"]
    pairs = [one for one in done if one.pair]
    return [
        ("Examinations", counts(examinations)),
        ("Pairs registered", len(pairs)),
        ("Pairs flagged", sum(one.pair["flagged"] or 0 for one in pairs)),
        ("Examinations with an outlier", sum(bool(_of_results(far)) for far in outliers)),
        ("Examinations with a doubt", sum(bool(one.doubts) for one in done)),
        ("Polyp candidates", sum(series["candidates"] or 0 for one in done for series in one.series)),
        ("Time of all runs", f"{sum(one.run.get('seconds', 0) for one in examinations) / 3600:.2f} h"),
    ]


def _add_missing(page, examinations):
    faults = faults_of(examinations)
    if not faults:
        page.paragraph("All examinations are done. Review the outliers.")
        return
    page.table(
        ["Subject", "Outcome", "Why"],
        [words for _, *words in faults],
        "Unsuitable: the input was rejected and is not retried. Failed: tried twice, and retried in the next run.",
        [one.report for one, *_ in faults],
    )


def _add_examinations(page, examinations, outliers):
    page.paragraph(
        f"Outliers come first, highlighted in yellow: values more than {LIMIT} scaled median absolute deviations away from the median "
        f"of their column in cohort.tsv; at least {FEWEST} values are required."
    )
    done = [(one, far) for one, far in zip(examinations, outliers) if one.outcome == "done"]
    series = [(one, str(number + 1), values, far) for one, far in done for number, values in enumerate(one.series)]
    page.table(
        ["Subject", "Series", *map(_readable, SERIES_MEASURES), "Doubts"],
        [
            [one.subject, int(number), *values.values(), "; ".join(one.doubts) if number == "1" else ""]
            for one, number, values, _ in series
        ],
        "Series, in table order.",
        [one.report for one, *_ in series],
        _far_cells([far for *_, far in series], [number for _, number, *_ in series], SERIES_MEASURES, 2),
    )
    pairs = [(one, far) for one, far in done if one.pair]
    if pairs:
        page.table(
            ["Subject", *map(_readable, PAIR_MEASURES), "Flagged"],
            [[one.subject, *(one.pair[name] for name in PAIR_MEASURES), "yes" if one.pair["flagged"] else ""] for one, _ in pairs],
            "Registered pairs.",
            [f"{os.path.dirname(one.report)}/registration/report/index.html" for one, _ in pairs],
            _far_cells([far for _, far in pairs], [""] * len(pairs), PAIR_MEASURES, 1),
        )


def _far_cells(outliers, numbers, measures, first):
    """Returns cells (row, column) of outliers; the measures start at column `first`."""
    return {
        (row, column)
        for row, (far, number) in enumerate(zip(outliers, numbers))
        for column, name in enumerate(measures, first)
        if name + number in far
    }


def _readable(measure):
    """Returns a column heading: "flexure confidence" for "flexureConfidence"."""
    unit = {**SERIES_MEASURES, **PAIR_MEASURES, **RUN_MEASURES, "askedMB": ("MB",)}.get(measure, ("",))[0]
    words = "".join(f" {letter.lower()}" if letter.isupper() else letter for letter in measure.removesuffix("MB"))
    return words + (f", {unit}" if unit else "")


def _add_strips(page, examinations, outliers):
    strips_of = []
    for measures, numbers in ((SERIES_MEASURES, ("1", "2")), (PAIR_MEASURES, ("",)), (RUN_MEASURES, ("",))):
        for name, (unit, heading) in measures.items():
            found = [
                (one.measures()[name + number], name + number in far)
                for one, far in zip(examinations, outliers)
                for number in numbers
                if one.outcome == "done" and one.measures().get(name + number) is not None
            ]
            label = heading.split(":")[0] + (f", {unit}" if unit else "")
            strips_of.append((label, [value for value, _ in found], [is_far for _, is_far in found]))
    page.figure(strips(strips_of), "One tick per finished series or examination, outliers in orange, the median in black.")


def _add_truth(page, series, errors):
    if not series and not errors:
        return
    page.heading("Comparison with the ground truth")
    rows = froc(series)
    if rows:
        page.figure(
            curve([(false, share) for _, share, false in rows], "false candidates per series", "fraction of polyps found"),
            f"FROC of {len(series)} series with {sum(len(one.polyps) for one in series)} polyps.",
        )
        page.table(
            ["Minimum score", "Fraction of polyps found", "False candidates per series"],
            [[threshold, round(share, 3), round(false, 2)] for threshold, share, false in rows],
            f"A candidate is correct within {REACH:g} mm of a polyp. Polyps in collapsed segments count as missed.",
        )
    chances = [chance for one in series for chance in one.chances]
    if chances:
        page.paragraph(
            f"Of {len(chances)} polyps, the spreadsheet states the slice only, so a candidate anywhere in these slices counts as "
            f"correct. If the candidates had random places along the body, {sum(chances):.1f} of these polyps would be found."
        )
    if series:
        _add_accuracy(page, series)
    diameters = [abs(error) for one in series for error in one.diameter_errors]
    page.facts([
        ("Median diameter error of polyps found", _median(diameters)),
        ("Median registration error, median over pairs", _median(errors)),
    ])


def _add_accuracy(page, series):
    """Adds the table of published trials: sensitivity per polyp and per patient, specificity per patient."""
    page.table(
        ["Polyps", "Sensitivity per polyp", "Sensitivity per patient", "Specificity per patient"],
        [[size, *map(_proportion, shares)] for size, *shares in accuracy(series)],
        "Found of all, with 95 % confidence intervals (Wilson). A polyp is found if any series of the patient has a candidate, of any "
        "score, at it. Specificity: patients without a polyp of this size who have no candidate of this size.",
    )
    false = false_per_patient(series)
    page.facts([
        ("False candidates per patient, mean", f"{sum(false) / len(false):.1f}"),
        ("False candidates per patient, median and range", f"{false[len(false) // 2]} ({false[0]} to {false[-1]})"),
    ])


def _proportion(share):
    """Returns "8 of 10: 80 % (49 to 94)"."""
    hits, count = share
    if not count:
        return "none"
    low, high = wilson(hits, count)
    return f"{hits} of {count}: {100 * hits / count:.0f} % ({100 * low:.0f} to {100 * high:.0f})"


def _median(values):
    return f"{sorted(values)[len(values) // 2]:.1f} mm" if values else "not known"


def _add_runs(page, examinations, outliers):
    columns = [name for name in RUN_COLUMNS if any(one.run.get(name) for one in examinations)]
    page.table(
        ["Subject", *map(_readable, columns)],
        [[one.subject, *(one.run.get(name) for name in columns)] for one in examinations],
        "Last attempt; memory of the largest process.",
        far={(row, columns.index(name) + 1) for row, far in enumerate(outliers) for name in RUN_MEASURES if name in far},
    )


if __name__ == "__main__":
    main()
