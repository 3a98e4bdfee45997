#!/usr/bin/python3
"""Prints what each choice of a scheme reaches in the campaign `schemes`, as a table of Markdown:

    verification/campaigns/schemes_table.py build/campaigns/schemes

No choice rests on one case. A choice is the runs of one name. Each error is divided by a goal that was set before the
runs; the worst and the mean of these ratios are over all measures. The choice with the smallest worst ratio stands
first. A choice for which a value is missing has neither and stands last. A goal is no gate and decides no verdict."""
import json
import math
import sys

import h5py
import numpy

STILL_FROM = 15.0  # [s], the window of the case
# Heading, case, ending of the run's name, reference, measured, goal. Measured is a series, or the mode whose
# frequency error results.json has. A series is compared with that of the reference, or without one measured by its
# largest magnitude.
MEASURES = [
    ("still water", "still_water", "", None, "kinetic_over_potential_energy", 1e-8),
    ("ramped surge", "li2010_small_amplitude_ramp", "", "potential", "elevation@right", 0.01),
    ("impulsive surge", "schemes_surge", "", "linear", "elevation@right", 0.1),
    ("free wave, frequency", "standing_wave", "", "linear", "natural_1", 0.001),
    ("mild roll, pressure", "schemes_roll", "", "linear", "wall_pressure@P", 0.03),
    ("dam's front", "dam_break_martin_moyce", "", "interfoam_105x60", "front_position", 0.05),
    ("ramped, disorder", "li2010_small_amplitude_ramp", "_disordered", "potential", "elevation@right", 0.12),
    ("impulsive, disorder", "schemes_surge", "_disordered", "linear", "elevation@right", 0.12),
    ("mild roll, disorder", "schemes_roll", "_disordered", "linear", "wall_pressure@P", 0.12),
    ("ramped, rotated lattice", "li2010_small_amplitude_ramp", "_rotated", "potential", "elevation@right", 0.12),
]


def series_of(campaign, case, run, name):
    with h5py.File(f"{campaign}/runs/{case}/{run}.h5") as result:
        group = result["series/" + name.replace("/", "%2F")]
        return group["time"][:], group["value"][:]


def normalised_rms(candidate, reference, begin, end):
    """rms(c - r) / rms(r - mean r) over [begin, end], with trapezoids; the reference is interpolated. NaN stays NaN."""
    time, value = (of[(candidate[0] >= begin) & (candidate[0] <= end)] for of in candidate)
    other = numpy.interp(time, *reference)
    def mean(of):
        return numpy.trapz(of, time) / (time[-1] - time[0])
    return math.sqrt(mean((value - other) ** 2) / mean((other - mean(other)) ** 2))


def value_of(campaign, case, run, reference, measured):
    if reference is None:
        time, value = series_of(campaign, case["name"], run, measured)
        return numpy.max(numpy.abs(value[time >= STILL_FROM]))
    pairs = [pair for pair in case["comparisons"] if pair["candidate"] == run]
    if measured.startswith("natural_"):
        modes = [mode for pair in pairs if pair["reference"] == reference for mode in pair["modes"]]
        return abs(next(mode for mode in modes if mode["mode"] == measured)["frequency_error"]["value"])
    begin, end = pairs[0]["window_begin_s"], pairs[0]["window_end_s"]
    members = [one["name"] for one in case["runs"] if run in (one["name"], one.get("ensemble"))]
    other = series_of(campaign, case["name"], reference, measured)
    return numpy.mean([normalised_rms(series_of(campaign, case["name"], one, measured), other, begin, end)
                       for one in members])


def ratio_of(campaign, cases, choice, measure):
    _, name, end, reference, measured, goal = measure
    try:
        return float(value_of(campaign, cases[name], choice + end, reference, measured)) / goal
    except (KeyError, IndexError, OSError, StopIteration, TypeError):  # the run or its value is missing
        return math.nan


def choices_of(cases, measures):
    """The runs of particles that two or more of the cases have under one name, but for those with an ending."""
    names = [run["name"] for case in {measure[1] for measure in measures} for run in cases[case]["runs"]
             if "scheme" in run and run.get("ensemble", run["name"]) == run["name"]]
    endings = tuple(measure[2] for measure in measures if measure[2])
    return sorted(name for name in set(names) if names.count(name) > 1 and not name.endswith(endings))


def table(campaign, measures=MEASURES):
    with open(f"{campaign}/report/results.json") as text:
        cases = {case["name"]: case for case in json.load(text)["cases"]}
    lines = []
    for choice in choices_of(cases, measures):
        ratios = [ratio_of(campaign, cases, choice, measure) for measure in measures]
        total = [float(numpy.max(ratios)), float(numpy.mean(ratios))]  # NaN where one of them is
        cells = ["not available" if math.isnan(ratio) else f"{ratio:.2g}" for ratio in ratios + total]
        lines.append((math.inf if math.isnan(total[0]) else total[0], [choice, *cells]))
    header = ["choice", *(f"{measure[0]} ({measure[5]:g})" for measure in measures), "worst ratio", "mean ratio"]
    rows = [header, ["---"] * len(header), *(row for _, row in sorted(lines))]
    return "\n".join("| " + " | ".join(row) + " |" for row in rows)


if __name__ == "__main__":
    print(table(sys.argv[1]))
