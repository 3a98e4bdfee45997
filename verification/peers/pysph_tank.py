#!/usr/bin/python3
"""Computes a tank that stands still or surges with PySPH (Debian's python3-pysph).

    pysph_tank.py TANK.json DIRECTORY SCHEME SPACING_M
    pysph_tank.py --version

TANK.json is the {tank_file} of an external run. The program writes DIRECTORY/elevation.csv (t, and
eta of each gauge above the still level) and DIRECTORY/cost.json, the facts of an external run.

Nothing is tuned: the schemes and their numbers are those of PySPH's own examples, named below. The
tank is at rest and the liquid feels -X''(t), as in the example sloshing/st_bouscasse.py. It starts
under hydrostatic pressure. The surface is where the sum of m/rho0 W over the liquid, and over its
mirror images in the walls, falls below 0.5. It takes the rest density, since EDAC's density near
the surface is half of it. Exit status: 1 for a failed run, 3 where PySPH is not installed.
"""
import csv
import dataclasses
import inspect
import json
import os
import sys
import time

sys.dont_write_bytecode = True  # nothing is written beside the sources
try:
    import numpy as np
    import pysph
    from pysph.base.kernels import QuinticSpline, WendlandQuintic
    from pysph.base.utils import get_particle_array
    from pysph.solver.application import Application
    from pysph.solver.solver import Solver
    from pysph.solver.tools import Tool
    from pysph.sph.basic_equations import XSPHCorrection
    from pysph.sph.equation import Equation, Group
    from pysph.sph.integrator import PECIntegrator
    from pysph.sph.integrator_step import WCSPHStep
    from pysph.sph.scheme import Scheme, WCSPHScheme
    from pysph.sph.wc.basic import TaitEOS
    from pysph.sph.wc.edac import EDACScheme
    from pysph.sph.wc.transport_velocity import (
        ContinuityEquation, MomentumEquationArtificialViscosity, MomentumEquationPressureGradient,
        SolidWallPressureBC, VolumeFromMassDensity)
except ImportError as error:
    print(f"pysph_tank: {error}: expected PySPH, Debian's package python3-pysph", file=sys.stderr)
    sys.exit(3)

SOUND = 10.0  # c0 = 10 Vmax, Vmax = sqrt(g H): hydrostatic_tank.py


@dataclasses.dataclass(frozen=True)
class Numbers:
    h_over_dp: float
    time_step: float    # [h/c0]
    wall_layers: int
    kernel: type
    alpha: float        # of the artificial viscosity
    gamma: float        # of Tait's equation of state, 0 where the scheme has none
    walls_extrapolate: bool  # the liquid's pressure, so that they have to know the acceleration


SCHEMES = {
    # sloshing_tank_pitch.py (alpha, gamma, delta-SPH), `wcsph` of dam_break_2d.py (kernel, layers),
    # hdx of both and of sloshing_tank_horizontal.py; dt = 0.25 h/(c0 + Vmax): hydrostatic_tank.py.
    "delta_sph": Numbers(h_over_dp=1.3, time_step=0.25 / 1.1, wall_layers=4,
                         kernel=WendlandQuintic, alpha=0.1, gamma=7.0, walls_extrapolate=False),
    # `edac` of dam_break_2d.py, with the same time step.
    "edac": Numbers(h_over_dp=1.3, time_step=0.25 / 1.1, wall_layers=4,
                    kernel=QuinticSpline, alpha=0.0, gamma=0.0, walls_extrapolate=True),
    # hydrostatic_tank.py: hdx, kernel, walls of 5.5 dx, which are six layers, the numbers of its
    # `equations1`, dt = 0.75 * 0.25 h/(c0 + Vmax), the least of its limits there and here.
    "adami": Numbers(h_over_dp=1.2, time_step=0.75 * 0.25 / 1.1, wall_layers=6,
                     kernel=QuinticSpline, alpha=0.24, gamma=1.0, walls_extrapolate=True),
}


class GeneralisedWalls(Scheme):
    """`equations1` of hydrostatic_tank.py: section 6.0 of Adami, Hu & Adams 2012. Gravity acts from
    the start, which is hydrostatic here, and is not damped in."""

    def __init__(self, fluids, solids, dim, rho0, c0, gy, alpha, gamma):
        super().__init__(fluids, solids, dim)
        self.rho0, self.c0, self.gy, self.alpha, self.gamma = rho0, c0, gy, alpha, gamma

    def configure_solver(self, kernel=None, integrator_cls=None, extra_steppers=None, **kw):
        integrator = PECIntegrator(**{fluid: WCSPHStep() for fluid in self.fluids})
        self.solver = Solver(dim=self.dim, integrator=integrator, kernel=kernel, **kw)

    def setup_properties(self, particles, clean=True):
        for array in particles:
            for name in ("V", "wij", "cs", "arho", "rho0", "x0", "y0", "z0", "u0", "v0", "w0",
                         "ax", "ay", "az", "auhat", "avhat", "awhat"):
                array.add_property(name)
            array.V[:] = array.rho / array.m  # that of the walls stays

    def get_equations(self):
        fluid, solid, both = self.fluids[0], self.solids[0], self.fluids + self.solids
        return [
            Group([VolumeFromMassDensity(fluid, None)]),
            Group([TaitEOS(fluid, None, rho0=self.rho0, c0=self.c0, gamma=self.gamma)]),
            Group([SolidWallPressureBC(solid, [fluid], b=1.0, gy=self.gy, rho0=self.rho0,
                                       p0=self.c0**2 * self.rho0)]),
            Group([ContinuityEquation(fluid, both),
                   MomentumEquationPressureGradient(fluid, both, pb=0.0, gy=self.gy),
                   MomentumEquationArtificialViscosity(fluid, both, alpha=self.alpha, c0=self.c0),
                   XSPHCorrection(fluid, [fluid], eps=0.0)])]


