"""Detection of outliers among the examinations."""

import statistics

LIMIT = 3.5  # modified z-score, as recommended by Iglewicz and Hoaglin (1993)
FEWEST = 8  # fewer values do not define a usual range


def scores(values):
    """Returns the modified z-score of each value: distance from the median in median absolute deviations, scaled to the
    standard deviation. None without a value; all 0 for too few values, or if more than half are equal."""
    known = [value for value in values if value is not None]
    middle = statistics.median(known) if known else 0.0
    deviation = statistics.median(abs(value - middle) for value in known) if known else 0.0
    if len(known) < FEWEST or deviation == 0.0:
        return [None if value is None else 0.0 for value in values]
    return [None if value is None else 0.6745 * (value - middle) / deviation for value in values]


def find_outliers(examinations):
    """Returns the outliers of each examination as {measure: score}."""
    measures = [examination.measures() for examination in examinations]
    found = [{} for _ in examinations]
    for name in sorted({name for one in measures for name in one} - {"flagged"}):
        for index, score in enumerate(scores([one.get(name) for one in measures])):
            if score is not None and abs(score) > LIMIT:
                found[index][name] = score
    return found
