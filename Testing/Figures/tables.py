#!/usr/bin/python3
"""usage: tables.py OUT.csv matches NAME=FOLDER...
       tables.py OUT.csv times NAME=ROW.json...
       tables.py OUT.csv numbers SHAPETONS=PREFIX...
       tables.py OUT.csv volumes NAME=SIZE=PREFIX...

Writes a table of the dissertation with the published values and ours. Called by make-figures.

  matches  Table 4.1; FOLDER was written by ColonRegistration
  times    Table 5.1; ROW.json was written by FlatteningPeers
  numbers  Table 3.1; PREFIX.nrrd.run.json are the durations of ShapetonDiffusion
  volumes  Table 3.2; PREFIX-heat.nrrd.run.json and PREFIX-shapetons.nrrd.run.json are the durations of both diffusions
"""
import csv
import json
import sys

# Border features of supine and prone; right, and wrong in supine and prone.
PUBLISHED_MATCHES = {
    "ascending": (30, 29, 28, "2 / 1"),
    "transverse": (42, 37, 34, "8 / 3"),
    "descending": (31, 27, 25, "6 / 2"),
    "sigmoid": (16, 17, 13, "3 / 4"),
    "rectum": (15, 15, 14, "1 / 1"),
    "whole": (134, 125, 114, "20 / 11"),
}

# Model, faces, and seconds of Ricci flow and of the dissertation's method.
PUBLISHED_TIMES = (
    ("192 (Supine)", 56800, 125.7, 11.2),
    ("192 (Supine A)", 12500, 35.6, 3.4),
    ("192 (Supine T)", 23100, 62.2, 5.2),
    ("192 (Prone)", 52900, 112.5, 12.3),
    ("192 (Prone A)", 12800, 33.6, 3.3),
    ("192 (Prone T)", 22700, 57.2, 5.4),
    ("241 (Supine)", 55900, 121.5, 11.4),
    ("241 (Prone)", 53100, 110.8, 11.3),
)

# Shapetons: steps, and milliseconds per step.
PUBLISHED_NUMBERS = {
    "4000": (7100, 0.057),
    "8000": (4400, 0.087),
    "15000": (2800, 0.129),
    "30000": (1600, 0.215),
    "65000": (1500, 0.236),
    "150000": (1200, 0.310),
}

# Volume: resolution, p, steps of both, seconds of both; seconds of heat on an H200, for a phantom of that size (Table 2.1).
PUBLISHED_VOLUMES = {
    "foot": ("256^3", "7", 100000, 2800, 480, 1.90, 0.56),
    "engine": ("256 x 256 x 128", "10", 52000, 1100, 73, 0.81, 0.25),
    "aneurysm": ("256^3", "7.5", 100000, 3100, 510, 2.10, 0.54),
    "MR head": ("256^3", "6", 400000, 4160, 8400, 2.82, 0.78),
    "CT abdomen": ("512 x 512 x 174", "8", 100000, 2600, 4600, 2.13, "not measured"),
    "CT chest": ("384 x 384 x 240", "6", 100000, 1600, 3200, 3.10, "not measured"),
}


def read(path):
    """Returns the content of a JSON file."""
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def rows_of_matches(name, folder):
    """One row per segment of a registration, and one for all; as published, unmatched features count as wrong."""
    result = read(f"{folder}/registration.json")
    hasTruth = "errors" in result
    rows = {one["segment"]: one for one in result["segments"]}
    rows["whole"] = result["matches"]
    for segment in PUBLISHED_MATCHES:
        one = rows[segment]
        supine, prone = one["supineFolds"], one["proneFolds"]
        truth = ("", "", "")
        if hasTruth:
            truth = (one["correct"], f"{supine - one['correct']} / {prone - one['correct']}", one["wrong"])
        yield (name, segment, supine, prone, one["followed"] + one["contradicted"], *truth, one["contradicted"])


def matches(arguments):
    """Table 4.1."""
    yield ("colon", "segment", "supine", "prone", "matched", "right", "not right, supine / prone", "wrong pairs", "contradicted")
    for segment, (supine, prone, right, wrong) in PUBLISHED_MATCHES.items():
        yield ("published", segment, supine, prone, "", right, wrong, "", "")
    for argument in arguments:
        yield from rows_of_matches(*argument.split("=", 1))


def digits(number):
    """Two digits, without an exponent."""
    return f"{float(f'{number:.2g}'):g}"


def times(arguments):
    """Table 5.1, and the comparisons of section 5.3."""
    yield ("model", "faces", "handles", "Ricci flow, s", "metric, s", "metric from 50 eigenpairs, s", "flattening, s",
           "harmonic forms of handles, s", "handles removed by curvature, s", "by loops, s")
    for model, faces, ricci, ours in PUBLISHED_TIMES:
        yield (f"published: {model}", f"{faces:,}", "", ricci, "", "", ours, "", "", "")
    for argument in arguments:
        name, path = argument.split("=", 1)
        row = read(path)
        seconds = [digits(row[key]) if key in row else "" for key in ("ricciFlow", "metric", "metricOf50", "flattening", "forms")]
        removals = [f"{digits(row[key])} ({row['genus'] - row[left]} of {row['genus']})" if key in row else ""
                    for key, left in (("removalByCurvature", "genusAfterCurvature"), ("removalByLoops", "genusAfterLoops"))]
        yield (name, f"{row['faces']:,}", row["genus"], seconds[0] or "fails", *seconds[1:], *removals)


def seconds_of(result, stage):
    """Seconds of a stage of the tool that wrote a volume."""
    return read(result + ".run.json")["stages"][stage]


def numbers(arguments):
    """Table 3.1."""
    yield ("shapetons", "steps", "ms per step, published", "ms per step, ours", "s, published", "s, ours")
    for argument in arguments:
        shapetons, prefix = argument.split("=", 1)
        steps, published = PUBLISHED_NUMBERS[shapetons]
        seconds = seconds_of(prefix + ".nrrd", "Diffusing shapetons")
        yield (f"{int(shapetons):,}", f"{steps:,}", published, digits(1000 * seconds / steps), f"{steps * published / 1000:.2f}",
               digits(seconds))


def volumes(arguments):
    """Table 3.2."""
    yield ("volume, published size", "our size", "p", "CHD steps", "CHD, s, published", "CHD, s, ours", "CHD, s, H200, phantom",
           "shapeton steps", "shapetons, s, published", "shapetons, s, ours")
    for argument in arguments:
        name, size, prefix = argument.split("=", 2)
        resolution, p, heatSteps, steps, heatSeconds, shapetonSeconds, device = PUBLISHED_VOLUMES[name]
        yield (f"{name}, {resolution}", size, p, f"{heatSteps:,}", f"{heatSeconds:,}",
               digits(seconds_of(prefix + '-heat.nrrd', 'Diffusing heat')), device, f"{steps:,}", shapetonSeconds,
               digits(seconds_of(prefix + '-shapetons.nrrd', 'Diffusing shapetons')))


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    head, *rows = {"matches": matches, "times": times, "numbers": numbers, "volumes": volumes}[sys.argv[2]](sys.argv[3:])
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows((head, *rows))


if __name__ == "__main__":
    main()
