"""Selection of series and spreadsheets of polyps: layouts, contradictions, faulty rows, and truth by slices."""

import csv
import json
import os
import unittest
from types import SimpleNamespace

from case import WORKFLOW, Case
from collection.listing import Series, patients_of, position_of, read_series, series_of
from collection.overlap import masks_of
from collection.prepare import Truth
from collection.selection import select
from collection.sheets import SheetError, read_columns, read_patients, read_polyps
from cohort.truth import read_series as read_truth

COLUMNS = os.path.join(WORKFLOW, "collection/columns.txt")


def series(uid, position="supine", **values):
    common = dict(
        uid=uid, number=1, description="", position=position, doubt="", plane="axial", slices=400, spacing=1.0, folder="x",
        refusal="", origin=[-200.0, -200.0, 100.0], normal=[0.0, 0.0, 1.0], places={n: float(n - 1) for n in range(1, 401)},
    )
    return Series(**{**common, **values})


class Listing(Case):
    def test_folders_of_the_collection_are_skipped(self):
        for path in ("A/CT COLONOGRAPHY/1.2.0001/study/series", "A/CT COLONOGRAPHY/1.2.0002/study/series"):
            os.makedirs(os.path.join(self.folder, path))
        found = patients_of(self.folder)
        self.assertEqual(list(found), ["1_2_0001", "1_2_0002"])
        self.assertTrue(found["1_2_0002"].endswith("A/CT COLONOGRAPHY/1.2.0002"))

    def test_positions_of_headers_and_descriptions(self):
        self.assertEqual(position_of("FFP", ""), ("prone", ""))
        self.assertEqual(position_of("HFDL", ""), ("leftDecubitus", ""))
        self.assertEqual(position_of("", "Right DECUB 1.25"), ("rightDecubitus", ""))
        self.assertEqual(position_of("", "recon 3"), ("", ""))
        position, doubt = position_of("HFS", "PRONE colon")
        self.assertEqual(position, "supine")
        self.assertIn("contradicts", doubt)

    def test_places_of_slices_by_instance_number(self):
        one = {
            "seriesInstanceUID": "1.2", "seriesNumber": 3, "description": "d", "patientPosition": "HFS", "modality": "CT",
            "plane": "axial", "refusal": "", "parts": 1, "size": [512, 512, 2], "spacing": [0.7, 0.7, 1.25],
            "origin": [1.0, 2.0, 3.0], "direction": [1, 0, 0, 0, 1, 0, 0, 0, -1],
            "slices": [{"file": "s/a.dcm", "instanceNumber": 9, "position": 0.0}, {"file": "s/b.dcm", "instanceNumber": 7, "position": 1.25}],
        }
        found = series_of(one, "/data/p")
        self.assertEqual(found.point(7), [1.0, 2.0, 1.75])
        self.assertIsNone(found.point(8))
        self.assertEqual(found.folder, "/data/p/s")
        self.assertIn("2 volumes", series_of({**one, "parts": 2}, "/data/p").refusal)

    def test_a_listing_is_made_once(self):
        cache = self.write("cache.json", json.dumps({"series": [], "message": "damaged"}))
        self.assertEqual(read_series("/nowhere", "/nowhere", cache), ([], "damaged"))


class Selection(unittest.TestCase):
    def test_supine_and_prone_with_the_finest_slices(self):
        all_series = [
            series("topogram", slices=1), series("thick", spacing=5.0, slices=90), series("coarse", spacing=2.5, slices=160),
            series("fine"), series("prone", "prone"), series("left", "leftDecubitus"), series("coronal", plane="coronal"),
            series("gap", refusal="slices are missing"), series("unknown", ""),
        ]
        chosen, reasons = select(all_series)
        self.assertEqual([one.uid for one in chosen], ["fine", "prone"])
        self.assertEqual(set(reasons), {one.uid for one in all_series} - {"fine", "prone"})
        self.assertIn("topogram", reasons["topogram"])
        self.assertIn("5.0 mm apart", reasons["thick"])
        self.assertEqual(reasons["gap"], "slices are missing")
        self.assertEqual(reasons["left"], "an examination has two positions")

    def test_other_positions_replace_missing_ones(self):
        chosen, _ = select([series("right", "rightDecubitus"), series("prone", "prone")])
        self.assertEqual([one.uid for one in chosen], ["prone", "right"])
        self.assertEqual(select([series("bad", refusal="why")])[0], [])


