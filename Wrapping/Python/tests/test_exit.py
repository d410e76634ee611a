"""Objects of each class may exist until interpreter shutdown, without delaying it."""

import inspect
import unittest

import shapeton
from shapeton import _shapeton

from support import DATA, TestCase, run_python

#: Programs with objects in globals; together they use all classes.
PROGRAMS = {
    "heat": (
        """
image = shapeton.Image(numpy.random.default_rng(1).random((12, 14, 16), dtype=numpy.float32))
heat = shapeton.diffuse_heat(image, time_steps=20, histogram_steps=[0, 20], components=True, progress=lambda *_: None)
histogram, component = heat.histogram, heat.components[0]
labels, (heat_class, *_) = shapeton.classify_heat(heat.heat)
walk = shapeton.diffuse_shapetons(image, shapetons=100, time_steps=5)
objects = shapeton.find_objects(heat.heat, least_probability=0.0, least_voxels=8)
heat_object = objects.objects[0]
""",
        "Image HeatResult HeatHistogram HeatClass HeatObjects HeatObject ShapeComponent ShapetonResult",
    ),
    "series": (
        """
import glob, os, shutil, tempfile
with tempfile.TemporaryDirectory() as folder:
    for path in sorted(glob.glob(os.path.join(DATA, "PhantomSeries", "*.dcm")))[::2]:
        shutil.copy(path, folder)
    os.remove(sorted(glob.glob(os.path.join(folder, "*.dcm")))[4])
    (series,) = shapeton.list_series(folder)
    defect = series.defects[0]
""",
        "DicomSeries DicomDefect",
    ),
    "examination": (
        """
import tempfile
with tempfile.TemporaryDirectory() as folder:
    exam = shapeton.Examination(folder)
""",
        "Examination",
    ),
    "errors": (
        """
def error_of(call, *arguments, **options):
    try:
        call(*arguments, **options)
    except shapeton.Error as error:
        return error
image = shapeton.Image(numpy.ones((3, 3, 3), dtype=numpy.float32))
parameter_error = error_of(shapeton.diffuse_heat, image, p=-1.0)
input_error = error_of(shapeton.read_volume, numpy.__file__)
missing_file_error = error_of(shapeton.read_volume, "there is none")
output_error = error_of(shapeton.write_volume, image, "/there/is/none.nrrd")
aborted = error_of(shapeton.diffuse_heat, image, time_steps=1000, progress=lambda *_: False)
error, device_error = shapeton.Error("mine"), shapeton.DeviceError("mine")
""",
        "Error ParameterError InputError MissingFileError OutputError DeviceError Aborted",
    ),
    "shapes": (
        """
from shapeton import shapes
z, y, x = numpy.ogrid[:24, :24, :24]
ball = shapeton.Image(((z - 12) ** 2 + (y - 12) ** 2 + (x - 12) ** 2 < 64).astype(numpy.uint8))
seeds = numpy.zeros((24, 24, 24), dtype=numpy.uint16)
seeds[0, 0, 0], seeds[12, 12, 12] = 1, 2
heat = shapes.SeededHeat(ball.like(ball.array.astype(numpy.float32)))
seeded = heat.segment(ball.like(seeds))
table = shapes.describe_shapes(ball, ball)
row, signature = table.rows[0], table.rows[0].signature
shape = shapes.NamedShape("ball", signature)
found = shapes.find_shape(signature, [shape])
neighbor = found.neighbors[0]
""",
        "SeededHeat SeededLabels ShapeTable ShapeRow ShapeSignature NamedShape ShapeSearchResult ShapeNeighbor",
    ),
    "graphs": (
        """
from shapeton import graphs
graph = graphs.complete_graph(5)
certificate = graphs.embed_graph(graph)
verdict = graphs.verify_embedding(certificate)
comparison = graphs.compare_graphs(graph, graphs.complete_bipartite_graph(3, 3))
curvature = graphs.ricci_curvature(graph)
conformal = graphs.conformal_type(graphs.regular_tiling_graph(3, 7, 2))
""",
        "Graph EmbeddingCertificate EmbeddingVerdict GraphComparison GraphCurvature ConformalTypeResult",
    ),
    "surfaces": (
        """
import os
from shapeton import flattening, surfaces
tube = surfaces.read_surface(os.path.join(DATA, "../Applications/ColonFlattening/Testing/Tube.off"))
spectrum, metric = surfaces.spectrum(tube, 10), surfaces.heat_diffusion_metric(tube)
flow = flattening.flow_surface(tube)
conformal = flattening.conformal_map(tube, domain="annulus")
flat = flattening.flatten_tube(tube, metric="euclidean", topology="denoised")
handle = flat.handles[0]
""",
        "Mesh SurfaceRicciFlow SurfaceSpectrum HeatDiffusionMetric ConformalMap ColonFlattening SurfaceHandle",
    ),
    "colon": (
        """
from shapeton import colon, flattening
class Examination:
    def __init__(self, name):
        self.phantom = colon.colon_phantom(position=name, size=(120, 120, 112), spacing=(3.0, 3.0, 3.0))
        self.model = colon.build_colon_of_lumen(self.phantom.lumen, faces=20000)
        wall, line = self.model.wall.simplified, self.model.centerline.curve
        self.flat = colon.FlatColon(flattening.flatten_tube(wall, line, metric="euclidean").flat)
        self.folds = colon.find_folds(self.flat)
        self.landmarks = colon.find_landmarks(self.flat, line)
        self.position = colon.ColonPosition(name, self.landmarks, line, self.folds)
        self.candidates = colon.find_candidates(self.model.wall.repaired, self.phantom.lumen, centerline=line)
supine, prone = Examination("supine"), Examination("prone")
phantom, model, flat, landmarks = supine.phantom, supine.model, supine.flat, supine.landmarks
centerline, wall, folds, position = model.centerline, model.wall, supine.folds, supine.position
line, distension, fold, flexure = centerline.curve, model.distension, folds.folds[0], landmarks.flexures[0]
piece = colon.split_colon(landmarks)[0][0]
lumen = colon.segment_lumen(phantom.ct)
thresholds, cleansed = lumen.thresholds, colon.cleanse(phantom.ct, lumen)
valve = colon.find_valve(phantom.lumen, line)[0]
registration = colon.register_positions(position, prone.position)
match = registration.matches[0]
candidate = colon.find_in_other_position(registration.supine_to_prone, supine.candidates, prone.candidates)[0]
other = candidate.other
collapsed = phantom.lumen.array.copy()
z, y, x = numpy.rint(phantom.lumen.index(line.points()[len(line.vertices) // 2])).astype(int)
collapsed[z - 8 : z + 9, y - 8 : y + 9, x - 8 : x + 9] = 0
gap = colon.trace_centerline(phantom.lumen.like(collapsed)).gaps[0]
""",
        "ColonPhantom ColonModel ColonCenterline ColonWall Curves ColonDistension CenterlineGap FlatColon HaustralFolds "
        "HaustralFold ColonLandmarks ColonFlexure ColonPiece ColonPosition ColonLumen ColonThresholds CleansedColon "
        "IleocecalValve Registration MatchedFolds PolypCandidate PolypInOtherPosition",
    ),
}

