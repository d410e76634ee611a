import _thread
import os
import shutil
import signal
import threading
import time
import unittest
from concurrent.futures import ThreadPoolExecutor

import numpy as np

import shapeton
from shapeton import shapes

from support import TestCase, balls, needs_tools, run_python, run_tool


class HeatTest(TestCase):
    def test_a_cube_converges_to_its_cut_faces(self):
        # 2.3.4: the heat of a closed binary object is (cut faces) / (6 voxels): 1 / side of a cube.
        for side in (4, 6):
            voxels = np.zeros((24, 24, 24), np.float32)
            voxels[8 : 8 + side, 8 : 8 + side, 8 : 8 + side] = 1.0
            result = shapeton.diffuse_heat(shapeton.Image(voxels), preset="published", time_steps=20000, components=True)
            self.assertAlmostEqual(float(result.heat.array[9, 9, 9]), 1.0 / side, delta=1e-5)
            (cube,) = [c for c in result.components if c.closed]
            self.assertEqual((cube.voxels, cube.index), (side**3, (8, 8, 8)))
            self.assertAlmostEqual(cube.converged_heat, 1.0 / side, delta=1e-6)

    def test_parameters_that_are_not_given_are_chosen(self):
        image = balls()
        chosen = shapeton.diffuse_heat(image, components=True)
        self.assertEqual(set(chosen.reasons), {"intensity_window", "p", "smoothing", "time_steps"})
        self.assertTrue(all(chosen.reasons.values()))
        self.assertTrue(all(0 <= c.coherence <= 1 for c in chosen.classes))
        again = shapeton.diffuse_heat(image, p=chosen.p, intensity_window=chosen.window, smoothing=chosen.smoothing,
                                      time_steps=chosen.time_step)  # fmt: skip
        self.assertSame(again.heat.array, chosen.heat.array)
        self.assertEqual(again.reasons["p"], "")
        published = shapeton.diffuse_heat(image, preset="published", time_steps=10)
        self.assertEqual((published.p, published.smoothing), (7.0, 0.0))

    def test_the_histogram_counts_each_voxel_once_in_each_row(self):
        steps = shapeton.recorded_steps(500, 12)
        result = shapeton.diffuse_heat(balls(), preset="published", time_steps=500, histogram_steps=steps)
        self.assertEqual(result.histogram.time_steps, steps)
        np.testing.assert_array_equal(result.histogram.counts.sum(axis=1), result.heat.array.size)
        last, _ = np.histogram(result.heat.array, np.append(result.histogram.edges[:-1], 2.0))
        np.testing.assert_array_equal(result.histogram.counts[-1], last)
        self.assertSame(shapeton.heat_histogram([result.heat], [500]).counts[0], result.histogram.counts[-1])
        for call, name in (
            (lambda: shapeton.heat_histogram([result.heat], [-1]), "time_steps"),
            (lambda: shapeton.diffuse_heat(balls(), histogram_steps=[-1]), "histogram_steps"),
            (lambda: shapeton.diffuse_heat(balls(), snapshot_steps=[-1]), "snapshot_steps"),
            (lambda: shapeton.diffuse_shapetons(balls(), histogram_steps=[-1]), "histogram_steps"),
            (lambda: shapeton.recorded_steps(-1, 12), "time_steps"),
        ):
            with self.assertRaisesRegex(shapeton.ParameterError, f'"{name}": -1 is out of range'):
                call()
        with self.assertRaisesRegex(shapeton.ParameterError, '"time_steps" must be ascending'):
            shapeton.heat_histogram([result.heat, result.heat], [500, 12])

    def test_classes_divide_the_heat_at_their_bounds(self):
        heat = shapeton.diffuse_heat(balls(), preset="published", time_steps=2000).heat
        labels, classes = shapeton.classify_heat(heat)
        self.assertEqual([c.label for c in classes], list(range(len(classes))))
        for c in classes:
            inside = (heat.array >= c.lower_heat) & (heat.array < c.upper_heat)
            self.assertEqual(np.count_nonzero(labels.array == c.label), c.voxels)
            self.assertGreater(np.count_nonzero(inside & (labels.array == c.label)), 0.999 * c.voxels)
            self.assertAlmostEqual(c.volume, c.voxels * np.prod(heat.spacing), delta=1e-6 * c.volume + 1e-9)

    def test_objects_are_the_balls_of_a_volume(self):
        z, y, x = np.ogrid[:32, :36, :44]
        balls_of = [(z - 16) ** 2 + (y - 16) ** 2 + (x - 12) ** 2 < 81, (z - 14) ** 2 + (y - 18) ** 2 + (x - 32) ** 2 < 49]
        voxels = np.random.default_rng(1).normal(0.0, 20.0, (32, 36, 44)) + 500.0 * (balls_of[0] | balls_of[1])
        image = shapeton.Image(voxels.astype(np.float32), (0.8, 0.9, 1.5), (-10.0, 20.0, 5.0))
        heat = shapeton.diffuse_heat(image, intensity_window=(0.0, 500.0), p=4.0, time_steps=1000).heat
        found = shapeton.find_objects(heat)
        self.assertEqual(len(found.objects), 2)
        for number, (one, ball) in enumerate(zip(found.objects, balls_of), start=1):
            inside = found.mask(number).array == 1
            self.assertGreater(2.0 * np.count_nonzero(inside & ball) / (np.count_nonzero(ball) + one.voxels), 0.97)  # Dice
            np.testing.assert_array_equal(inside, found.labels.array == number)  # no object is in another one
            self.assertEqual((one.parent, one.voxels, one.cut), (0, np.count_nonzero(inside), 0.0))
            self.assertAlmostEqual(one.volume, one.voxels * 0.8 * 0.9 * 1.5, delta=1e-9 * one.volume)
            self.assertAlmostEqual(one.mean_heat, heat.array[inside].mean(dtype=np.float64), delta=1e-9)
            center = np.argwhere(inside).mean(axis=0)[::-1] * image.spacing + image.origin
            np.testing.assert_allclose(one.center, center, atol=1e-9)
            self.assertTrue(0.2 <= one.probability <= 1.0)
        self.assertEqual(len(shapeton.find_objects(heat, least_voxels=2000).objects), 1)

    def test_classes_of_a_result_are_measured(self):
        result = shapeton.diffuse_heat(balls(), time_steps=1000, components=True)
        labels, _ = shapeton.classify_heat(result.heat, result.components)
        for one in result.classes:
            self.assertEqual(one.voxels, np.count_nonzero(labels.array == one.label))
            self.assertAlmostEqual(one.volume, one.voxels * np.prod(result.heat.spacing), delta=1e-6 * one.volume)
            self.assertIsNotNone(one.coherence)

    def test_a_mask_may_be_rounded_and_another_grid_is_refused(self):
        image = balls()
        inside = (image.array > 0.0).astype(np.uint8)
        rounded = shapeton.Image(inside, image.spacing, np.add(image.origin, 1e-4), image.direction)
        expected = shapeton.diffuse_heat(image, domain=image.like(inside), time_steps=10).heat.array
        self.assertSame(shapeton.diffuse_heat(image, domain=rounded, time_steps=10).heat.array, expected)
        moved = shapeton.Image(inside, image.spacing, np.add(image.origin, 1.0), image.direction)
        for call in (
            lambda: shapeton.diffuse_heat(image, domain=moved),
            lambda: shapeton.diffuse_shapetons(image, mask=moved),
            lambda: shapes.SeededHeat(image).segment(moved),
        ):
            with self.assertRaisesRegex(shapeton.InputError, "another grid than the volume|grids of the seeds and of the image differ"):
                call()
        one = 0 * inside
        one[20, 18, 16] = 1
        self.assertFalse(shapeton.diffuse_heat(image, domain=image.like(one)).heat.array[one == 0].any())
        for options in ({}, {"preset": "published"}):
            with self.assertRaisesRegex(shapeton.InputError, "no voxel"):
                shapeton.diffuse_heat(image, domain=image.like(0 * inside), **options)

    def test_snapshots_and_their_steps_require_each_other(self):
        for options in ({"snapshot_steps": [1]}, {"snapshot": print}):
            with self.assertRaisesRegex(shapeton.ParameterError, "require each other"):
                shapeton.diffuse_heat(balls(), **options)

    def test_wrong_objects_and_heats_are_rejected(self):
        image = balls()
        heat = shapeton.diffuse_heat(image, time_steps=1000).heat
        self.assertEqual(shapeton.find_objects(heat).warnings, [])
        found = shapeton.find_objects(heat, least_probability=0.1)
        most = len(found.objects)
        for number in (0, most + 1):
            with self.assertRaisesRegex(shapeton.ParameterError, f"object {number} is not in the list of {most} objects"):
                found.mask(number)
        with self.assertRaisesRegex(shapeton.InputError, "finite values above 0"):
            shapeton.find_objects(heat.like(np.zeros_like(heat.array)))
        with self.assertRaisesRegex(shapeton.ParameterError, "leastProbability|least_probability"):
            shapeton.find_objects(heat, least_probability=2.0)
        with self.assertRaisesRegex(shapeton.InputError, "no negative values"):
            shapeton.find_objects(image)
        with self.assertRaisesRegex(shapeton.InputError, "not in .0, 1."):
            shapeton.classify_heat(image)
        with self.assertRaisesRegex(shapeton.InputError, "grids of the heat images 0 and 1 differ"):
            shapeton.heat_histogram([heat, shapeton.Image(heat.array)], [1, 2])
        with self.assertRaisesRegex(TypeError, "has no argument \"mask\"; did you mean \"domain\""):
            shapeton.diffuse_heat(image, mask=heat)

    def test_rules_of_classes_are_checked(self):
        heat = shapeton.diffuse_heat(balls((8, 8, 8)), preset="published", time_steps=10).heat
        for name, wrong in (
            ("background_heat", -1.0),
            ("minimum_share", 2.0),
            ("minimum_share", -1.0),
            ("minimum_peak_to_valley", float("nan")),
            ("maximum_classes", 0),
            ("maximum_classes", 255),
        ):
            with self.assertRaisesRegex(shapeton.ParameterError, name):
                shapeton.classify_heat(heat, **{name: wrong})

    def test_snapshots_are_the_heat_of_shorter_runs(self):
        image, seen = balls((12, 14, 16)), {}
        shapeton.diffuse_heat(
            image, preset="published", time_steps=80, solver="explicit", snapshot_steps=[0, 40], snapshot=lambda n, h: seen.update({n: h})
        )
        self.assertEqual(sorted(seen), [0, 40])
        self.assertSame(seen[40].array, shapeton.diffuse_heat(image, preset="published", time_steps=40, solver="explicit").heat.array)
        initial = shapeton.diffuse_heat(image, preset="published", time_steps=1, initial_heat=True).initial_heat
        self.assertSame(seen[0].array, initial.array)

    def test_wrong_parameters_are_value_errors_that_name_them(self):
        image = balls((8, 8, 8))
        for words, wrong in (
            ('"p": -1 is less than the minimum 0', {"p": -1.0}),
            ('"time_steps": 0 is less than the minimum 1', {"time_steps": 0}),
            ('"intensity_window" requires two numbers, the lower one first', {"intensity_window": (3.0, 1.0)}),
            ('"tolerance": 2 is more than the maximum 1', {"tolerance": 2.0}),
            ('"time_step_length": 0.2 is more than the maximum 1/12', {"time_step_length": 0.2}),
            ("histogram steps must be ascending", {"histogram_steps": [5, 3]}),
            ('"solver": "fast" is not one of chebyshev, explicit', {"solver": "fast"}),
            ('"conductance": "" is not one of physical, published, sum', {"conductance": ""}),
        ):
            with self.assertRaisesRegex(ValueError, words) as caught:
                shapeton.diffuse_heat(image, **wrong)
            self.assertIsInstance(caught.exception, shapeton.ParameterError)
            self.assertNotIn("\n", str(caught.exception))


