#!/usr/bin/env python3
"""check_verdicts.py EXAM_FOLDER VERDICTS.json

Checks the verdicts that DicomResultsToColon read from the report of label_report.py.
"""

import csv
import json
import pathlib
import sys

import check_objects
from check_objects import check


def main(exam, path):
    rows = list(csv.DictReader((exam / "polyps" / "candidates.csv").open(encoding="utf-8")))
    saved = json.loads(path.read_text(encoding="utf-8"))
    found = {one["id"]: one for one in saved["candidates"]}
    numbers = {row["candidate"] for row in rows}
    check(set(found) == numbers - {"3"}, f"candidates {sorted(found)}")
    words = {name: found[name]["verdict"] for name in found}
    expected = {name: {"1": "polyp", "2": "not a polyp"}.get(name, "unread") for name in found}
    check(words == expected, f"verdicts {words}")
    check(found["2"]["note"] == "a fold", f"note {found['2']['note']}")
    sizes = {name: one["size"] for name, one in found.items() if one["size"] is not None}
    measured = float(next(row for row in rows if row["candidate"] == "4")["diameter"]) + 4.0
    check(list(sizes) == ["4"] and abs(sizes["4"] - measured) < 1e-3, f"sizes {sizes}")
    (finding,) = saved["findings"]
    last = rows[-1]
    offset = [a - float(last[axis]) for a, axis in zip(finding["lps"], "xyz")]
    check(finding["note"] == "behind a fold", f"note of the finding {finding['note']}")
    check(abs(finding["diameter"] - float(last["diameter"])) < 1e-3, "size of the finding")
    check(offset[0] > 0 and offset[1] > 0, f"the finding is beside the last candidate: {offset}")
    return 1 if check_objects.failures else 0


if __name__ == "__main__":
    if len(sys.argv) != 3 or "--help" in sys.argv:
        print(__doc__)
        sys.exit(0 if "--help" in sys.argv else 2)
    sys.exit(main(*(pathlib.Path(argument) for argument in sys.argv[1:])))
