"""The arguments of VirtualColonoscopy for an examination."""

import os


def arguments_of(subject, series, folders, options):
    """Returns the arguments; `folders` are the folders of the series, in the same order."""
    arguments = [folders[0], f"{subject}/exam", "--threads", "1", "--quiet"]
    for row, uid, position in zip(series, ("--seriesUID", "--secondSeriesUID"), ("--position", "--secondPosition")):
        if row.series and not row.query:  # a fetched folder contains one series, possibly with a mapped UID
            arguments += [uid, row.series]
        if row.position != "auto":
            arguments += [position, row.position]
    if len(series) == 2:
        arguments += ["--second", folders[1]]
        points = os.path.join(series[1].truth, "points.csv") if series[1].truth else ""
        if points and os.path.exists(points):
            arguments += ["--evaluate", points]
    return arguments + options