class ShapetonsTest(TestCase):
    def test_each_step_of_each_shapeton_is_a_visit(self):
        result = shapeton.diffuse_shapetons(balls(), shapetons=3000, time_steps=50)
        self.assertEqual(int(result.visits.array.sum(dtype=np.int64)), 150000)
        self.assertEqual((result.time_step, result.shapetons), (50, 3000))
        density = result.density.array
        np.testing.assert_allclose(density, result.visits.array / result.visits.array.max(), rtol=1e-6)
        self.assertSame(density, shapeton.visit_density(result.visits).array)
        labels, classes = shapeton.classify_visits(result.visits)
        self.assertEqual(sum(c.voxels for c in classes), labels.array.size)

    def test_shapetons_start_in_the_mask_and_cannot_leave_a_box(self):
        voxels = np.zeros((20, 20, 20), np.float32)
        voxels[5:15, 5:15, 5:15] = 1.0
        image = shapeton.Image(voxels)
        result = shapeton.diffuse_shapetons(
            image, mask=image.like(voxels > 0), shapetons=2000, time_steps=60, distance=0.05, path_rule="traversal"
        )
        self.assertEqual(result.visits.array[voxels == 0].sum(), 0)
        with self.assertRaisesRegex(shapeton.InputError, "mask"):
            shapeton.diffuse_shapetons(image, mask=image.like(np.zeros((20, 20, 20), bool)))
        with self.assertRaisesRegex(shapeton.ParameterError, "do not combine it with \"distance\""):
            shapeton.diffuse_shapetons(image, distance=0.05, feature_size=5.0)


