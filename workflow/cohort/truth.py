"""Comparison of candidates and registration with the ground truth of phantoms, or of readers in the same format
(ColonPhantom's files)."""

import csv
import dataclasses
import math
import os
import statistics

REACH = 3.0  # mm beyond the radius of a polyp, as in the published validation tables
THRESHOLDS = [0.95, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.25]


@dataclasses.dataclass
class SeriesTruth:
    """A series with ground truth: the maximum score at each polyp, the diameter errors, the scores of false
    candidates."""

    polyps: list
    diameter_errors: list
    false_scores: list


def read_series(exam, truth):
    """Returns None if candidates or polyps.csv of the ground truth are missing."""
    candidates, polyps = _rows(f"{exam}/polyps/candidates.csv"), _rows(f"{truth}/polyps.csv")
    if candidates is None or polyps is None:
        return None
    best = [max((one for one in candidates if _is_at(one, polyp)), key=_score, default=None) for polyp in polyps]
    return SeriesTruth(
        polyps=[_score(one) if one else 0.0 for one in best],
        diameter_errors=[
            float(one["diameter"]) - float(polyp["diameter"]) for one, polyp in zip(best, polyps) if one and one["diameter"]
        ],
        false_scores=[_score(one) for one in candidates if not any(_is_at(one, polyp) for polyp in polyps)],
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


def registration_error(exam):
    """Returns the median error (mm) of the counted points, or None."""
    errors = [float(row["inSpace"]) for row in _rows(f"{exam}/registration/errors.csv") or [] if row["kind"] == "counted"]
    return statistics.median(errors) if errors else None


def _score(candidate):
    return float(candidate["score"])


def _is_at(candidate, polyp):
    """Whether a candidate is within REACH of the polyp's head or base."""
    place = [float(candidate[name]) for name in "xyz"]
    ends = [[float(polyp[name]) for name in names] for names in (("x", "y", "z"), ("baseX", "baseY", "baseZ"))]
    return min(math.dist(place, end) for end in ends) <= 0.5 * float(polyp["diameter"]) + REACH


def _rows(path):
    if not os.path.exists(path):
        return None
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))
