"""Each stage ends soon after a signal, measured in CPU time of the process, which hardly depends on other load."""

import os
import signal
import time
import unittest

import numpy as np

import shapeton
from shapeton import colon, flattening, graphs, surfaces

from support import TestCase, needs_tools, run_tool


def interrupt(*_):
    raise KeyboardInterrupt


class Position:
    """The wall of one position of a small synthetic patient, and derived data."""

    def __init__(self, name):
        truth = colon.colon_phantom(position=name, size=(120, 120, 112), spacing=(3.0, 3.0, 3.0), truth_only=True)
        self.lumen = truth.lumen
        self.model = colon.build_colon_of_lumen(self.lumen, faces=40000)
        self.wall, self.centerline = self.model.wall.simplified, self.model.centerline.curve
        self.flat_mesh = flattening.flatten_tube(self.wall, self.centerline, metric="euclidean").flat
        self.flat = self.new_flat()
        self.folds = colon.find_folds(self.flat)
        self.landmarks = colon.find_landmarks(self.flat, self.centerline)
        self.position = colon.ColonPosition(name, self.landmarks, self.centerline, self.folds)

    def new_flat(self):
        """Returns a FlatColon without cached grids."""
        return colon.FlatColon(self.flat_mesh)


class AbortTest(TestCase):
    @classmethod
    def setUpClass(cls):
        cls.supine, cls.prone = Position("supine"), Position("prone")
        cls.addClassCleanup(signal.signal, signal.SIGPROF, signal.signal(signal.SIGPROF, interrupt))

    def seconds(self, work):
        """CPU time of the process: minimum of three runs, because the first one fills caches."""
        times = [time.process_time()]
        for _ in range(3):
            work()
            times.append(time.process_time())
        return min(after - before for before, after in zip(times, times[1:]))

    def check_progress(self, work):
        """Checks that `work` reports increasing shares and can be aborted by its progress function."""
        shares = []
        work(progress=lambda share, stage: shares.append((share, stage)))
        self.assertEqual(shares, sorted(shares, key=lambda call: call[0]))
        self.assertTrue(all(0.0 <= share <= 1.0 and stage for share, stage in shares), shares)
        with self.assertRaises(shapeton.Aborted):
            work(progress=lambda *_: False)

    def check_short(self, work):
        """A signal at the first progress report ends `work`; for calls of a few milliseconds, too short for a
        timer."""
        self.check_progress(work)
        sent = []

        def signal_once(share, _):
            if not sent:
                sent.append(share)
                os.kill(os.getpid(), signal.SIGPROF)

        with self.assertRaises(KeyboardInterrupt):
            work(progress=signal_once)

    def check(self, name, work):
        """A signal after a quarter of `work` ends it within 0.2 s, or half of it."""
        with self.subTest(name):
            self.check_progress(work)
            whole = self.seconds(work)
            begin = time.process_time()
            with self.assertRaises(KeyboardInterrupt):
                signal.setitimer(signal.ITIMER_PROF, 0.25 * whole)
                try:
                    work()
                finally:
                    signal.setitimer(signal.ITIMER_PROF, 0)  # a late signal would end later code
            self.assertLess(time.process_time() - begin - 0.25 * whole, max(0.2, 0.5 * whole))

    def test_surfaces(self):
        wall = self.supine.wall
        self.check("spectrum", lambda **options: surfaces.spectrum(wall, 50, **options))
        self.check("metric", lambda **options: surfaces.heat_diffusion_metric(wall, **options))
        self.check("truncated metric", lambda **options: surfaces.heat_diffusion_metric(wall, eigenpairs=50, **options))

    def test_heat_over_a_surface(self):
        heat = np.random.default_rng(1).random((len(self.supine.wall.vertices), 40))
        self.check("heat", lambda **options: surfaces.diffuse_over_surface(self.supine.wall, heat, 10.0, **options))

    def test_conformal_maps(self):
        wall, line = self.supine.wall, self.supine.centerline
        self.check("flatten_tube", lambda **options: flattening.flatten_tube(wall, line, **options))
        for domain in ("rectangle", "slit"):
            self.check(domain, lambda **options: flattening.conformal_map(wall, domain=domain, **options))

    def test_folds_and_landmarks(self):
        supine = self.supine
        self.check("folds", lambda **options: colon.find_folds(supine.new_flat(), **options))
        self.check("landmarks", lambda **options: colon.find_landmarks(supine.new_flat(), supine.centerline, **options))
        self.check("pieces", lambda **options: colon.split_colon(supine.landmarks, **options))

    def test_candidates(self):
        wall = self.supine.model.wall.repaired
        self.check("candidates", lambda **options: colon.find_candidates(wall, self.supine.lumen, **options))

    def test_registration(self):
        supine, prone = self.supine.position, self.prone.position
        for method in ("default", "published"):
            self.check(method, lambda **options: colon.register_positions(supine, prone, map=method, **options))

    def test_graphs(self):
        torus, rotation = graphs.torus_grid(160, 160, True)
        grid, other = graphs.grid_graph(60, 60), graphs.grid_graph(90, 40)
        self.check("torus", lambda **options: graphs.embed_graph(torus, rotation=rotation, **options))
        self.check("sphere", lambda **options: graphs.embed_graph(graphs.grid_graph(120, 120), **options))
        self.check("search", lambda **options: graphs.embed_graph(graphs.complete_graph(20), **options))
        self.check("comparison", lambda **options: graphs.compare_graphs(grid, other, **options))

    def test_stages_of_a_ct(self):
        phantom = colon.colon_phantom(position="supine", size=(256, 256, 240), spacing=(1.4, 1.4, 1.4))
        lumen = colon.segment_lumen(phantom.ct)
        occupancy, line = colon.cleanse(phantom.ct, lumen).occupancy, colon.trace_centerline(lumen.labels).curve
        wall = colon.build_wall(occupancy, line).repaired
        small = {"size": (128, 128, 120), "spacing": (2.8, 2.8, 2.8)}
        self.check("phantom", lambda **options: colon.colon_phantom(**small, **options))
        self.check("lumen", lambda **options: colon.segment_lumen(phantom.ct, **options))
        self.check("cleansing", lambda **options: colon.cleanse(phantom.ct, lumen, **options))
        self.check("centerline", lambda **options: colon.trace_centerline(lumen.labels, **options))
        self.check("wall", lambda **options: colon.build_wall(occupancy, line, **options))
        self.check("simplification", lambda **options: surfaces.simplify_surface(wall, faces=20000, **options))
        self.check("remeshing", lambda **options: surfaces.remesh_surface(wall, 2.0, **options))

    @needs_tools
    def test_reading(self):
        folder = str(self.folder / "series")
        run_tool("ColonPhantom", folder, "--size", "256,256,160", "--spacing", "1.4,1.4,2.1")
        with self.subTest("list"):
            self.check_short(lambda **options: shapeton.list_series(folder, **options))
        self.check("read", lambda **options: shapeton.read_volume(folder, **options))


if __name__ == "__main__":
    unittest.main()