class ThreadsTest(TestCase):
    def setUp(self):
        super().setUp()
        self.addCleanup(shapeton.set_threads, shapeton.threads())

    def test_any_number_of_threads_gives_the_same_bytes(self):
        image, heats, visits = balls(), [], []
        for number in (1, 2, 5):
            shapeton.set_threads(number)
            self.assertEqual(shapeton.threads(), number)
            heats.append(shapeton.diffuse_heat(image, preset="published", time_steps=300).heat.array)
            visits.append(shapeton.diffuse_shapetons(image, shapetons=2000, time_steps=30).visits.array)
        for other in (1, 2):
            self.assertSame(heats[other], heats[0])
            self.assertSame(visits[other], visits[0])

    def test_zero_threads_are_all_cores(self):
        before = shapeton.threads()
        shapeton.set_threads(1)
        shapeton.set_threads(0)
        self.assertEqual(shapeton.threads(), before)
        for number in (-1, 129, 5000):
            with self.assertRaises(shapeton.ParameterError):
                shapeton.set_threads(number)

    @unittest.skipIf(shutil.which("nvidia-smi"), "a GPU may be present")
    def test_a_missing_gpu_is_an_error_of_shapeton(self):
        with self.assertRaises(shapeton.DeviceError):
            shapeton.diffuse_heat(balls(), device="cuda", preset="published", time_steps=10)

    def test_calls_from_several_threads_of_python_give_the_same_bytes(self):
        image = balls()
        expected = shapeton.diffuse_heat(image, preset="published", time_steps=300).heat.array
        with ThreadPoolExecutor(4) as pool:
            for result in pool.map(lambda _: shapeton.diffuse_heat(image, preset="published", time_steps=300), range(8)):
                self.assertSame(result.heat.array, expected)

    def test_other_threads_of_python_run_meanwhile(self):
        ticks, done = [], threading.Event()

        def tick():
            while not done.wait(0.001):
                ticks.append(None)

        thread = threading.Thread(target=tick)
        thread.start()
        before = []
        shapeton.diffuse_heat(balls((64, 64, 64)), preset="published", time_steps=3000, progress=lambda *_: before.append(len(ticks)))
        done.set()
        thread.join()
        self.assertGreater(len(ticks), before[0] + 5)


