"""The group report: outliers and FROC against values computed by hand, order of the page."""

import contextlib
import io
import json
import unittest
from unittest import mock

from case import Case
from cohort.outliers import find_outliers, scores
from cohort.report import main, page_of, results_table
from cohort.results import SERIES_MEASURES, Examination, read_examination
from cohort.table import read_table
from cohort.truth import SeriesTruth, accuracy, false_per_patient, froc, read_series, wilson

POLYPS = "id,diameter,x,y,z,baseX,baseY,baseZ\n1,10,0,0,0,5,0,0\n2,6,100,0,0,100,3,0\n"
CANDIDATES = "score,diameter,x,y,z\n0.95,9,12.9,0,0\n0.5,8,0,7,0\n0.85,6,50,0,0\n"


def examination(subject, length, outcome="done"):
    series = dict(dict.fromkeys(SERIES_MEASURES), length=length)
    return Examination(subject, outcome, "why <not>" if outcome != "done" else "", [series], {}, {}, "x.html")


class Outliers(unittest.TestCase):
    def test_score_by_hand(self):
        # median 4.5, deviations 3.5 2.5 1.5 .5 .5 1.5 2.5 95.5: their median is 2
        self.assertAlmostEqual(scores([1, 2, 3, 4, 5, 6, 7, 100])[7], 0.6745 * 95.5 / 2)
        self.assertAlmostEqual(scores([1, 2, 3, 4, 5, 6, 7, 100])[0], -0.6745 * 3.5 / 2)

    def test_few_or_equal_values_have_no_outlier(self):
        self.assertEqual(scores([1, 2, 3, 4, 5, 6, 100]), [0.0] * 7)
        self.assertEqual(scores([1] * 8 + [100]), [0.0] * 9)
        self.assertEqual(scores([None, None]), [None, None])

    def test_one_is_found(self):
        found = find_outliers([examination(str(i), i) for i in range(8)] + [examination("far", 500), examination("none", None)])
        self.assertEqual([list(one) for one in found], [[]] * 8 + [["length1"], []])


class Truth(Case):
    def test_froc_by_hand(self):
        self.write("polyps.csv", POLYPS)
        self.write("polyps/candidates.csv", CANDIDATES)
        one = read_series("a", self.folder, self.folder)
        # the first candidate is 7.9 mm from the base of a polyp with a radius of 5 mm; 8 mm is the limit
        self.assertEqual(one.polyps, [0.95, 0.0])
        self.assertEqual(one.false_scores, [0.85])
        self.assertEqual(one.diameter_errors, [-1.0])
        curve = {threshold: rest for threshold, *rest in froc([one, one])}
        self.assertEqual(curve[0.95], [0.5, 0.0])
        self.assertEqual(curve[0.8], [0.5, 1.0])

    def test_accuracy_by_hand(self):
        def series(subject, found, diameters, false=()):
            ids = [str(i) for i in range(len(diameters))]
            scores = [float(hit) for hit in found]
            return SeriesTruth(subject, scores, ids, list(diameters), [], [0.5] * len(false), list(false))

        cohort = [
            series("a", [1, 0], [12, 7]),  # supine
            series("a", [0, 1], [12, 7], [8.0]),  # prone finds the other polyp
            series("b", [0, 1], [10, 5]),  # of these, only one counts
            series("c", [], [], [11.0, float("nan")]),
            series("d", [], []),
        ]
        self.assertEqual(
            accuracy(cohort),
            [
                ("6 mm and more", (2, 3), (1, 2), (1, 2)),
                ("6 to 9 mm", (1, 1), (1, 1), (3, 3)),
                ("10 mm and more", (1, 2), (1, 2), (1, 2)),
            ],
        )
        self.assertEqual(false_per_patient(cohort), [0, 0, 1, 2])

    def test_intervals_of_the_literature(self):
        # Newcombe 1998, table I: 81 of 263 and 0 of 20
        for hits, count, low, high in ((81, 263, 0.2553, 0.3662), (0, 20, 0.0, 0.1611)):
            found = wilson(hits, count)
            self.assertAlmostEqual(found[0], low, 4)
            self.assertAlmostEqual(found[1], high, 4)

    def test_without_files_there_is_nothing(self):
        self.assertIsNone(read_series("a", self.folder, self.folder))
        self.assertEqual(froc([]), [])


