#!/usr/bin/python3
"""Computes a surging tank with PySPH (Debian's python3-pysph):

    pysph_tank.py TANK.json DIRECTORY

writes DIRECTORY/elevation.csv (t, and eta of each gauge above the still level) and cost.json.
Nothing is tuned: the schemes and their numbers are those of PySPH's own examples, named below. The
tank is at rest and the liquid feels -X''(t), with the velocity -X'(0) at first (as the example
sloshing/st_bouscasse.py does). The liquid's surface is where the sum of m/rho W over it, and over
its mirror images in the walls, falls below 0.5. Exit status: 2 for a wrong input, 1 for a failed run.
"""
import csv
import json
import os
import sys
import time

sys.dont_write_bytecode = True  # nothing is written beside the sources
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from tank_definition import BadInput, Definition  # noqa: E402

import numpy as np  # noqa: E402
import pysph  # noqa: E402
from pysph.base.kernels import CubicSpline, QuinticSpline  # noqa: E402
from pysph.base.utils import get_particle_array  # noqa: E402
from pysph.solver.application import Application  # noqa: E402
from pysph.solver.tools import Tool  # noqa: E402
from pysph.sph.equation import Equation, Group  # noqa: E402
from pysph.sph.scheme import AdamiHuAdamsScheme, WCSPHScheme  # noqa: E402
from pysph.sph.wc.edac import EDACScheme  # noqa: E402

H_OVER_DP = 1.3     # hdx of dam_break_2d.py, sloshing_tank_horizontal.py
ALPHA = 0.1         # alpha of the same two
SOUND = 10.0        # c0 = 10 Vmax, Vmax = sqrt(g H): hydrostatic_tank.py
TIME_STEP = 0.125   # dt = 0.125 h/c0: dam_break_2d.py, sloshing_tank_pitch.py
WALL_LAYERS = 4     # nboundary_layers of dam_break_2d.py


def scheme_of(tank, h, c0):
    names = dict(fluids=["fluid"], solids=["solid"], dim=2, rho0=tank.density, c0=c0,
                 gy=-tank.gravity)
    if tank.scheme == "delta":  # sloshing_tank_pitch.py
        return WCSPHScheme(h0=h, hdx=H_OVER_DP, alpha=ALPHA, beta=0.0, gamma=7.0, delta_sph=True,
                           hg_correction=True, **names), CubicSpline(dim=2)
    if tank.scheme == "adami":  # `aha` of dam_break_2d.py
        return AdamiHuAdamsScheme(nu=0.0, h0=h, p0=0.0, gamma=1.0, tdamp=0.0, alpha=ALPHA,
                                  **names), QuinticSpline(dim=2)
    return EDACScheme(nu=0.0, h=h, pb=0.0, eps=0.0, clamp_p=True,  # `edac` of dam_break_2d.py
                      **names), QuinticSpline(dim=2)


class Excitation(Equation):
    """Adds -X'' to the liquid's acceleration."""

    def post_loop(self, d_idx, d_au, d_push):
        d_au[d_idx] -= d_push[0]


class WallAcceleration(Equation):
    """Tells the generalised walls their acceleration X''; they stay where they are."""

    def initialize(self, d_idx, d_au, d_push):
        d_au[d_idx] = d_push[0]


class Gauges(Tool):
    """Moves the tank, and records the elevation and what the run cost."""

    def __init__(self, app):
        self.app, self.rows, self.loop_began, self.next = app, [], None, 0.0

    def pre_step(self, solver):
        if self.loop_began is None:
            self.loop_began, self.cpu_began = time.time(), time.process_time()
            self.record(0.0)
        push = self.app.tank.motion.acceleration(solver.t)
        for array in solver.particles:
            array.get("push")[0] = push

    def post_step(self, solver):
        if solver.t > self.next - 1e-9:
            self.record(solver.t)

    def record(self, t):
        tank, fluid = self.app.tank, self.app.liquid
        x, y = fluid.x, fluid.y
        if not (np.isfinite(x).all() and np.isfinite(y).all()):
            raise RuntimeError(f"the positions are not finite at {t:g} s")
        row = [self.surface(g, x, y, fluid.m / fluid.rho) for g in tank.gauges.values()]
        self.rows.append([t] + [z - tank.depth for z in row])
        self.next = (np.floor(t / tank.sample_interval + 1e-6) + 1) * tank.sample_interval

    def surface(self, gauge, x, y, volume):
        tank, kernel, h = self.app.tank, self.app.kernel, self.app.h
        reach = kernel.radius_scale * h
        x = np.concatenate([x, -x, 2 * tank.length - x])
        y, volume = np.tile(y, 3), np.tile(volume, 3)
        near = np.abs(x - gauge) < reach
        x, y, volume = x[near], y[near], volume[near]
        if not len(x):
            raise RuntimeError(f"no liquid is near the gauge at x = {gauge:g} m")
        # The sum rises from 0 above the highest particle; the first 0.5 from above is the surface.
        step, above = tank.spacing / 10, 0.0
        z = y.max() + reach
        while z > 0:
            distance = np.hypot(x - gauge, y - z)
            seen = distance < reach
            total = sum(v * kernel.kernel([0, 0, 0], r, h)
                        for v, r in zip(volume[seen], distance[seen]))
            if total >= 0.5:
                return z + step * (total - 0.5) / (total - above)
            above, z = total, z - step
        raise RuntimeError(f"the gauge at x = {gauge:g} m finds no surface")


