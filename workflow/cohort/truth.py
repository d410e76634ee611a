"""Comparison of candidates and registration with the ground truth of phantoms, or of readers in the same format
(ColonPhantom's files)."""

import csv
import dataclasses
import math
import os
import statistics

from cohort.files import file_of

REACH = 3.0  # mm beyond the radius of a polyp, as in the published validation tables
# Classes of polyps by diameter in mm, as in published trials: least, below, name.
SIZES = [(6.0, math.inf, "6 mm and more"), (6.0, 10.0, "6 to 9 mm"), (10.0, math.inf, "10 mm and more")]
NORMAL = 1.96  # quantile of the normal distribution for 95 %
THRESHOLDS = [0.95, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.25]


@dataclasses.dataclass
class SeriesTruth:
    """A series with ground truth: the maximum score at each polyp, 0 if it was missed, the ids and diameters of the
    polyps, the diameter errors, scores and diameters of false candidates (NaN if not measured). For polyps whose slice alone
    is known, the probability that one of the candidates is there by chance."""

    subject: str
    polyps: list
    ids: list
    diameters: list
    diameter_errors: list
    false_scores: list
    false_diameters: list
    chances: list = dataclasses.field(default_factory=list)


def read_series(subject, exam, truth):
    """Returns None if candidates or polyps.csv of the ground truth are missing."""
    candidates, polyps = _rows(file_of(exam, "candidates")), _rows(f"{truth}/polyps.csv")
    if candidates is None or polyps is None:
        return None
    best = [max((one for one in candidates if _is_at(one, polyp)), key=_score, default=None) for polyp in polyps]
    false = [one for one in candidates if not any(_is_at(one, polyp) for polyp in polyps)]
    return SeriesTruth(
        subject=subject,
        ids=[polyp["id"] for polyp in polyps],
        diameters=[float(polyp["diameter"]) for polyp in polyps],
        polyps=[_score(one) if one else 0.0 for one in best],
        diameter_errors=[
            float(one["diameter"]) - float(polyp["diameter"]) for one, polyp in zip(best, polyps) if one and one["diameter"]
        ],
        false_scores=[_score(one) for one in false],
        false_diameters=[float(one["diameter"] or "nan") for one in false],
        chances=[_chance(candidates, polyp) for polyp in polyps if not polyp["x"]],
    )


def froc(series):
    """Returns rows (threshold, sensitivity, false candidates per series) over all series."""
    count = sum(len(one.polyps) for one in series)
    if not count:
        return []
    return [
        (
            threshold,
            sum(score >= threshold for one in series for score in one.polyps) / count,
            sum(score >= threshold for one in series for score in one.false_scores) / len(series),
        )
        for threshold in THRESHOLDS
    ]


def accuracy(series):
    """Returns a row (size, polyps, patients, normals) for each class of sizes, each a pair of found and all.

    A polyp is found if a candidate is at it in any series of its patient; a patient with such polyps, if one of them is.
    A patient without such polyps is normal, and found normal if no candidate has such a diameter."""
    found = {}  # of each polyp of a patient
    for one in series:
        for name, diameter, score in zip(one.ids, one.diameters, one.polyps):
            key = one.subject, name
            found[key] = diameter, score > 0 or key in found and found[key][1]
    subjects = {one.subject for one in series}
    rows = []
    for least, below, name in SIZES:
        polyps = {key: hit for key, (diameter, hit) in found.items() if least <= diameter < below}
        ill = {subject for subject, _ in polyps}
        doubted = {one.subject for one in series if any(least <= size < below for size in one.false_diameters)}
        patients = {subject for (subject, _), hit in polyps.items() if hit}
        normals = subjects - ill
        rows.append((name, (sum(polyps.values()), len(polyps)), (len(patients), len(ill)), (len(normals - doubted), len(normals))))
    return rows


def false_per_patient(series):
    """Returns the numbers of false candidates of all series of each patient, ascending."""
    counts = dict.fromkeys((one.subject for one in series), 0)
    for one in series:
        counts[one.subject] += len(one.false_scores)
    return sorted(counts.values())


def wilson(hits, count):
    """Returns the 95 % confidence interval of a proportion (Wilson 1927)."""
    share, square = hits / count, NORMAL**2 / count
    middle = share + square / 2
    half = NORMAL * math.sqrt(share * (1 - share) / count + square / (4 * count))
    return max(0.0, (middle - half) / (1 + square)), min(1.0, (middle + half) / (1 + square))


def registration_error(exam):
    """Returns the median error (mm) of the counted points, or None."""
    errors = [float(row["inSpace"]) for row in _rows(file_of(exam, "errors")) or [] if row["kind"] == "counted"]
    return statistics.median(errors) if errors else None


def _score(candidate):
    return float(candidate["score"])


def _is_at(candidate, polyp):
    """Whether a candidate is within REACH of the polyp's head or base, along the axes that the truth states."""
    return any(_distance(candidate, polyp, names) <= _reach(polyp) for names in (("x", "y", "z"), ("baseX", "baseY", "baseZ")))


def _distance(candidate, polyp, names):
    known = [(float(candidate[axis]), float(polyp[name])) for axis, name in zip("xyz", names) if polyp[name]]
    return math.dist(*zip(*known)) if known else math.inf


def _reach(polyp):
    return 0.5 * float(polyp["diameter"]) + REACH


def _chance(candidates, polyp):
    """The fraction of the scan, along the body, that is within reach of a candidate."""
    low, high = float(polyp["low"]), float(polyp["high"])
    covered, end = 0.0, low
    for place in sorted(float(one["z"]) for one in candidates):
        begin = max(end, place - _reach(polyp))
        end = max(end, min(high, place + _reach(polyp)))
        covered += max(0.0, end - begin)
    return covered / (high - low)


def _rows(path):
    if not os.path.exists(path):
        return None
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))