def scheme_of(name, tank, h, c0):
    numbers = SCHEMES[name]
    common = dict(fluids=["fluid"], solids=["solid"], dim=2, rho0=tank["density_kg_m3"], c0=c0,
                  gy=-tank["gravity_m_s2"], alpha=numbers.alpha)
    if name == "delta_sph":
        return WCSPHScheme(h0=h, hdx=numbers.h_over_dp, beta=0.0, gamma=numbers.gamma,
                           delta_sph=True, hg_correction=True, **common)
    if name == "edac":
        return EDACScheme(nu=0.0, h=h, pb=0.0, eps=0.0, clamp_p=True, **common)
    return GeneralisedWalls(gamma=numbers.gamma, **common)


class Excitation(Equation):
    """Adds -X'' to the liquid's acceleration."""

    def post_loop(self, d_idx, d_au, d_push):
        d_au[d_idx] -= d_push[0]


class WallAcceleration(Equation):
    """Tells walls that extrapolate the pressure their acceleration X''; they stay."""

    def initialize(self, d_idx, d_au, d_push):
        d_au[d_idx] = d_push[0]


class Surface:
    """Finds the elevation at a place in the tank."""

    def __init__(self, tank, kernel, h, spacing):
        self.length, self.spacing, self.reach = tank["length_m"], spacing, kernel.radius_scale * h
        self.radii = np.linspace(0, self.reach, 2001)
        self.weights = np.array([kernel.kernel([0, 0, 0], r, h) for r in self.radii])

    def height(self, place, x, y, volume):
        x = np.concatenate([x, -x, 2 * self.length - x])
        near = np.abs(x - place) < self.reach
        x, y, volume = x[near], np.tile(y, 3)[near], np.tile(volume, 3)[near]
        if not len(x):
            raise RuntimeError(f"no liquid is near the gauge at x = {place:g} m")
        # The sum rises from 0 above the highest particle; the first 0.5 from above is the surface.
        top = y.max() + self.reach
        z = np.arange(top, 0, -self.spacing / 10)
        distances = np.hypot(x - place, y - z[:, None])
        sums = np.interp(distances, self.radii, self.weights, right=0) @ volume
        inside = np.flatnonzero(sums >= 0.5)
        if not len(inside):
            raise RuntimeError(f"the gauge at x = {place:g} m finds no surface")
        i = inside[0]
        return z[i] + (z[i - 1] - z[i]) * (sums[i] - 0.5) / (sums[i] - sums[i - 1])


def processor_time():
    """Of this process and of the compiler's."""
    return sum(os.times()[:4])


class Gauges(Tool):
    """Moves the tank, and records the elevations and when the time loop began."""

    def __init__(self, app):
        self.app, self.rows, self.began, self.next = app, [], None, 0.0
        self.surface = Surface(app.tank, app.kernel, app.h, app.spacing)

    def pre_step(self, solver):
        if self.began is None:
            self.began = time.time(), processor_time()
            self.record(0.0)
        motion = self.app.tank["motion"]
        push = np.interp(solver.t, motion["time_s"], motion["acceleration_x_m_s2"])
        for array in solver.particles:
            array.get("push")[0] = push

    def post_step(self, solver):
        if solver.t > self.next - 1e-9:
            self.record(solver.t)

    def record(self, t):
        tank, liquid = self.app.tank, self.app.liquid
        if not (np.isfinite(liquid.x).all() and np.isfinite(liquid.y).all()):
            raise RuntimeError(f"the positions are not finite at {t:g} s")
        volume, interval = liquid.m / tank["density_kg_m3"], tank["sample_interval_s"]
        self.rows.append([t] + [
            self.surface.height(gauge["x_m"], liquid.x, liquid.y, volume) - tank["fill_depth_m"]
            for gauge in tank["gauges"]])
        self.next = (np.floor(t / interval + 1e-6) + 1) * interval