class SurgingTank(Application):
    def __init__(self, tank, directory):
        self.tank, self.h = tank, H_OVER_DP * tank.spacing
        self.c0 = SOUND * np.sqrt(tank.gravity * tank.depth)
        super().__init__(fname="pysph_tank", output_dir=directory)

    def create_scheme(self):
        scheme, self.kernel = scheme_of(self.tank, self.h, self.c0)
        scheme.configure_solver(kernel=self.kernel, dt=TIME_STEP * self.h / self.c0,
                                tf=self.tank.duration + self.tank.sample_interval, pfreq=10**9)
        return scheme

    def create_particles(self):
        tank, dp = self.tank, self.tank.spacing
        columns, rows = round(tank.length / dp), round(tank.depth / dp)
        walls = int(np.ceil(tank.height / dp))
        i, j = np.meshgrid(np.arange(-WALL_LAYERS, columns + WALL_LAYERS),
                           np.arange(-WALL_LAYERS, walls), indexing="ij")
        inside = (i >= 0) & (i < columns) & (j >= 0)
        arrays = []
        for name, where in [("fluid", inside & (j < rows)), ("solid", ~inside)]:
            array = get_particle_array(name=name, x=(i[where] + 0.5) * dp, y=(j[where] + 0.5) * dp,
                                       h=self.h, m=tank.density * dp**2, rho=tank.density)
            arrays.append(array)
        self.scheme.setup_properties(arrays)
        for array in arrays:
            array.add_constant("push", 0.0)
        self.liquid, self.walls = arrays
        self.liquid.u[:] = -tank.motion.initial_velocity
        return arrays

    def create_equations(self):
        equations = self.scheme.get_equations()
        equations[-1].equations.append(Excitation(dest="fluid", sources=None))
        if self.tank.scheme != "delta":
            equations.insert(0, Group([WallAcceleration(dest="solid", sources=None)], real=False))
        return equations

    def create_tools(self):
        self.gauges = Gauges(self)
        return [self.gauges]


def run(tank, directory):
    began = time.time()
    app = SurgingTank(tank, directory)
    app.run(argv=["--disable-output", "--no-openmp", "--quiet"])
    ended, gauges = time.time(), app.gauges
    if gauges.rows[-1][0] < tank.duration:
        raise RuntimeError(f"the run ended at {gauges.rows[-1][0]:g} s of {tank.duration:g} s")
    with open(os.path.join(directory, "elevation.csv"), "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["t"] + list(tank.gauges))
        table.writerows([f"{value:.9g}" for value in row] for row in gauges.rows)
    cost = {"program": "PySPH " + pysph.__version__, "scheme": tank.scheme,
            "spacing_m": tank.spacing, "liquid_particles": app.liquid.get_number_of_particles(),
            "wall_particles": app.walls.get_number_of_particles(), "steps": app.solver.count,
            "speed_of_sound_m_s": float(app.c0), "h_over_dp": H_OVER_DP,
            "loop_wall_s": ended - gauges.loop_began,
            "loop_cpu_s": time.process_time() - gauges.cpu_began,
            "compile_wall_s": gauges.loop_began - began}
    with open(os.path.join(directory, "cost.json"), "w", encoding="utf-8") as file:
        json.dump(cost, file, indent=1)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(f"usage: {sys.argv[0]} TANK.json DIRECTORY")
    try:
        definition = Definition(sys.argv[1], ["delta", "adami", "edac"])
        os.makedirs(sys.argv[2], exist_ok=True)
    except (BadInput, OSError) as error:
        print(f"pysph_tank: {error}", file=sys.stderr)
        sys.exit(2)
    try:
        run(definition, sys.argv[2])
    except Exception as error:  # whatever PySPH throws, the run has failed
        print(f"pysph_tank: {type(error).__name__}: {error}", file=sys.stderr)
        sys.exit(1)
