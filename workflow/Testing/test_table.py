"""The table of a cohort: its meaning, and one clear line per error."""

import os
import unittest

from case import Case
from cohort.arguments import arguments_of
from cohort.table import TableError, read_table

HEADS = "subject\tposition\tsource\tseries\n"


class Table(Case):
    def read(self, text, **options):
        return read_table(self.write("cohort.tsv", text), **options)

    def faults(self, text, **options):
        with self.assertRaises(TableError) as caught:
            self.read(text, **options)
        return str(caught.exception).replace(self.folder + "/", "")

    def test_rows_of_a_subject_are_one_examination(self):
        subjects = self.read(HEADS + "a\tsupine\tct\t1.2.3\nb\tauto\t/data/b\t\na\tprone\tct\t1.2.4\n")
        self.assertEqual(list(subjects), ["a", "b"])
        self.assertEqual([row.series for row in subjects["a"]], ["1.2.3", "1.2.4"])
        self.assertEqual(subjects["a"][0].source, os.path.join(self.folder, "ct"))
        self.assertEqual(subjects["b"][0].source, "/data/b")

    def test_a_table_of_a_spreadsheet(self):
        subjects = self.read("\ufeff" + HEADS.replace("\n", "\r\n") + "a\tsupine\tmy ct\t\r\n\t\t\t\r\n")
        self.assertEqual(subjects["a"][0].source, os.path.join(self.folder, "my ct"))

    def test_a_query(self):
        row = self.read(HEADS + "a\tauto\tpacs:AccessionNumber=A7\t1.2.3\n")["a"][0]
        self.assertEqual(row.query, "AccessionNumber=A7")

    def test_faults_are_named_by_line_and_column(self):
        for row, fault in (
            ("a b\tauto\tct\t", 'line 2: column subject: "a b" is not a valid name'),
            ("a\tsupin\tct\t", 'line 2: column position: "supin" is not one of auto, supine'),
            ("a\tauto\t\t", "line 2: column source: empty"),
            ("a\tauto\tpacs:Name=x\t1.2", "line 2: column source: \"pacs:Name=x\" is not a query; write pacs:KEY=VALUE"),
            ("a\tauto\tpacs:PatientID=x\t", "line 2: column series: a query requires the Series Instance UID"),
            ("a\tauto\tct\tone", 'line 2: column series: "one" is not a Series Instance UID'),
            ("a\tauto\tct", "line 2: found 3 cells for 4 columns"),
            ("a\tauto\tct\t\na\tauto\tct\t", "line 3: column source: same series as in line 2"),
            ("a\tprone\tc\t\na\tprone\td\t", "line 3: column position: line 2 is also prone"),
            ("a\tauto\tc\t\na\tauto\td\t\na\tauto\te\t", 'line 4: column subject: "a" already has two series'),
        ):
            self.assertTrue(self.faults(HEADS + row + "\n").startswith("cohort.tsv, " + fault), row)

    def test_every_fault_is_named_at_once(self):
        self.assertEqual(len(self.faults(HEADS + "a b\tx\tct\t\nb\tauto\t\t\n").splitlines()), 3)

    def test_heads(self):
        self.assertIn('line 1: the column "series" is missing', self.faults("subject\tposition\tsource\na\tauto\tct\n"))
        self.assertIn('line 1: the column "thruth" is unknown', self.faults(HEADS.strip() + "\tthruth\n"))
        self.assertIn("line 1: no rows found", self.faults(HEADS))

    def test_a_file_that_is_no_table(self):
        with self.assertRaisesRegex(TableError, "No such file or directory; check the path"):
            read_table(os.path.join(self.folder, "absent.tsv"))
        with open(self.write("binary.tsv", ""), "wb") as file:
            file.write(b"\xff\xfe\x00")
        with self.assertRaisesRegex(TableError, "not UTF-8 text"):
            read_table(os.path.join(self.folder, "binary.tsv"))

    def test_absent_folders_matter_until_the_subject_is_done(self):
        text = HEADS + "a\tauto\tgone\t\nb\tauto\tgone-too\t\nc\tx\tpacs:PatientID=7\t1.2\n"
        faults = self.faults(text, is_done=lambda subject: subject == "a").splitlines()
        self.assertEqual(len(faults), 2)
        self.assertRegex(faults[0], "line 3: column source: .*gone-too is not a folder; mount it")
        self.assertIn("line 4: column position", faults[1])

    def test_arguments_of_a_pair(self):
        rows = self.read(HEADS + "a\tsupine\tct\t1.2.3\na\tprone\tct\t1.2.4\n")["a"]
        arguments = " ".join(arguments_of("a", rows, ["one", "two"], ["--split"]))
        for part in ("one a/exam", "--seriesUID 1.2.3", "--secondSeriesUID 1.2.4", "--second two", "--position supine",
                     "--secondPosition prone", "--split"):
            self.assertIn(part, arguments)

    def test_arguments_of_fetched_series(self):
        rows = self.read(HEADS + "a\tsupine\tpacs:PatientID=7\t1.2.3\n")["a"]
        self.assertNotIn("--seriesUID", arguments_of("a", rows, ["a/source/1"], []))


if __name__ == "__main__":
    unittest.main()