class Tank(Application):
    def __init__(self, tank, directory, scheme, spacing):
        self.tank, self.scheme_name, self.spacing = tank, scheme, spacing
        self.numbers = SCHEMES[scheme]
        self.h = self.numbers.h_over_dp * spacing
        self.c0 = SOUND * np.sqrt(tank["gravity_m_s2"] * tank["fill_depth_m"])
        super().__init__(fname="pysph_tank", output_dir=directory)

    def create_scheme(self):
        self.kernel = self.numbers.kernel(dim=2)
        scheme = scheme_of(self.scheme_name, self.tank, self.h, self.c0)
        scheme.configure_solver(kernel=self.kernel, dt=self.numbers.time_step * self.h / self.c0,
                                tf=self.tank["duration_s"] + self.tank["sample_interval_s"],
                                pfreq=10**9)
        return scheme

    def level(self, x):
        """The surface at the start."""
        wave = self.tank["initial_wave"]
        waves = np.cos(wave["mode"] * np.pi * np.clip(x / self.tank["length_m"], 0, 1))
        return self.tank["fill_depth_m"] + wave["amplitude_m"] * waves

    def create_particles(self):
        tank, dp, rho0 = self.tank, self.spacing, self.tank["density_kg_m3"]
        layers, gamma = self.numbers.wall_layers, self.numbers.gamma
        columns, rows = round(tank["length_m"] / dp), round(tank["fill_depth_m"] / dp)
        i, j = np.meshgrid(np.arange(-layers, columns + layers),
                           np.arange(-layers, int(np.ceil(tank["height_m"] / dp))),
                           indexing="ij")
        inside = (i >= 0) & (i < columns) & (j >= 0)
        arrays = []
        for name, where in [("fluid", inside & (j < rows)), ("solid", ~inside)]:
            x, y = (i[where] + 0.5) * dp, (j[where] + 0.5) * dp
            # Each column of the liquid is stretched to the height of the initial wave.
            stretch = self.level(x) / tank["fill_depth_m"] if name == "fluid" else np.ones_like(x)
            y = y * stretch
            p = rho0 * tank["gravity_m_s2"] * np.maximum(self.level(x) - y, 0)
            rho = rho0 * np.ones_like(x)
            if gamma:  # Tait's equation of state
                rho *= (1 + gamma * p / (rho0 * self.c0**2)) ** (1 / gamma)
            arrays.append(get_particle_array(name=name, x=x, y=y, h=self.h, p=p, rho=rho,
                                             m=rho * dp**2 * stretch))
        self.scheme.setup_properties(arrays)
        for array in arrays:
            array.add_constant("push", 0.0)
        self.liquid, self.walls = arrays
        self.liquid.u[:] = tank["motion"]["initial_velocity_x_m_s"]
        return arrays

    def create_equations(self):
        equations = self.scheme.get_equations()
        equations[-1].equations.append(Excitation(dest="fluid", sources=None))
        if self.numbers.walls_extrapolate:
            equations.insert(0, Group([WallAcceleration(dest="solid", sources=None)], real=False))
        return equations

    def create_tools(self):
        self.gauges = Gauges(self)
        return [self.gauges]


def computed(tank, directory, scheme, spacing):
    """Returns the application after its last step."""
    app = Tank(tank, directory, scheme, spacing)
    app.run(argv=["--disable-output", "--no-openmp", "--quiet"])
    last = app.gauges.rows[-1][0]
    if last < tank["duration_s"]:
        raise RuntimeError(f"the run ended at {last:g} s of {tank['duration_s']:g} s")
    return app


def evaluations(integrator):
    """Counts those of the forces in a step of one of PySPH's integrators."""
    step = inspect.getsource(type(integrator).one_timestep)
    return step.count("self.compute_accelerations(")


def run(tank, directory, scheme, spacing):
    started = time.time(), processor_time()
    app = computed(tank, directory, scheme, spacing)
    ended, began, rows = (time.time(), processor_time()), app.gauges.began, app.gauges.rows
    with open(os.path.join(directory, "elevation.csv"), "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["t"] + [gauge["name"] for gauge in tank["gauges"]])
        table.writerows([f"{value:.9g}" for value in row] for row in rows)
    cost = {"schema_version": 1, "liquid_particles": app.liquid.get_number_of_particles(),
            "wall_particles": app.walls.get_number_of_particles(), "steps": app.solver.count,
            "evaluations_per_step": evaluations(app.solver.integrator),
            "speed_of_sound_m_s": float(app.c0), "smoothing_length_ratio": app.numbers.h_over_dp,
            "loop_wall_time_s": ended[0] - began[0],
            "loop_processor_time_s": ended[1] - began[1],
            "compile_wall_time_s": began[0] - started[0],
            "compile_processor_time_s": began[1] - started[1]}
    with open(os.path.join(directory, "cost.json"), "w", encoding="utf-8") as file:
        json.dump(cost, file, indent=1)


def main(arguments):
    if arguments == ["--version"]:
        print("PySPH " + pysph.__version__)
        return
    if len(arguments) != 4 or arguments[2] not in SCHEMES:
        sys.exit(f"usage: {sys.argv[0]} TANK.json DIRECTORY ({' | '.join(SCHEMES)}) SPACING_M")
    try:
        with open(arguments[0], encoding="utf-8") as file:
            run(json.load(file), arguments[1], arguments[2], float(arguments[3]))
    except Exception as error:  # whatever PySPH throws, the run has failed
        sys.exit(f"pysph_tank: {type(error).__name__}: {error}")


if __name__ == "__main__":
    main(sys.argv[1:])
