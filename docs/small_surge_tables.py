#!/usr/bin/env python3
"""Writes the tables of the small surge in README.md and docs/accuracy.md from the results of a campaign.

Usage: docs/small_surge_tables.py build/campaigns/small_amplitude/report/results.json
"""
import datetime
import json
import math
import pathlib
import re
import subprocess
import sys

RUNS = {  # run: the reference that it is compared with
    "recommended_25mm": "linear", "recommended_10mm": "linear", "recommended_5mm": "linear", "li2010_10mm": "linear",
    "interfoam_50x50": "linear_two_layer", "interfoam_50x100": "linear_two_layer"}
README_RUNS = ["recommended_10mm", "recommended_5mm", "li2010_10mm", "interfoam_50x100"]
HEAD = "| run | rms error | forced amplitude | forced lag | natural frequency | decay | CPU |\n|---|---|---|---|---|---|---|\n"


def interval(found, scale, unit, sign="+"):
    """Value and half width of 95 %, to two digits of a half width that begins with 1, else to one."""
    value, half = scale * found["value"], scale * found["half_width_95"]
    digits = math.floor(math.log10(half))
    places = max(0, (1 if half / 10**digits < 2 else 0) - digits)
    return f"{round(value, places) + 0.0:{sign}.{places}f} ± {half:.{places}f} {unit}"


def rms(run, pair, case):
    """With the uncertainty of its gate row, where it has one."""
    for one in case["gate"]:
        if one["metric"] == "normalised_rms" and one["candidate"] == run and one.get("limit"):
            return interval({"value": one["value"], "half_width_95": one["uncertainty_95"]["all"]}, 100, "%", "")
    return f"{100 * pair['normalised_rms']['value']:.3g} %"


def row(run, case):
    name = re.sub(r"^interfoam_(\d+)x(\d+)$", r"interFoam, \1 x \2", re.sub(r"^(\w+)_(\d+)mm$", r"`\1`, \2 mm", run))
    pair = next(one for one in case["comparisons"]
                if (one["candidate"], one["reference"], one["quantity"]) == (run, RUNS[run], "elevation@right"))
    forced, natural = (next(one for one in pair["modes"] if one["mode"] == mode) for mode in ("forced", "natural_1"))
    cost = next(one["user_time_s"] + one["system_time_s"] for one in case["runs"] if one["name"] == run)
    return [name, rms(run, pair, case), interval(forced["amplitude_error"], 100, "%"),
            interval(forced["phase_lag_deg"], 1, "deg", ""), interval(natural["frequency_error"], 100, "%"),
            interval(natural["decay_rate_1_s"], 1, "1/s", ""), f"{cost:.2g} s"]


def replace(file, head, rows):
    """Replaces the table below `head`, and in the page's sentence "The figures of this table are of ..." its origin."""
    text = file.read_text()
    begin = text.index(head) + len(head)
    end = text.index("\n\n", begin)
    table = "\n".join("| " + " | ".join(cells) + " |" for cells in rows)
    text = text[:begin] + table + text[end:]
    text, found = re.subn(r"(The figures of this table are of )\d+ \w+ \d+, commit \w+, on an? [^,.]+",
                          rf"\g<1>{origin}", text)
    if found != 1:
        sys.exit(f"{file}: expected one sentence 'The figures of this table are of DATE, commit HASH, on a MACHINE'")
    file.write_text(text)


case = next(one for one in json.load(open(sys.argv[1]))["cases"] if one["name"] == "li2010_small_amplitude")
made = [one["provenance"] for one in case["runs"] if one["name"] in RUNS]
day = datetime.datetime.fromisoformat(max(one["date_utc"] for one in made).rstrip("Z"))
commit = subprocess.run(["git", "rev-parse", "--short=8", "HEAD"], capture_output=True, text=True, check=True).stdout.strip()
machine = " and ".join(sorted({one["processor"] for one in made}))
origin = f"{day:%-d %B %Y}, commit {commit}, on {'an' if machine[0] in 'AEIO' else 'a'} {machine}"
docs = pathlib.Path(__file__).parent
replace(docs / "accuracy.md", HEAD, [row(run, case) for run in RUNS])
short = [0, 1, 2, 3, 6]
replace(docs.parent / "README.md", HEAD.replace(" natural frequency | decay |", "").replace("|---|---|---|\n", "|---|\n", 1),
        [[row(run, case)[i] for i in short] for run in README_RUNS])
