#!/usr/bin/python3
"""The table of the choices of a scheme, on series whose differences are known."""
import json
import os
import sys
import tempfile
import unittest

try:
    import h5py
    import numpy
except ImportError:
    print("python3-h5py is not installed")
    sys.exit(77)

sys.path.insert(0, os.path.join(os.path.dirname(__file__), ".."))
import schemes_table

MEASURES = [
    ("still", "still", "", None, "kinetic", 1e-8),
    ("surge", "surge", "", "theory", "elevation@right", 0.01),
    ("frequency", "surge", "", "theory", "natural_1", 0.001),
    ("disorder", "surge", "_disordered", "theory", "elevation@right", 0.1),
]
TIME = numpy.linspace(0, 20, 2001)
WAVE = numpy.sin(numpy.pi * TIME)  # nine whole periods from 1 to 19 s: rms 1 / sqrt(2), mean 0


class SchemesTable(unittest.TestCase):
    def setUp(self):
        home = tempfile.TemporaryDirectory()
        self.addCleanup(home.cleanup)
        self.campaign = home.name
        self.cases = {name: {"name": name, "runs": [], "comparisons": []} for name in ("still", "surge")}
        self.leave("surge", "theory", "elevation@right", WAVE, scheme=None)

    def leave(self, case, run, series, value, frequency_error=0.0, scheme="recommended", ensemble=None):
        os.makedirs(f"{self.campaign}/runs/{case}", exist_ok=True)
        with h5py.File(f"{self.campaign}/runs/{case}/{run}.h5", "w") as result:
            group = result.create_group("series/" + series)
            group["time"], group["value"] = TIME, value
        entry = {"name": run} | ({"scheme": scheme} if scheme else {}) | ({"ensemble": ensemble} if ensemble else {})
        self.cases[case]["runs"].append(entry)
        mode = {"mode": "natural_1", "frequency_error": {"value": frequency_error}}
        self.cases[case]["comparisons"].append({"candidate": run, "reference": "theory", "modes": [mode],
                                                "window_begin_s": 1.0, "window_end_s": 19.0})

    def choice(self, name, wave=1.02 * WAVE, still=2e-8, frequency_error=-0.0005, disordered=(1.1, 1.3)):
        kinetic = numpy.where(TIME < 15, 1.0, still)  # what the start leaves does not count
        self.leave("still", name, "kinetic", kinetic)
        self.leave("surge", name, "elevation@right", wave, frequency_error)
        for n, factor in enumerate(disordered):
            member = f"{name}_disordered" + (f"_{n + 1}" if n else "")
            self.leave("surge", member, "elevation@right", factor * WAVE, ensemble=f"{name}_disordered")

    def rows(self):
        os.makedirs(f"{self.campaign}/report", exist_ok=True)
        with open(f"{self.campaign}/report/results.json", "w") as text:
            json.dump({"cases": list(self.cases.values())}, text)
        lines = schemes_table.table(self.campaign, MEASURES).split("\n")
        return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines[2:]]

    def test_divides_each_error_by_its_goal(self):
        self.choice("a")
        self.assertEqual(self.rows(), [["a", "2", "2", "0.5", "2", "2", "1.6"]])

    def test_sees_results_that_are_scaled_shifted_or_cut(self):
        for wave, ratio in ((1.06 * WAVE, "6"), (0.94 * WAVE, "6"), (WAVE + 0.1 / 2**0.5, "10")):
            self.choice("a", wave=wave)
            self.choice("b")
            self.assertEqual(self.rows()[-1][:3], ["a", "2", ratio])
            self.setUp()

    def test_puts_the_smallest_worst_ratio_first_and_a_missing_value_last(self):
        self.choice("a", still=5e-8)
        self.choice("b")
        self.choice("c", wave=numpy.where(TIME < 5, WAVE, numpy.nan))
        self.choice("d", disordered=())
        self.leave("surge", "alone", "elevation@right", WAVE)
        self.assertEqual([row[0] for row in self.rows()], ["b", "a", "c", "d"])
        self.assertEqual(self.rows()[2], ["c", "2", "not available", "0.5", "2", "not available", "not available"])
        self.assertEqual(self.rows()[3][4:], ["not available"] * 3)


if __name__ == "__main__":
    unittest.main()
