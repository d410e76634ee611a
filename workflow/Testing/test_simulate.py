"""The simulation of a cluster against schedules computed by hand."""

import importlib.machinery
import importlib.util
import os
import unittest

from case import WORKFLOW

LOADER = importlib.machinery.SourceFileLoader("simulate", os.path.join(WORKFLOW, "simulate"))
simulate = importlib.util.module_from_spec(importlib.util.spec_from_loader("simulate", LOADER))
LOADER.exec_module(simulate)

TIME = 1000.0
JOB = TIME + simulate.OVERHEAD
SUBMISSION = 1.0 / simulate.SUBMITTED_PER_SECOND


class Simulation(unittest.TestCase):
    def test_equal_jobs_come_in_rounds(self):
        jobs = [[(TIME, 1000)]] * 24  # 2 nodes of 4 cores: three rounds
        self.assertAlmostEqual(simulate.simulate(jobs, 2, 4, 64000), 3 * JOB, delta=24 * SUBMISSION)

    def test_memory_limits_as_cores_do(self):
        jobs = [[(TIME, 30000)]] * 8  # two per node, regardless of the cores
        self.assertAlmostEqual(simulate.simulate(jobs, 2, 4, 64000), 2 * JOB, delta=8 * SUBMISSION)

    def test_a_killed_job_runs_again(self):
        end = simulate.simulate([[(TIME / 2, 1000), (TIME, 2000)]], 1, 1, 64000)
        self.assertAlmostEqual(end, JOB + TIME / 2 + simulate.OVERHEAD, delta=1)

    def test_submission_limits_short_jobs(self):
        jobs = [[(1.0, 10)]] * 1000
        self.assertGreaterEqual(simulate.simulate(jobs, 50, 16, 64000), 1000 * SUBMISSION)

    def test_a_job_that_fits_nowhere(self):
        with self.assertRaisesRegex(ValueError, "more memory than a node has"):
            simulate.simulate([[(TIME, 1000)]], 1, 1, 500)


if __name__ == "__main__":
    unittest.main()
