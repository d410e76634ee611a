"""Each stage of the colon gives byte-identical results to its tool, both with defaults."""

import json
import tempfile
import unittest
from pathlib import Path

import numpy as np

import shapeton
from shapeton import colon, flattening, surfaces

from support import TestCase, needs_tools, run_tool, stored


class Examination:
    """One position of a synthetic patient, processed by the tools, in the folders of VirtualColonoscopy, and the package.

    The supine position is a DICOM series, the prone one a NIfTI file.
    """

    def __init__(self, name, folder):
        self.folder = folder / name
        volume = folder / (name + "-series")
        run_tool("ColonPhantom", volume, "--position", name, "--size", "120,120,112", "--spacing", "3,3,3")
        if name == "prone":
            ct, volume = shapeton.read_volume(volume), folder / "prone.nii.gz"
            shapeton.write_volume(ct, volume)
        self.ct = shapeton.read_volume(volume)
        self.run_tools(volume)
        self.model = colon.build_colon(self.ct)
        line = self.model.centerline.curve
        self.flattened = flattening.flatten_tube(self.model.wall.simplified, line)
        self.flat = colon.FlatColon(self.flattened.flat)
        self.folds = colon.find_folds(self.flat)
        self.landmarks = colon.find_landmarks(self.flat, line)
        self.position = colon.ColonPosition(name, self.landmarks, line, self.folds)

    def run_tools(self, volume):
        segmentation, flat = self.folder / "segmentation", self.folder / "flattening/flat.vtp"
        for name in ("flattening", "folds"):
            (self.folder / name).mkdir(parents=True)
        run_tool("ColonSegmentation", volume, segmentation)
        run_tool("ColonFlattening", segmentation / "wall-simplified.vtp", flat, "--centerline", segmentation / "centerline.vtp")
        run_tool("ColonLandmarks", flat, segmentation / "centerline.vtp", self.folder / "landmarks")
        run_tool("ColonFolds", flat, self.folder / "folds/labels.nrrd", "--table", self.folder / "folds/folds.csv")