class Sheets(Case):
    SUBJECTS = {"1.2.9.0001": "a", "1.2.9.0002": "b"}

    def read(self, text):
        return read_polyps(self.write("polyps.csv", text), read_columns(COLUMNS), self.SUBJECTS)

    def test_rows_and_their_faults(self):
        polyps, faults = self.read(
            "Polyps of 10 mm and more\nTCIA Number,Location,Size (mm),Supine slice,Prone slice\n"
            "1.2.9.0001,sigmoid,12,120-126,not seen\n0002,cecum,1.1 cm,300,301\n\n0003,cecum,11,1,2\n0001,rectum,large,1,2\n"
            "0001,rectum,10,1 2 3,\n"
        )
        self.assertEqual([(one.subject, one.diameter, one.slices) for one in polyps],
                         [("a", 12.0, {"supine": 123}), ("b", 11.0, {"supine": 300, "prone": 301})])
        self.assertEqual(len(faults), 3)
        self.assertIn('polyps.csv, line 6: the patient "0003" has no folder', faults[0])
        self.assertIn('line 7: the size "large"', faults[1])
        self.assertIn('line 8: "1 2 3" is not the number of a slice', faults[2])

    def test_patients_without_polyps(self):
        path = self.write("none.csv", "Patient ID\n0001\n7\n")
        found, faults = read_patients(path, read_columns(COLUMNS), self.SUBJECTS)
        self.assertEqual(found, ["a"])
        self.assertEqual(len(faults), 1)

    def test_a_workbook(self):
        try:
            import openpyxl
        except ImportError:
            self.skipTest("openpyxl is not installed")
        book = openpyxl.Workbook()
        for row in (["Patient", "Size"], ["0001", 12.0], [2, "8 mm"]):
            book.active.append(row)
        path = os.path.join(self.folder, "polyps.xlsx")
        book.save(path)
        polyps, faults = read_polyps(path, read_columns(COLUMNS), {"0001": "a", "2": "b"})
        self.assertEqual([one.diameter for one in polyps], [12.0, 8.0])
        self.assertEqual(faults, [])

    def test_what_cannot_be_read(self):
        for name, text, message in (
            ("a.csv", "Name,Size\nx,1\n", "no row has the heading of the patient"),
            ("a.xls", "no workbook", "not a spreadsheet"),
        ):
            with self.assertRaisesRegex(SheetError, message):
                read_polyps(self.write(name, text), read_columns(COLUMNS), {})
        with self.assertRaisesRegex(SheetError, 'line 1: "tint = x" is not FIELD = HEADING'):
            read_columns(self.write("columns.txt", "tint = x\n"))
        with self.assertRaisesRegex(SheetError, "check the path"):
            read_polyps("/nowhere.csv", read_columns(COLUMNS), {})


class TruthBySlices(Case):
    def truth(self, rows, healthy=""):
        given = SimpleNamespace(
            columns=COLUMNS, polyps=[self.write("p.csv", "Patient,Size,Supine slice,Prone slice\n" + rows)],
            noPolyps=[self.write("n.csv", "Patient\n" + healthy)],
        )
        return Truth(given, {"p1": "p1", "p2": "p2", "p3": "p3"})

    def polyps_of(self, place):
        with open(f"{self.folder}/{place}/polyps.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def test_polyps_have_the_place_of_their_slice(self):
        truth = self.truth("p1,10,51,\n", "p2\n")
        place = truth.write(self.folder, "p1", series("s"))
        self.assertEqual(self.polyps_of(place),
                         [dict(id="1", diameter="10.0", x="", y="", z="150.000", baseX="", baseY="", baseZ="", low="100.000", high="499.000")])
        self.assertEqual(truth.write(self.folder, "p1", series("s", "prone")), "")  # the polyp has no slice there
        self.assertIn("no slice in the selected prone series", truth.faults[0])
        self.assertEqual(self.polyps_of(truth.write(self.folder, "p2", series("s"))), [])
        self.assertEqual(truth.write(self.folder, "p3", series("s")), "")

    def test_a_slice_of_another_series_is_a_fault(self):
        truth = self.truth("p1,10,401,\n")
        self.assertEqual(truth.write(self.folder, "p1", series("s")), "")
        self.assertIn("line 2: slice 401 is missing in the selected supine series", truth.faults[0])

    def test_candidates_in_the_slices_count_and_the_chance_is_known(self):
        place = self.truth("p1,10,51,\n").write(self.folder, "p1", series("s"))
        self.write("polyps/candidates.csv", "score,diameter,x,y,z\n0.9,9,80,80,157.9\n0.8,9,0,0,142.1\n0.7,9,0,0,158.1\n")
        found = read_truth("p1", self.folder, f"{self.folder}/{place}")
        self.assertEqual(found.polyps, [0.9])
        self.assertEqual(found.false_scores, [0.7])
        # the candidates reach from 134.1 to 166.1 of 399 mm
        self.assertAlmostEqual(found.chances[0], 32.0 / 399.0)


class Overlaps(Case):
    def test_boxes_by_hand(self):
        try:
            import numpy
            from collection.overlap import measures
            import scipy  # noqa: F401
        except ImportError as error:
            self.skipTest(str(error))
        box, moved = (numpy.zeros((20, 20, 20), bool) for _ in range(2))
        box[2:12, 4:14, 5:15] = True
        moved[4:14, 4:14, 5:15] = True  # by 2 voxels of 1.5 mm
        dice, mean, farthest = measures(box, moved, (1.5, 1.0, 1.0))
        self.assertAlmostEqual(dice, 0.8)
        self.assertAlmostEqual(farthest, 3.0)  # the moved faces, 100 of 488 voxels
        self.assertLess(mean, 3.0)
        self.assertEqual(measures(box, box, (1, 1, 1)), (1.0, 0.0, 0.0))
        with self.assertRaisesRegex(ValueError, "empty"):
            measures(box, numpy.zeros_like(box), (1, 1, 1))

    def test_masks_are_found_by_name_or_list(self):
        self.write("masks/1.2.3-lumen.mha", "")
        self.write("masks/sub006_pos-prone.mha", "")
        self.write("masks/metadata.jsonl", '{"name": "sub006", "file": "masks/sub006_pos-prone.mha", "SeriesInstanceUID": "1.2.4"}\n')
        found = masks_of(self.folder, {"1.2.3", "1.2.4", "1.2.5"})
        self.assertEqual({uid: os.path.basename(path) for uid, path in found.items()},
                         {"1.2.3": "1.2.3-lumen.mha", "1.2.4": "sub006_pos-prone.mha"})


if __name__ == "__main__":
    unittest.main()