class Results(Case):
    def row(self):
        return read_table(self.write("t.tsv", "subject\tposition\tsource\tseries\na\tsupine\tct\t\n"))["a"]

    def test_outcomes(self):
        self.assertEqual(read_examination(self.folder, "a", self.row()).outcome, "not run")
        self.write("a/attempt.json", json.dumps({"attempt": 2, "askedMB": 900}))
        failed = read_examination(self.folder, "a", self.row())
        self.assertEqual((failed.outcome, failed.message), ("failed", "its job was killed, with 900 MB requested (attempt 2)"))
        self.write("a/status.json", json.dumps({"outcome": "unsuitable", "message": "no colon"}))
        self.assertEqual(read_examination(self.folder, "a", self.row()).outcome, "unsuitable")

    def test_measures_and_doubts(self):
        self.write("a/status.json", json.dumps({"outcome": "done", "message": ""}))
        quality = {"centerline": {"length": 1800.4, "gaps": [{}]}, "distension": {"whole": {"share": 0.987, "meanCaliber": 26.06}}}
        self.write("a/exam/segmentation/quality.json", json.dumps(quality))
        flexures = [{"found": True, "confidence": 0.555}, {"found": True, "confidence": 0.9}, {"found": False}]
        self.write("a/exam/landmarks/landmarks.json", json.dumps({"flexures": flexures}))
        one = read_examination(self.folder, "a", self.row())
        measures = one.measures()
        self.assertEqual([measures[name] for name in ("length1", "distended1", "gaps1", "flexures1", "flexureConfidence1")],
                         [1800, 98.7, 1, 2, 0.56])
        self.assertIsNone(measures["candidates1"])
        self.assertEqual(one.doubts, ["supine: gaps are bridged", "supine: 2 of 4 flexures not found"])


class Report(Case):
    def test_the_truth_is_held_against_runs_that_are_done(self):
        table = "subject\tposition\tsource\tseries\ttruth\n" + "".join(f"{name}\tsupine\tct\t\ttruth\n" for name in "ab")
        self.write("cohort.json", json.dumps({"table": self.write("t.tsv", table), "options": []}))
        self.write("truth/polyps.csv", POLYPS)
        for name in "ab":
            self.write(f"{name}/exam/polyps/candidates.csv", CANDIDATES)
        self.write("a/status.json", json.dumps({"outcome": "done", "message": ""}))
        self.write("b/attempt.json", json.dumps({"attempt": 2, "askedMB": 900}))  # it was killed after this stage
        with mock.patch("sys.argv", ["report.py", self.folder]), contextlib.redirect_stdout(io.StringIO()):
            self.assertRaises(SystemExit, main)
        with open(f"{self.folder}/report.html", encoding="utf-8") as file:
            text = file.read()
        self.assertIn("FROC of 1 series with 2 polyps", text)
        self.assertIn("1 of 2: 50 % (9 to 91)", text)


class ReportPage(unittest.TestCase):
    settings = {"table": "t.tsv", "options": []}

    def test_what_is_missing_comes_first_then_outliers(self):
        cohort = [examination(f"usual{i}", 1800 + i) for i in range(9)]
        cohort += [examination("far", 4000), examination("broken", None, "unsuitable"), examination("dead", None, "failed")]
        text = page_of(cohort, ([], []), self.settings)
        places = [text.index(f">{name}<") for name in ("dead", "broken", "far", "usual0", "usual8")]
        self.assertEqual(places, sorted(places))
        self.assertIn('<td class="number far">4000</td>', text)
        self.assertIn("why &lt;not&gt;", text)
        self.assertIn('<a href="x.html">far</a>', text)

    def test_the_tables_hold_every_subject(self):
        lines = results_table([examination("a", 1), examination("b\tc", None)]).splitlines()
        self.assertEqual([line.split("\t")[0] for line in lines], ["subject", "a", "b c"])
        self.assertEqual(len({line.count("\t") for line in lines}), 1)


if __name__ == "__main__":
    unittest.main()