class AbortTest(TestCase):
    """A run that would take hours is aborted; objects can be used afterwards."""

    def setUp(self):
        super().setUp()
        self.image = balls((48, 48, 48))

    def run_for_hours(self, progress=None):
        shapeton.diffuse_heat(self.image, preset="published", time_steps=10**9, solver="explicit", progress=progress)

    def tearDown(self):
        result = shapeton.diffuse_heat(self.image, preset="published", time_steps=10)
        self.assertEqual(result.time_step, 10)

    def test_progress_ascends_and_names_the_stage(self):
        calls = []
        shapeton.diffuse_heat(self.image, preset="published", time_steps=3000, progress=lambda share, stage: calls.append((share, stage)))
        shares = [share for share, _ in calls]
        self.assertEqual(shares, sorted(shares))
        self.assertTrue(0.0 <= shares[0] and shares[-1] <= 1.0)
        self.assertEqual({stage for _, stage in calls}, {"Diffusing heat"})

    def test_false_aborts_at_once(self):
        calls = []

        def progress(share, stage):
            calls.append(share)
            return len(calls) < 3

        with self.assertRaisesRegex(RuntimeError, "progress function returned False") as caught:
            self.run_for_hours(progress)
        self.assertIsInstance(caught.exception, shapeton.Aborted)
        self.assertEqual(len(calls), 3)

    def test_false_of_numpy_aborts(self):
        with self.assertRaises(shapeton.Aborted):
            self.run_for_hours(lambda *_: np.False_)

    def test_none_and_zero_do_not_abort(self):
        for answer in (None, 0, "", []):
            shapeton.diffuse_heat(self.image, preset="published", time_steps=100, progress=lambda *_, answer=answer: answer)

    def test_an_exception_of_progress_comes_out_as_it_is(self):
        def progress(share, stage):
            raise KeyError("mine")

        with self.assertRaisesRegex(KeyError, "mine"):
            self.run_for_hours(progress)

    def test_a_signal_stops_a_run(self):
        signal.signal(signal.SIGINT, signal.default_int_handler)
        threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            self.run_for_hours()

    def test_a_signal_stops_shapetons(self):
        signal.signal(signal.SIGINT, signal.default_int_handler)
        threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            shapeton.diffuse_shapetons(self.image, time_steps=10**9)

    def test_interrupt_main_of_another_thread_stops_a_run(self):
        signal.signal(signal.SIGINT, signal.default_int_handler)
        threading.Timer(0.5, _thread.interrupt_main).start()
        with self.assertRaises(KeyboardInterrupt):
            self.run_for_hours()

    def test_a_run_in_another_thread_is_aborted_by_its_progress(self):
        stop, caught = threading.Event(), []

        def work():
            try:
                self.run_for_hours(lambda *_: not stop.is_set())
            except shapeton.Aborted as error:
                caught.append(error)

        thread = threading.Thread(target=work)
        thread.start()
        time.sleep(0.3)
        stop.set()
        thread.join(60.0)
        self.assertEqual(len(caught), 1)