@needs_tools
class SameAsToolsTest(TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.supine, cls.prone = (Examination(name, Path(folder.name)) for name in ("supine", "prone"))

    def assertSameSurface(self, path, mesh, arrays=()):
        written = surfaces.read_surface(path, component=-1)
        self.assertSame(written.vertices, mesh.vertices)
        self.assertSame(written.faces, mesh.faces)
        for name in arrays:
            self.assertSame(written.point_arrays[name], mesh.point_arrays[name])

    def test_ColonPhantom(self):
        run_tool("ColonPhantom", self.folder / "series")
        ct, written = colon.colon_phantom().ct, shapeton.read_volume(self.folder / "series")
        self.assertSame(written.array, ct.array.astype(np.float32))
        np.testing.assert_allclose(written.affine, ct.affine, atol=1e-6)  # decimals in the header

    def test_ColonSegmentation(self):
        for examination in (self.supine, self.prone):
            folder, model = examination.folder / "segmentation", examination.model
            labels = shapeton.read_volume(folder / "lumen.nrrd").array
            self.assertSame(labels, model.lumen.labels.array.astype(np.float32))
            cleansed = shapeton.read_volume(folder / "cleansed.nrrd").array
            self.assertLessEqual(np.abs(cleansed - model.cleansed.array).max(), 0.5)  # integer HU in the file
            line = surfaces.read_curves(folder / "centerline.vtp")
            self.assertSame(line.vertices, model.centerline.curve.vertices)
            for name, mesh in (("wall", model.wall.raw), ("wall-repaired", model.wall.repaired),
                               ("wall-simplified", model.wall.simplified)):
                self.assertSameSurface(folder / (name + ".vtp"), mesh, ["arcLength"])
            quality = json.loads((folder / "quality.json").read_text())
            quality.pop("provenance")
            self.assertEqual(quality, model.statistics)

    def test_the_stages_of_a_segmentation(self):
        """Separate calls give the same results as one call."""
        ct, model = self.supine.ct, self.supine.model
        lumen = colon.segment_lumen(ct)
        cleansed = colon.cleanse(ct, lumen)
        line = colon.trace_centerline(lumen.labels)
        self.assertSame(lumen.labels.array, model.lumen.labels.array)
        self.assertSame(cleansed.ct.array, model.cleansed.array)
        self.assertSame(line.curve.vertices, model.centerline.curve.vertices)
        wall = colon.build_wall(cleansed.occupancy, model.centerline.curve)
        self.assertSame(wall.simplified.vertices, model.wall.simplified.vertices)
        valve, reason = colon.find_valve(lumen.labels, line.curve, cleansed.ct)
        self.assertEqual((reason, valve.arc_length), ("", model.valve.arc_length))
        self.assertEqual(colon.measure_distension(line.curve).share, model.distension.share)

    def test_ColonFlattening(self):
        path = self.supine.folder / "flattening/flat.vtp"
        self.assertSameSurface(path, self.supine.flattened.flat, ["uv", "arcLength"])

    def test_ColonLandmarks(self):
        folder, found = self.supine.folder / "landmarks", self.supine.landmarks
        self.assertSame(surfaces.read_curves(folder / "taeniae.vtp").vertices, found.taeniae.vertices)
        segments = surfaces.read_surface(folder / "segments.vtp")
        self.assertSame(segments.cell_arrays["segment"], found.segments.cell_arrays["segment"])
        document = json.loads((folder / "landmarks.json").read_text())
        self.assertEqual({name: document[name] for name in found.statistics}, found.statistics)

    def test_ColonFolds(self):
        labels = self.supine.folds.labels
        self.assertSame(stored(self.supine.folder / "folds/labels.nrrd", labels.shape), labels)
        rows = (self.supine.folder / "folds/folds.csv").read_text().splitlines()
        self.assertEqual(len(rows) - 1, len(self.supine.folds.folds))

    def test_ColonPolyps(self):
        supine, table = self.supine, self.folder / "candidates.csv"
        run_tool("ColonPolyps", supine.folder, table)
        rows = [line.split(",") for line in table.read_text().splitlines()]
        cleansed = supine.model.cleansed
        candidates = colon.find_candidates(
            supine.model.wall.repaired,
            supine.model.lumen.labels,
            centerline=supine.model.centerline.curve,
            ct=cleansed.like(np.clip(np.rint(cleansed.array), -32768, 32767)),  # as in the file
            flat=supine.flat,
            segments=supine.landmarks.segments,
            catheter=supine.model.lumen.catheter,
        )
        self.assertEqual(len(rows) - 1, len(candidates))
        places = [[float(row[rows[0].index(axis)]) for axis in "xyz"] for row in rows[1:]]
        np.testing.assert_allclose(places, [c.position for c in candidates], atol=0.06)
        diameters = [float(row[rows[0].index("diameter")]) for row in rows[1:]]
        np.testing.assert_allclose(diameters, [c.diameter for c in candidates], atol=0.06)

    def test_ColonRegistration(self):
        out = self.folder / "registration"
        run_tool("ColonRegistration", self.supine.folder, self.prone.folder, out)
        made = colon.register_positions(self.supine.position, self.prone.position)
        read = colon.register_positions(*(colon.read_position(e.folder, name) for e, name in
                                          ((self.supine, "supine"), (self.prone, "prone"))))
        for name, registered in (("supine-to-prone", made.supine_to_prone), ("prone-to-supine", made.prone_to_supine)):
            written = surfaces.read_surface(out / f"map-{name}.vtp")
            self.assertSame(written.point_arrays["mapped"], registered.point_arrays["mapped"])
        self.assertSame(read.supine_to_prone.point_arrays["mapped"], made.supine_to_prone.point_arrays["mapped"])


if __name__ == "__main__":
    unittest.main()
