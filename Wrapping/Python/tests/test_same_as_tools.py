"""Functions with defaults give byte-identical results to their tools; for the stages of a colon, see
test_colon_tools."""

import csv
import json
import unittest

import numpy as np

import shapeton
from shapeton import flattening, graphs, shapes, surfaces

from support import DATA, TestCase, balls, cylinder, needs_tools, run_tool

TORUS = DATA / "Torus.off"
SERIES = DATA / "PhantomSeries"


@needs_tools
class SameAsToolsTest(TestCase):
    def setUp(self):
        super().setUp()
        self.image = balls()
        self.volume = self.folder / "volume.nrrd"
        shapeton.write_volume(self.image, self.volume)

    def read(self, name):
        return shapeton.read_volume(self.folder / name).array

    def test_CumulativeHeatDiffusion(self):
        run_tool("CumulativeHeatDiffusion", self.volume, self.folder / "heat.nrrd", "--labels", self.folder / "labels.nrrd")
        result = shapeton.diffuse_heat(self.image, components=True)
        self.assertSame(result.heat.array, self.read("heat.nrrd"))
        labels, _ = shapeton.classify_heat(result.heat, result.components)
        self.assertSame(labels.array.astype(np.float32), self.read("labels.nrrd"))

    def test_volumes_of_dicom_and_nifti(self):
        """The modality travels with the volume: the window of the series is that of CT, although its values are not in HU."""
        series, nifti = shapeton.read_volume(SERIES), self.folder / "volume.nii.gz"
        shapeton.write_volume(series, nifti)
        self.assertEqual(shapeton.diffuse_heat(series).window, (-160.0, 240.0))
        self.assertNotEqual(shapeton.diffuse_heat(shapeton.read_volume(nifti)).window, (-160.0, 240.0))
        for path in (SERIES, nifti):
            with self.subTest(path=path.name):
                self.assertSameResults(path)

    def assertSameResults(self, volume):
        """Compares all tools that compute something from any volume."""
        heat, classes, visits, objects, labels, doubt, seeds, table = (
            self.folder / name for name in ("heat.nrrd", "classes.nrrd", "visits.nrrd", "objects.nrrd", "labels.nrrd",
                                            "doubt.nrrd", "seeds.nrrd", "table.csv"))
        image = shapeton.read_volume(volume)
        result = shapeton.diffuse_heat(image, components=True)
        found, _ = shapeton.classify_heat(result.heat, result.components)
        strokes = image.like(np.zeros(image.array.shape, np.uint16))
        strokes.array[:, 0, 0], strokes.array[np.unravel_index(image.array.argmax(), image.array.shape)] = 1, 2
        shapeton.write_volume(strokes, seeds)
        run_tool("CumulativeHeatDiffusion", volume, heat, "--labels", classes)
        run_tool("ShapetonDiffusion", volume, visits)
        run_tool("HeatObjects", volume, heat, objects, table)
        run_tool("SeededHeatSegmentation", volume, seeds, labels, "--uncertainty", doubt)
        run_tool("ShapeSignature", volume, classes, table)
        segmented = shapes.SeededHeat(image).segment(strokes)
        for path, expected in (
            (heat, result.heat),
            (classes, found),
            (visits, shapeton.diffuse_shapetons(image).visits),
            (objects, shapeton.find_objects(result.heat).labels),
            (labels, segmented.labels),
            (doubt, segmented.uncertainty),
        ):
            self.assertSame(expected.array.astype(np.float32), shapeton.read_volume(path).array)
        shapes.write_shape_table(shapes.describe_shapes(image, found), self.folder / "own.csv")
        self.assertEqual((self.folder / "own.csv").read_bytes(), table.read_bytes())

    def test_rows_of_the_histogram(self):
        table = self.folder / "histogram.csv"
        run_tool("CumulativeHeatDiffusion", self.volume, self.folder / "heat.nrrd", "--timeSteps", 700,
                 "--histogramTable", table)
        with open(table, encoding="utf-8") as file:
            rows = sorted({int(row[0]) for row in csv.reader(line for line in file if line[0].isdigit())})
        self.assertEqual(rows, shapeton.recorded_steps(700, 512))

    def test_ShapetonDiffusion(self):
        run_tool("ShapetonDiffusion", self.volume, self.folder / "visits.nrrd")
        self.assertSame(shapeton.diffuse_shapetons(self.image).visits.array.astype(np.float32), self.read("visits.nrrd"))

    def test_HeatObjects(self):
        heat, table = self.folder / "heat.nrrd", self.folder / "objects.csv"
        run_tool("CumulativeHeatDiffusion", self.volume, heat)
        run_tool("HeatObjects", self.volume, heat, self.folder / "labels.nrrd", table)
        result = shapeton.diffuse_heat(self.image)
        self.assertSame(result.heat.array, self.read("heat.nrrd"))
        found = shapeton.find_objects(result.heat)
        self.assertSame(found.labels.array.astype(np.float32), self.read("labels.nrrd"))
        with open(table, encoding="utf-8") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        self.assertGreater(len(rows), 0)
        self.assertEqual(len(rows), len(found.objects))
        for row, one in zip(rows, found.objects):
            self.assertEqual((int(row["parent"]), int(row["voxels"])), (one.parent, one.voxels))
            same = {name: getattr(one, name) for name in ("volume", "compactness", "probability", "range", "contrast")}
            for name, value in {**dict(zip("xyz", one.center)), **same}.items():
                self.assertAlmostEqual(float(row[name]), value, delta=1e-9 * abs(value))  # the file rounds the grid

    def test_mask_and_barrier(self):
        heat, labels, table, mask, barrier = (
            self.folder / name for name in ("heat.nrrd", "labels.nrrd", "objects.csv", "mask.nrrd", "barrier.nrrd")
        )
        inside = np.ones(self.image.array.shape, np.uint8)
        inside[:3], inside[:, :, inside.shape[2] // 2] = 0, 0  # a wall through the volume
        shapeton.write_volume(self.image.like(inside), mask)
        shapeton.write_volume(self.image.like(1 - inside), barrier)
        domain = self.image.like(inside)
        found = shapeton.diffuse_heat(self.image, domain=domain).heat
        self.assertFalse(found.array[inside == 0].any())
        objects = shapeton.find_objects(found, domain=domain)
        for name, path in (("--mask", mask), ("--barrier", barrier)):
            run_tool("CumulativeHeatDiffusion", self.volume, heat, name, path)
            self.assertSame(found.array, self.read("heat.nrrd"))
            run_tool("HeatObjects", self.volume, heat, labels, table, name, path)
            self.assertSame(objects.labels.array.astype(np.float32), self.read("labels.nrrd"))

    def test_refined_mask(self):
        ball = (self.image.array > self.image.array.mean()).astype(np.uint8)
        seeds, mask, labels = (self.folder / name for name in ("seeds.nrrd", "mask.nrrd", "refined.nrrd"))
        voxels = np.zeros(ball.shape, np.uint16)
        brightest = np.unravel_index(self.image.array.argmax(), voxels.shape)
        voxels[brightest] = 2  # not this ball
        shapeton.write_volume(self.image.like(voxels), seeds)
        shapeton.write_volume(self.image.like(ball), mask)
        run_tool("SeededHeatSegmentation", self.volume, seeds, labels, "--refine", mask)
        before = self.image.like(np.where(ball, 1, 2).astype(np.uint16))
        found = shapes.SeededHeat(self.image).segment(self.image.like(voxels), before=before).labels.array
        self.assertSame(found.astype(np.float32), self.read("refined.nrrd"))
        self.assertEqual(found[brightest], 2)
        self.assertLess((found == 1).sum(), ball.sum())

    def test_SeededHeatSegmentation(self):
        voxels = np.zeros(self.image.array.shape, np.uint16)
        brightest = np.unravel_index(self.image.array.argmax(), voxels.shape)
        voxels[0, :, 0], voxels[brightest] = 1, 2
        seeds, labels, doubt = (self.folder / name for name in ("seeds.nrrd", "labels.nrrd", "doubt.nrrd"))
        shapeton.write_volume(self.image.like(voxels), seeds)
        run_tool("SeededHeatSegmentation", self.volume, seeds, labels, "--uncertainty", doubt)
        found = shapes.SeededHeat(self.image).segment(self.image.like(voxels))
        self.assertSame(found.labels.array.astype(np.float32), self.read("labels.nrrd"))
        self.assertSame(found.uncertainty.array, self.read("doubt.nrrd"))

    def test_DicomSeriesToImage(self):
        run_tool("DicomSeriesToImage", SERIES, self.folder / "image.nrrd")
        image, written = shapeton.read_volume(SERIES), shapeton.read_volume(self.folder / "image.nrrd")
        self.assertSame(image.array, written.array)
        np.testing.assert_array_equal(image.affine, written.affine)

    def test_DicomSeriesInspector(self):
        run_tool("DicomSeriesInspector", SERIES, "--json", self.folder / "series.json")
        written = json.loads((self.folder / "series.json").read_text())["series"]
        found = [
            {
                "selector": s.selector,
                "seriesInstanceUID": s.uid,
                "seriesNumber": s.number,
                "description": s.description,
                "modality": s.modality,
                "patientPosition": s.patient_position,
                "size": list(s.size),
                "spacing": list(s.spacing),
                "usable": s.is_usable,
                "refusal": s.refusal,
                "remarks": s.remarks,
            }
            for s in shapeton.list_series(SERIES)
        ]
        self.assertEqual([{name: one[name] for name in found[0]} for one in written], found)

    def table_of(self, shape, name):
        """A phantom, its labels, and the shape table written by the tool."""
        image, labels, table = (self.folder / (name + end) for end in (".nrrd", "-labels.nrrd", ".csv"))
        run_tool("ShapePhantom", image, "--shape", shape, "--size", "80,80,80", "--labels", labels)
        run_tool("ShapeSignature", image, labels, table)
        return shapeton.read_volume(image), shapeton.read_volume(labels), table

    def test_ShapeSignature(self):
        image, labels, table = self.table_of("figure3.4", "figure")
        shapes.write_shape_table(shapes.describe_shapes(image, labels), self.folder / "own.csv")
        self.assertEqual((self.folder / "own.csv").read_bytes(), table.read_bytes())

    def test_ShapeSearch(self):
        database, neighbors = self.folder / "shapes.sqlite", self.folder / "neighbors.csv"
        table = self.table_of("figure3.4", "figure")[2]
        for path in (table, self.table_of("figure2.7a", "more")[2]):
            run_tool("ShapeSearch", path, database, "--add", path.stem)
        run_tool("ShapeSearch", table, database, "--neighbors", neighbors)
        entries = shapes.read_shape_database(database)
        self.assertGreater(len(entries), 5)  # more than listed by default
        with open(neighbors, encoding="utf-8") as file:
            written = [row["name"] for row in csv.DictReader(line for line in file if not line.startswith("#"))]
        expected = [
            entries[neighbor.entry].name
            for row in shapes.read_shape_table(table).rows
            for neighbor in shapes.find_shape(row.signature, entries).neighbors
        ]
        self.assertEqual(written, expected)

    def test_GraphEmbedding(self):
        graph = graphs.complete_graph(8)
        files = [self.folder / name for name in ("graph.graphml", "certificate.json")]
        graphs.write_graph(graph, files[0])
        run_tool("GraphEmbedding", *files)
        self.assertSameCertificate(graphs.embed_graph(graphs.read_graph(files[0])), files[1])

    def test_GraphEmbeddingVerifier(self):
        certificate, verdict = self.folder / "certificate.json", self.folder / "verdict.json"
        graphs.write_certificate(graphs.embed_graph(graphs.hypercube_graph(3)), certificate)
        run_tool("GraphEmbeddingVerifier", certificate, "--statistics", verdict)
        written, found = json.loads(verdict.read_text()), graphs.verify_embedding(graphs.read_certificate(certificate))
        self.assertEqual((written["valid"], written["measures"]), (found.is_valid, found.measures))

    def test_GraphCompare(self):
        files = [self.folder / name for name in ("one.graphml", "other.graphml", "comparison")]
        graphs.write_graph(graphs.grid_graph(4, 3), files[0])
        graphs.write_graph(graphs.grid_graph(6, 2), files[1])
        run_tool("GraphCompare", *files)
        found = graphs.compare_graphs(graphs.read_graph(files[0]), graphs.read_graph(files[1]))
        self.assertSameCertificate(found.a, files[2] / "a.json")
        self.assertSameCertificate(found.b, files[2] / "b.json")

    def test_GraphCurvature(self):
        files = [self.folder / name for name in ("graph.graphml", "edges.csv", "nodes.csv")]
        graphs.write_graph(graphs.regular_tiling_graph(3, 7, 2), files[0])
        run_tool("GraphCurvature", files[0], files[1], "--nodeTable", files[2], "--idleness", "0.3")
        found = graphs.ricci_curvature(graphs.read_graph(files[0]), idleness=0.3)
        edges, nodes = ([row.split(",") for row in path.read_text().split("\n")[1:-1]] for path in files[1:])
        self.assertEqual([float(row[5]) for row in edges], found.edges.tolist())
        self.assertEqual([float(row[2]) for row in nodes], found.node_means.tolist())
        self.assertEqual([float(row[3]) for row in nodes], found.node_sums.tolist())

    def test_GraphConformalType(self):
        files = [self.folder / name for name in ("graph.graphml", "type.json", "balls.csv")]
        graphs.write_graph(graphs.regular_tiling_graph(3, 7, 5), files[0])
        run_tool("GraphConformalType", files[0], files[1], "--table", files[2])
        written, found = json.loads(files[1].read_text()), graphs.conformal_type(graphs.read_graph(files[0]))
        self.assertEqual((written["type"], tuple(written["limitRadius"])), (found.type, found.limit_radius))
        rows = [row.split(",") for row in files[2].read_text().split("\n")[1:-1]]
        self.assertEqual([float(row[4]) for row in rows], found.root_radii.tolist())
        self.assertEqual([float(row[6]) for row in rows], found.resistances.tolist())

    def assertSameCertificate(self, certificate, path):
        """Returns values as stored in files, without the sign of zero."""
        graphs.write_certificate(certificate, self.folder / "own.json")
        one, other = graphs.read_certificate(self.folder / "own.json"), graphs.read_certificate(path)
        for name in ("node_positions", "node_radii", "face_positions", "face_radii"):
            self.assertSame(getattr(one, name), getattr(other, name))
        self.assertEqual((one.rotation, one.genus), (other.rotation, other.genus))

    def test_SurfaceInspector(self):
        run_tool("SurfaceInspector", TORUS, "--json", self.folder / "torus.json")
        written = json.loads((self.folder / "torus.json").read_text())["surface"]
        found = surfaces.inspect_surface(surfaces.read_surface(TORUS))
        self.assertEqual({name: written[name] for name in found}, found)

    def test_SurfaceSpectrum(self):
        signature = self.folder / "signature.vtp"
        run_tool("SurfaceSpectrum", TORUS, self.folder / "eigenvalues.csv", "--heatKernelSignature", signature)
        spectrum = surfaces.spectrum(surfaces.read_surface(TORUS))
        written = surfaces.read_surface(signature)
        self.assertSame(written.field_arrays["eigenvalues"], spectrum.eigenvalues)
        times = spectrum.signature_times()
        self.assertEqual(list(written.field_arrays["times"]), times)
        arrays = [a for n, a in written.point_arrays.items() if n.startswith("heatKernelSignature_")]
        self.assertEqual(len(arrays), len(times))
        for values, time in zip(arrays, times):
            self.assertSame(values, spectrum.signature(time))

    def test_ColonFlattening(self):
        tube, path = cylinder(15.0, 80.0), self.folder / "tube.vtp"
        surfaces.write_surface(tube, path)
        run_tool("ColonFlattening", path, self.folder / "flat.vtp")
        flat, written = flattening.flatten_tube(tube).flat, surfaces.read_surface(self.folder / "flat.vtp")
        self.assertSame(written.vertices, flat.vertices)
        self.assertSame(written.point_arrays["uv"], flat.point_arrays["uv"])

    def test_ConformalMap(self):
        tube, path = cylinder(15.0, 80.0), self.folder / "tube.vtp"
        surfaces.write_surface(tube, path)
        run_tool("ConformalMap", path, self.folder / "flat.vtp")
        flat = flattening.conformal_map(tube).flat
        self.assertSame(surfaces.read_surface(self.folder / "flat.vtp").point_arrays["uv"], flat.point_arrays["uv"])

    def test_SurfaceRicciFlow(self):
        run_tool("SurfaceRicciFlow", TORUS, self.folder / "flat.vtp")
        flow = flattening.flow_surface(surfaces.read_surface(TORUS))
        self.assertSame(surfaces.read_surface(self.folder / "flat.vtp").point_arrays["uv"], flow.flat.point_arrays["uv"])
        self.assertLess(flow.residual, 1e-10)


if __name__ == "__main__":
    unittest.main()