LEAKS = """
import numpy as np, shapeton
def resident():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * 4096
image = shapeton.Image(np.random.default_rng(1).normal(size=(24, 24, 24)))
corners = [[0, 0, 0], [9, 0, 0], [0, 9, 0], [0, 0, 9]]
mesh = shapeton.Mesh(corners, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]], {"a": [1, 2, 3, 4]})
from shapeton import surfaces, graphs
def everything():
    progress = lambda *_: None
    result = shapeton.diffuse_heat(image, preset="published", time_steps=3, histogram_steps=[0, 3], components=True, progress=progress)
    shapeton.classify_heat(result.heat, result.components)
    result.histogram.counts
    surfaces.repair_surface(mesh)[0].point_arrays
    surfaces.inspect_surface(mesh)
    graphs.embed_graph(graphs.complete_graph(4)).node_positions
    for wrong in (lambda: shapeton.diffuse_heat(image, p=-1), lambda: shapeton.read_volume("there is none"),
                  lambda: shapeton.diffuse_heat(image, preset="published", time_steps=3, progress=lambda *_: False)):
        try:
            wrong()
        except (ValueError, RuntimeError):
            pass
for _ in range(200):
    everything()
growth = []
for _ in range(3):
    before = resident()
    for _ in range(1000):
        everything()
    growth.append(resident() - before)
print(min(growth))  # a leak makes it grow each time, the allocator does not
"""


class LeakTest(TestCase):
    def test_a_thousand_calls_leave_nothing_behind(self):
        # A heat image has 55 kB; leaking one per call would be 55 MB.
        self.assertLess(int(run_python(LEAKS)), 4_000_000)


@needs_tools
class SameAsToolsTest(TestCase):
    def setUp(self):
        super().setUp()
        self.image = balls()
        self.volume = self.folder / "volume.nrrd"
        shapeton.write_volume(self.image, str(self.volume))

    def read(self, name):
        return shapeton.read_volume(str(self.folder / name)).array

    def test_heat_and_labels(self):
        heat, labels = self.folder / "heat.nrrd", self.folder / "labels.nrrd"
        options = ["--timeSteps", 700, "--p", 5, "--intensityWindow=-50,600", "--timeStepLength", 0.08]
        run_tool("CumulativeHeatDiffusion", self.volume, heat, *options, "--labels", labels)
        result = shapeton.diffuse_heat(
            self.image, time_steps=700, p=5.0, intensity_window=(-50.0, 600.0), time_step_length=0.08, components=True
        )
        self.assertSame(result.heat.array, self.read("heat.nrrd"))
        found, _ = shapeton.classify_heat(result.heat, result.components)
        self.assertSame(found.array.astype(np.float32), self.read("labels.nrrd"))

    def test_shapetons(self):
        options = ["--timeSteps", 60, "--shapetons", 4000, "--seed", 7, "--pathRule", "traversal"]
        run_tool("ShapetonDiffusion", self.volume, self.folder / "visits.nrrd", *options)
        result = shapeton.diffuse_shapetons(self.image, time_steps=60, shapetons=4000, seed=7, path_rule="traversal")
        self.assertSame(result.visits.array.astype(np.float32), self.read("visits.nrrd"))


if __name__ == "__main__":
    unittest.main()
