import inspect
import subprocess
import sys
import threading
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

import shapeton
from shapeton import _shapeton, colon

from support import MODULES, TestCase, run_python


class PackageTest(TestCase):
    def test_each_name_of_the_compiled_module_is_in_one_module_of_the_package(self):
        compiled = {name for name in vars(_shapeton) if not name.startswith("_")}
        offered = [name for module in MODULES for name in module.__all__ if hasattr(_shapeton, name)]
        self.assertEqual(sorted(offered), sorted(compiled))
        for module in MODULES:
            self.assertEqual(module.__all__, sorted(module.__all__))
            for name in module.__all__:
                self.assertTrue(hasattr(module, name), name)

    def test_everything_has_a_docstring(self):
        for module in MODULES:
            self.assertTrue(module.__doc__)
            for name in module.__all__:
                thing = getattr(module, name)
                self.assertTrue(thing.__doc__, name)
                if inspect.isclass(thing):
                    for member, value in vars(thing).items():
                        if isinstance(value, property) and not member.startswith("_"):
                            self.assertTrue(value.__doc__, f"{name}.{member}")

    def test_the_stub_is_up_to_date(self):
        root = Path(__file__).parent.parent
        command = [sys.executable, root / "utilities/make_stub.py", "--check", root / "shapeton/_shapeton.pyi"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_the_version_is_that_of_the_project(self):
        project = (Path(__file__).parents[3] / "pyproject.toml").read_text()
        self.assertIn(f'version = "{shapeton.__version__}"', project)

    def test_other_packages_are_imported_when_they_are_asked_for(self):
        imported = set(run_python("import sys, shapeton; print(*sys.modules)").split())
        self.assertIn("numpy", imported)
        others = {"SimpleITK", "itk", "matplotlib", "nibabel", "pydicom", "pyvista", "scipy", "vtk", "vtkmodules"}
        self.assertEqual(imported & others, set())

    def test_it_works_beside_vtk_nibabel_and_pydicom_in_any_order(self):
        use = "import numpy; shapeton.diffuse_heat(shapeton.Image(numpy.eye(9).reshape(9, 3, 3)), time_steps=3)"
        for order in ("vtk, nibabel, pydicom, shapeton", "shapeton, pydicom, nibabel, vtk"):
            self.assertEqual(run_python(f"import {order}; {use}; print('done')"), "done")

    def test_the_interpreter_ends_while_a_thread_computes(self):
        code = '''
import threading, time, numpy, shapeton
from shapeton import graphs
image = shapeton.Image(numpy.random.default_rng(1).random((96, 96, 96)))
work = {
    "heat": lambda: shapeton.diffuse_heat(image, preset="published", time_steps=30000),
    "progress": lambda: shapeton.diffuse_heat(image, preset="published", time_steps=30000, progress=lambda *_: None),
    "graph": lambda: graphs.embed_graph(graphs.complete_graph(40)),
}["WORK"]
threading.Thread(target=work, daemon=True).start()
time.sleep(0.3)
print("done")
'''
        for work in ("heat", "progress", "graph"):
            self.assertEqual(run_python(code.replace("WORK", work)), "done")

    def test_a_thread_that_computes_at_the_end_is_stopped_and_the_main_thread_is_not(self):
        code = """
import atexit, sys, threading, time, numpy

def at_the_end():  # after the handlers of modules that are imported later
    thread.join()
    sys.stdout.write("joined, ")
    shapeton.diffuse_heat(image, preset="published", time_steps=3)
    print("computed")

atexit.register(at_the_end)
sys.stderr = sys.stdout
import shapeton
image = shapeton.Image(numpy.random.default_rng(1).random((96, 96, 96)))
thread = threading.Thread(target=lambda: shapeton.diffuse_heat(image, preset="published", time_steps=10**7), daemon=True)
thread.start()
time.sleep(0.3)
"""
        self.assertEqual(run_python(code), "joined, computed")

    def test_a_process_forked_off_a_computing_one_ends(self):
        code = """
import os, sys, threading, time, numpy, shapeton
image = shapeton.Image(numpy.random.default_rng(1).random((96, 96, 96)))
threading.Thread(target=lambda: shapeton.diffuse_heat(image, preset="published", time_steps=30000), daemon=True).start()
time.sleep(0.3)
child = os.fork()
if child == 0:
    sys.exit(7)
print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
"""
        self.assertEqual(run_python(code), "7")

    def test_results_describe_themselves_by_their_attributes(self):
        image = shapeton.Image(np.eye(9, dtype=np.float32).reshape(9, 3, 3))
        result = shapeton.diffuse_heat(image, preset="published", time_steps=3, components=True)
        self.assertRegex(repr(result), r"^<shapeton.HeatResult .*heat=<shapeton.Image x: 3 x 1 mm, .*histogram=")
        self.assertIn("components=<1 of shapeton.ShapeComponent>", repr(result))
        placed = shapeton.Image(np.zeros((4, 3, 2), np.int16), (0.5, 1.5, 2.0))
        self.assertEqual(repr(placed), "<shapeton.Image x: 2 x 0.5 mm, y: 3 x 1.5 mm, z: 4 x 2 mm, int16>")
        self.assertRegex(repr(result.components[0]), r"^<shapeton.ShapeComponent index=\(\d, \d, \d\), voxels=\d+, ")
        self.assertRegex(repr(colon.colon_phantom(size=(24, 24, 24))), r"centerline=<shapeton.Curves 1")
        described = [name for name, thing in vars(_shapeton).items() if inspect.isclass(thing)]
        for name in described:
            self.assertIsNot(getattr(_shapeton, name).__repr__, object.__repr__, name)

    def test_dir_lists_public_names_and_classes_have_their_public_module(self):
        for module in MODULES:
            names = [name for name in dir(module) if not name.startswith("__")]
            self.assertEqual(names, module.__all__)
            for name in names:
                thing = getattr(module, name)
                if inspect.isclass(thing):
                    self.assertIn(thing.__module__, ("shapeton", "shapeton.shapes", module.__name__))
                    self.assertIs(getattr(sys.modules[thing.__module__], name), thing)

    def test_two_threads_compute_at_once(self):
        image = shapeton.Image(np.random.default_rng(1).random((24, 24, 24), dtype=np.float32))
        both = threading.Barrier(2, timeout=600)
        arrived = []

        def meet(share, stage):
            if threading.current_thread() not in arrived:
                arrived.append(threading.current_thread())
                both.wait()  # returns only if the other thread computes, too

        def diffuse():
            return shapeton.diffuse_heat(image, preset="published", time_steps=3000, progress=meet).heat.array

        with ThreadPoolExecutor(2) as pool:
            one, other = (call.result() for call in [pool.submit(diffuse), pool.submit(diffuse)])
        self.assertSame(one, other)

    def test_errors_belong_to_the_classes_of_python(self):
        for error, kinds in (
            (shapeton.ParameterError, (shapeton.Error, ValueError)),
            (shapeton.InputError, (shapeton.Error, ValueError)),
            (shapeton.MissingFileError, (shapeton.InputError, FileNotFoundError)),
            (shapeton.OutputError, (shapeton.Error, OSError)),
            (shapeton.Aborted, (shapeton.Error, RuntimeError)),
        ):
            for kind in kinds:
                self.assertTrue(issubclass(error, kind))


if __name__ == "__main__":
    unittest.main()
