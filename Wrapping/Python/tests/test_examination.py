"""The folder of a virtual colonoscopy."""

import json
import tempfile
import unittest
from pathlib import Path

import numpy as np

import shapeton
from shapeton import surfaces

from support import TestCase


class ExaminationTest(TestCase):
    """A folder with some files, written by the package."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        for stage in ("segmentation", "polyps", "second/segmentation"):
            (self.folder / stage).mkdir(parents=True)
        self.labels = shapeton.Image(np.arange(24, dtype=np.uint8).reshape(2, 3, 4) % 4, (1.0, 2.0, 3.0), (4.0, 5.0, 6.0))
        shapeton.write_volume(self.labels, self.folder / "segmentation/lumen.nrrd")
        self.line = shapeton.Curves(np.arange(12.0).reshape(4, 3), [np.arange(4)])
        surfaces.write_curves(self.line, self.folder / "second/segmentation/centerline.vtp")
        (self.folder / "polyps/candidates.csv").write_text("candidate,score,segment\n1,0.5,sigmoid\n2,,\n")
        (self.folder / "examination.json").write_text('{"format": "Shapeton examination", "version": 1}')

    def test_values(self):
        exam = shapeton.Examination(self.folder)
        self.assertSame(exam.lumen.array, self.labels.array.astype(np.uint16))
        self.assertEqual(exam.lumen.spacing, self.labels.spacing)
        self.assertIs(exam.lumen, exam.lumen)
        self.assertEqual(exam.candidates, [{"candidate": 1.0, "score": 0.5, "segment": "sigmoid"},
                                           {"candidate": 2.0, "score": None, "segment": None}])
        self.assertSame(exam.second.centerline.vertices, self.line.vertices)
        self.assertIsNone(exam.second.second)
        self.assertEqual(set(exam.files()), {"format", "lumen", "candidates"})
        self.assertIn("lumen", dir(exam))
        self.assertIn("3 files", repr(exam))

    def test_missing(self):
        exam = shapeton.Examination(str(self.folder))
        self.assertFalse(exam.has("repaired_wall"))
        with self.assertRaisesRegex(shapeton.MissingFileError, "wall-repaired.vtp.*stage segmentation .ColonSegmentation."):
            exam.repaired_wall
        with self.assertRaisesRegex(AttributeError, "no file \"walls\""):
            exam.walls
        with self.assertRaisesRegex(shapeton.MissingFileError, "the examination .*absent. was not found"):
            shapeton.Examination(self.folder / "absent")

    def test_another_version(self):
        (self.folder / "examination.json").write_text(json.dumps({"version": 2}))
        with self.assertRaisesRegex(shapeton.InputError, "states the version 2 of the format"):
            shapeton.Examination(self.folder)


if __name__ == "__main__":
    unittest.main()
