"""Calls run in separate threads; the main thread stops waiting for them when interrupted."""

import gc
import os
import pickle
import signal
import threading
import unittest
import weakref

import numpy as np

import shapeton
from shapeton import graphs, surfaces

from support import TestCase


def helpers():
    return [thread for thread in threading.enumerate() if thread is not threading.main_thread()]


def join_helpers():
    for thread in helpers():
        thread.join()


class CallsTest(TestCase):
    def setUp(self):
        super().setUp()
        self.image = shapeton.Image(np.random.default_rng(1).random((24, 24, 24), dtype=np.float32))

    def test_what_cannot_be_stopped_is_let_go(self):
        for name, read in (("graph.json", graphs.read_graph), ("surface.vtp", surfaces.read_surface)):
            with self.subTest(name):
                pipe = self.folder / name
                os.mkfifo(pipe)  # opening it waits for a writer
                signal.signal(signal.SIGALRM, signal.default_int_handler)
                signal.setitimer(signal.ITIMER_REAL, 0.2)
                with self.assertRaises(KeyboardInterrupt):
                    read(pipe)
                self.assertEqual(len(helpers()), 1)
                os.close(os.open(pipe, os.O_WRONLY))
                join_helpers()

    def test_what_can_be_stopped_ends(self):
        signal.signal(signal.SIGALRM, signal.default_int_handler)
        signal.setitimer(signal.ITIMER_REAL, 0.2)
        with self.assertRaises(KeyboardInterrupt):
            shapeton.diffuse_heat(self.image, preset="published", time_steps=10**9)
        join_helpers()  # would wait forever otherwise

    def test_callbacks_run_in_the_thread_that_calls(self):
        threads = []

        def note(*_):
            threads.append(threading.current_thread())

        shapeton.diffuse_heat(self.image, preset="published", time_steps=100, progress=note, snapshot_steps=[50], snapshot=note)
        self.assertEqual(set(threads), {threading.main_thread()})

    def test_an_exception_of_a_callback_ends_the_thread(self):
        def fail(*_):
            raise KeyError("mine")

        for callbacks in ({"progress": fail}, {"snapshot_steps": [1, 10**9], "snapshot": fail}):
            with self.assertRaisesRegex(KeyError, "mine"):
                shapeton.diffuse_heat(self.image, preset="published", time_steps=10**9, **callbacks)
            join_helpers()

    def test_a_callback_may_call(self):
        results = []

        def classify(step, heat):
            results.append(shapeton.diffuse_heat(heat, preset="published", time_steps=step).heat)

        shapeton.diffuse_heat(self.image, preset="published", time_steps=20, snapshot_steps=[10], snapshot=classify)
        self.assertEqual(len(results), 1)

    def test_another_thread_calls_by_itself(self):
        seen = []

        def work():
            shapeton.diffuse_heat(
                self.image, preset="published", time_steps=100, progress=lambda *_: seen.extend([threading.current_thread(), helpers()])
            )

        thread = threading.Thread(target=work)
        thread.start()
        thread.join()
        self.assertIs(seen[0], thread)
        self.assertEqual(seen[1], [thread])

    def test_functions_can_be_pickled(self):
        self.assertIs(pickle.loads(pickle.dumps(shapeton.diffuse_heat)), shapeton.diffuse_heat)

    def test_nothing_is_kept_until_garbage_is_collected(self):
        gc.collect()
        gc.disable()
        self.addCleanup(gc.enable)
        for options in ({"time_steps": 10}, {"time_steps": 10, "tolerance": -1.0}, {"time_steps": 10, "progress": lambda *_: None}):
            image = shapeton.Image(np.ones((5, 5, 5), dtype=np.float32))
            freed = weakref.ref(image.array)
            try:
                shapeton.diffuse_heat(image, **options)
            except shapeton.ParameterError:
                pass
            del image
            self.assertIsNone(freed(), options)


if __name__ == "__main__":
    unittest.main()