KEEP = "import numpy, shapeton\nDATA = {data!r}\n{program}\nprint(*sorted({{type(v).__name__ for v in [*globals().values()]}}))"

#: A SeededHeat refers to the array of its image.
HEAT = """
import atexit, builtins, os, sys, threading, time, types
import numpy, shapeton
from shapeton import shapes
image = shapeton.Image(numpy.random.default_rng(1).random((40, 40, 40), dtype=numpy.float32))
seeds = numpy.zeros((40, 40, 40), dtype=numpy.uint16)
seeds[0, 0, 0], seeds[20, 20, 20] = 1, 2
def new_heat():
    heat = shapes.SeededHeat(image)
    heat.segment(image.like(seeds), progress=lambda *_: None)
    return heat
"""


def run_to_the_end(code):
    """Returns the output of a program, which must exit soon with status 0 and without other output."""
    return run_python(code, timeout=600, PYTHONFAULTHANDLER="1", PYTHONMALLOC="debug")


class ExitTest(TestCase):
    def test_each_class_of_the_package_is_kept_by_a_program(self):
        classes = {name for name, kind in vars(_shapeton).items() if inspect.isclass(kind) and not name.startswith("_")}
        classes |= {name for name in shapeton.__all__ if inspect.isclass(getattr(shapeton, name))}
        kept = {name for _, names in PROGRAMS.values() for name in names.split()}
        self.assertEqual(classes - kept, set(), "add them to PROGRAMS")

    def test_a_program_that_keeps_objects_ends(self):
        for name, (program, classes) in PROGRAMS.items():
            with self.subTest(name):
                kept = run_to_the_end(KEEP.format(data=str(DATA.absolute()), program=program)).split()
                self.assertLessEqual(set(classes.split()), set(kept))

    def test_objects_may_be_kept_anywhere(self):
        for keep in (
            "sys.modules['keeper'] = types.ModuleType('keeper'); sys.modules['keeper'].heat = new_heat()",
            "builtins.heat = new_heat()",
            "shapeton.heat = numpy.heat = new_heat()",
            "cycle = [new_heat()]; cycle.append(cycle)",
            "atexit.register(lambda heat: None, new_heat())",
            "threading.Thread(target=lambda heat: time.sleep(600), args=[new_heat()], daemon=True).start()",
        ):
            with self.subTest(keep):
                self.assertEqual(run_to_the_end(HEAT + keep + "\nprint('done')"), "done")

    def test_a_thread_may_compute_with_an_object_of_the_main_thread(self):
        code = """
heat = new_heat()
def work():
    while True:
        heat.segment(image.like(seeds), progress=lambda *_: None)
threading.Thread(target=work, daemon=True).start()
time.sleep(0.5)
print("done")
"""
        self.assertEqual(run_to_the_end(HEAT + code), "done")

    def test_the_package_works_while_the_interpreter_ends(self):
        code = """
from shapeton import graphs
class Late:
    def __init__(self):
        self.heat, self.seeds, self.write = new_heat(), image.like(seeds), os.write
        self.graph, self.embed, self.verify = graphs.complete_graph(7), graphs.embed_graph, graphs.verify_embedding

    def __del__(self):
        reports = []
        certificate = self.embed(self.graph, progress=lambda share, _: reports.append(share))
        self.write(1, b"embedded " if reports[-1] == 1.0 and self.verify(certificate).is_valid else b"wrong")
        try:
            self.heat.segment(self.seeds)
        except ImportError:  # of shapeton.image, for the result: Python imports nothing any more
            self.write(1, b"refused")

late = Late()
"""
        self.assertEqual(run_to_the_end(HEAT + code), "embedded refused")

    def test_a_forked_process_ends_with_objects_of_its_parent(self):
        code = """
heat = new_heat()
child = os.fork()
if child == 0:
    other = shapes.SeededHeat(image)
    sys.exit(7)
print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
"""
        self.assertEqual(run_to_the_end(HEAT + code), "7")


if __name__ == "__main__":
    unittest.main()
