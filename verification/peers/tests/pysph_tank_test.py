#!/usr/bin/python3
"""The driver of PySPH: it follows the wave, and a wrong input or a lost run does not end with 0.
Exit status 77, a skipped test, where python3-pysph is not installed."""
import csv
import importlib.util
import json
import math
import os
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
PEERS = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, PEERS)
from tank_definition import BadInput, Definition, Motion, Table  # noqa: E402

TANK = {"length_m": 1.0, "height_m": 0.7, "depth_m": 0.35, "gravity_m_s2": 9.81,
        "density_kg_m3": 1000.0,
        "motion": {"type": "sine", "amplitude_m": 0.03, "angular_frequency_rad_s": 3.0,
                   "ramp_periods": 0},
        "gauges_m": {"right": 0.95}, "duration_s": 1.0, "sample_interval_s": 0.02,
        "spacing_m": 0.05, "scheme": "edac"}
SCHEMES = ["delta", "adami", "edac"]


def linear_elevation(tank, x, times):
    """Sums eta_n'' + w_n^2 eta_n = -c_n k_n tanh(k_n h) X'' over the modes that a spacing resolves."""
    length, motion = tank.length, tank.motion
    result, dt = [0.0] * len(times), 1e-3
    for n in range(5):
        k = (2 * n + 1) * math.pi / length
        shape = math.sin(k * (x - length / 2))
        push = 4 * (-1)**n / (length * k**2) * k * math.tanh(k * tank.depth)
        w2 = tank.gravity * k * math.tanh(k * tank.depth)
        eta, rate, t, i = 0.0, -push * motion.initial_velocity, 0.0, 0
        while i < len(times):
            if t >= times[i] - dt / 2:
                result[i] += shape * eta
                i += 1
            rate += dt * (-w2 * eta - push * motion.acceleration(t))
            eta, t = eta + dt * rate, t + dt
    return result


class PysphTank(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = directory.name

    def definition(self, **changes):
        path = os.path.join(self.directory, "tank.json")
        with open(path, "w", encoding="utf-8") as file:
            json.dump({**TANK, **changes}, file)
        return path

    def run_driver(self, **changes):
        return subprocess.run(
            [sys.executable, os.path.join(PEERS, "pysph_tank.py"), self.definition(**changes),
             os.path.join(self.directory, "out")],
            capture_output=True, text=True, check=False)

    def test_follows_the_wave_of_linear_theory_on_a_coarse_lattice(self):
        ended = self.run_driver()
        self.assertEqual(ended.returncode, 0, ended.stderr)
        with open(os.path.join(self.directory, "out", "elevation.csv"), encoding="utf-8") as file:
            rows = [(float(row["t"]), float(row["right"])) for row in csv.DictReader(file)]
        times, elevation = zip(*rows)
        self.assertGreaterEqual(times[-1], 1.0)
        theory = linear_elevation(Definition(self.definition(), SCHEMES), 0.95, times)
        power = sum(a * a for a in theory)
        along = sum(a * b for a, b in zip(theory, elevation))
        rest = sum((a - b)**2 for a, b in zip(theory, elevation))
        # Two thirds of the power are explained, and the wave is not half or twice as high.
        self.assertLess(rest / power, 1 / 3)
        self.assertLess(abs(along / power - 1), 0.5)
        with open(os.path.join(self.directory, "out", "cost.json"), encoding="utf-8") as file:
            cost = json.load(file)
        self.assertEqual(cost["liquid_particles"], 140)
        self.assertEqual(cost["wall_particles"], 28 * 18 - 20 * 14)
        self.assertGreater(cost["steps"], 1000)
        self.assertGreater(cost["loop_cpu_s"], 0)
        self.assertGreater(cost["compile_wall_s"], 0)

    def test_ends_with_1_where_the_liquid_is_lost(self):
        # 50 g throw the liquid out of a gauge's reach.
        ended = self.run_driver(motion={"type": "table", "time_s": [0, 2], "initial_velocity_m_s": 0,
                                        "acceleration_m_s2": [500, 500]})
        self.assertEqual(ended.returncode, 1, ended.stderr)
        self.assertIn("pysph_tank: ", ended.stderr)

    def test_ends_with_2_and_says_what_it_expects_of_a_wrong_input(self):
        ended = self.run_driver(spacing_m=0)
        self.assertEqual(ended.returncode, 2)
        self.assertIn("tank.json: spacing_m = 0: expected a number > 0, m", ended.stderr)

    def test_refuses_what_a_tank_cannot_have(self):
        for changes, message in [
                ({"length_m": "1"}, "length_m = '1': expected a number > 0, m"),
                ({"depth_m": 0.7}, "expected a depth below the height of 0.7 m"),
                ({"depth_m": 0.33}, "depth_m = 0.33: expected a whole number of spacings of 0.05 m"),
                ({"scheme": "delta_plus"}, "expected one of delta, adami, edac"),
                ({"gauges_m": {}}, "expected at least one gauge"),
                ({"gauges_m": {"far": 2}}, "gauges_m.far = 2: expected a place from 0 to 1 m"),
                ({"roof": 1}, "roof = 1: expected one of the keys length_m"),
                ({"motion": 3}, "motion = 3: expected a table"),
                ({"motion": {"type": "table", "time_s": [0, 0.5], "initial_velocity_m_s": 0,
                             "acceleration_m_s2": [0, 1]}}, "it ends at 0.5 s")]:
            with self.assertRaises(BadInput) as refused:
                Definition(self.definition(**changes), SCHEMES)
            self.assertIn(message, str(refused.exception))

    def test_ramps_the_sine_as_a_case_file_does(self):
        motion = Motion(Table({"type": "sine", "amplitude_m": 2.0, "angular_frequency_rad_s": 3.0,
                               "ramp_periods": 1}, "tank.json"))
        self.assertEqual(motion.initial_velocity, 0)
        step, end = 1e-3, 2 * math.pi / 3

        def displacement(t):
            s = t / end
            return 2 * s**3 * (10 - 15 * s + 6 * s * s) * math.sin(3 * t)
        for t in [0.2, 1.0, 1.9]:
            second = (displacement(t - step) - 2 * displacement(t) + displacement(t + step)) / step**2
            self.assertAlmostEqual(motion.acceleration(t), second, places=3)
        self.assertAlmostEqual(motion.acceleration(3.0), -18 * math.sin(9))


if __name__ == "__main__":
    if importlib.util.find_spec("pysph") is None:
        print("skipped: python3-pysph is not installed")
        sys.exit(77)
    unittest.main()
