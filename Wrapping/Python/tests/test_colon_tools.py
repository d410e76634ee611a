"""Each stage of the colon gives the bytes of its tool."""

import json
import unittest

import numpy as np

import shapeton
from shapeton import colon, flattening, surfaces

from support import TestCase, needs_tools, run_tool


@needs_tools
class SameAsToolsTest(TestCase):
    def assertSameSurface(self, path, mesh, arrays=()):
        written = surfaces.read_surface(str(path), component=-1)
        self.assertSame(written.vertices, mesh.vertices)
        self.assertSame(written.faces, mesh.faces)
        for name in arrays:
            self.assertSame(written.point_arrays[name], mesh.point_arrays[name])

    def test_from_ct_to_candidates(self):
        ct = colon.colon_phantom(size=(120, 120, 112), spacing=(3.0, 3.0, 3.0)).ct
        volume = self.folder / "ct.nrrd"
        shapeton.write_volume(ct, str(volume))
        model = self.check_model(ct, volume, self.folder / "segmentation")
        flat, found = self.check_flat(model)
        self.check_candidates(model, flat, found)

    def check_model(self, ct, volume, folder):
        run_tool("ColonSegmentation", volume, folder, "--position", "supine", "--faces", 20000)
        model = colon.build_colon(ct, patient_position="supine", faces=20000)
        labels = shapeton.read_volume(str(folder / "lumen.nrrd")).array
        self.assertSame(labels, model.lumen.labels.array.astype(np.float32))
        cleansed = shapeton.read_volume(str(folder / "cleansed.nrrd")).array
        self.assertLessEqual(np.abs(cleansed - model.cleansed.array).max(), 0.5)  # whole HU in the file
        line = surfaces.read_curves(str(folder / "centreline.vtp"))
        self.assertSame(line.vertices, model.centreline.curve.vertices)
        for name, mesh in (("wall", model.wall.raw), ("wall-repaired", model.wall.repaired),
                           ("wall-simplified", model.wall.simplified)):
            self.assertSameSurface(folder / (name + ".vtp"), mesh, ["arcLength"])
        quality = json.loads((folder / "quality.json").read_text())
        quality.pop("provenance")
        self.assertEqual(quality, model.statistics)
        self.check_stages(ct, model)
        return model

    def check_stages(self, ct, model):
        """The stages one by one give what they give together."""
        lumen = colon.segment_lumen(ct, patient_position="supine")
        cleansed = colon.cleanse(ct, lumen)
        line = colon.trace_centreline(lumen.labels)
        self.assertSame(lumen.labels.array, model.lumen.labels.array)
        self.assertSame(cleansed.ct.array, model.cleansed.array)
        self.assertSame(line.curve.vertices, model.centreline.curve.vertices)
        wall = colon.build_wall(cleansed.occupancy, model.centreline.curve, faces=20000)
        self.assertSame(wall.simplified.vertices, model.wall.simplified.vertices)
        valve, reason = colon.find_valve(lumen.labels, line.curve, cleansed.ct)
        self.assertEqual((reason, valve.arc_length), ("", model.valve.arc_length))
        self.assertEqual(len(colon.measure_distension(line.curve)), len(model.distension))

    def check_flat(self, model):
        wall, line = self.folder / "segmentation/wall-simplified.vtp", self.folder / "segmentation/centreline.vtp"
        (self.folder / "flattening").mkdir()
        path = self.folder / "flattening/flat.vtp"
        run_tool("ColonFlattening", wall, path, "--centreline", line)
        curve = model.centreline.curve
        flattened = flattening.flatten_tube(model.wall.simplified, curve)
        self.assertSameSurface(path, flattened.flat, ["uv", "arcLength"])
        flat = colon.FlatColon(flattened.flat)

        run_tool("ColonLandmarks", path, line, self.folder / "landmarks")
        found = colon.find_landmarks(flat, curve)
        taeniae = surfaces.read_curves(str(self.folder / "landmarks/taeniae.vtp"))
        self.assertSame(taeniae.vertices, found.taeniae.vertices)
        segments = surfaces.read_surface(str(self.folder / "landmarks/segments.vtp"))
        self.assertSame(segments.cell_arrays["segment"], found.segments.cell_arrays["segment"])
        document = json.loads((self.folder / "landmarks/landmarks.json").read_text())
        self.assertEqual({name: document[name] for name in found.statistics}, found.statistics)

        (self.folder / "folds").mkdir()
        table = self.folder / "folds/folds.csv"
        run_tool("ColonFolds", path, self.folder / "folds/labels.nrrd", "--table", table)
        folds = colon.find_folds(flat)
        rows = table.read_text().splitlines()
        self.assertEqual(len(rows) - 1, len(folds.folds))
        return flat, found

    def check_candidates(self, model, flat, found):
        table = self.folder / "candidates.csv"
        run_tool("ColonPolyps", self.folder, table)
        rows = [line.split(",") for line in table.read_text().splitlines()]
        candidates = colon.find_candidates(
            model.wall.repaired,
            model.lumen.labels,
            centreline=model.centreline.curve,
            ct=model.cleansed.like(np.clip(np.rint(model.cleansed.array), -32768, 32767)),  # as the file holds it
            flat=flat,
            segments=found.segments,
            catheter=model.lumen.catheter,
        )
        self.assertEqual(len(rows) - 1, len(candidates))
        places = [[float(row[rows[0].index(axis)]) for axis in "xyz"] for row in rows[1:]]
        np.testing.assert_allclose(places, [c.position for c in candidates], atol=0.06)
        diameters = [float(row[rows[0].index("diameter")]) for row in rows[1:]]
        np.testing.assert_allclose(diameters, [c.diameter for c in candidates], atol=0.06)

        position = colon.read_position(str(self.folder), "supine")
        made = colon.ColonPosition("supine", found, model.centreline.curve, colon.find_folds(flat))
        one = colon.register_positions(position, position)
        other = colon.register_positions(made, made)
        self.assertSame(one.supine_to_prone.point_arrays["mapped"], other.supine_to_prone.point_arrays["mapped"])


if __name__ == "__main__":
    unittest.main()
