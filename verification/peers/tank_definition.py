"""What a tank's JSON file says, read with a message that names key, value, expectation and file."""
import json
import math
import os


class BadInput(Exception):
    pass


class Table:
    def __init__(self, values, place, path=""):
        if not isinstance(values, dict):
            raise BadInput(f"{place}: {path.rstrip('.') or 'the file'} = {values!r}: expected a table")
        self.values, self.place, self.path = values, place, path

    def refuse(self, key, expected):
        value = self.values.get(key, "missing")
        raise BadInput(f"{self.place}: {self.path}{key} = {value!r}: expected {expected}")

    def allow_only(self, *keys):
        for key in self.values:
            if key not in keys:
                self.refuse(key, "one of the keys " + ", ".join(keys))

    def number(self, key, unit, positive=False):
        value = self.values.get(key)
        kind = "a number > 0" if positive else "a finite number"
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(
                value) or (positive and value <= 0):
            self.refuse(key, f"{kind}, {unit}")
        return float(value)

    def numbers(self, key, unit):
        values = self.values.get(key)
        if not isinstance(values, list) or len(values) < 2:
            self.refuse(key, f"a list of two or more numbers, {unit}")
        row = Table(dict(enumerate(values)), self.place, f"{self.path}{key}.")
        return [row.number(i, unit) for i in range(len(values))]

    def choice(self, key, choices):
        if self.values.get(key) not in choices:
            self.refuse(key, "one of " + ", ".join(choices))
        return self.values[key]

    def table(self, key):
        return Table(self.values.get(key), self.place, f"{self.path}{key}.")


def ramped_sine_acceleration(t, omega, ramp_end):
    """The second derivative of r(t/ramp_end) sin(omega t), r(s) = 10 s^3 - 15 s^4 + 6 s^5 up to 1,
    which is the ramp of a case file's sine."""
    ramp, rate, curvature = 1.0, 0.0, 0.0
    if t < ramp_end:
        s = t / ramp_end
        ramp = s**3 * (10 - 15 * s + 6 * s * s)
        rate = 30 * s * s * (1 - s)**2 / ramp_end
        curvature = 60 * s * (1 - s) * (1 - 2 * s) / ramp_end**2
    return ((curvature - ramp * omega**2) * math.sin(omega * t)
            + 2 * rate * omega * math.cos(omega * t))


class Motion:
    """The tank's velocity at 0 s and its acceleration X''(t), from a sine or from a table."""

    def __init__(self, table):
        if table.choice("type", ["sine", "table"]) == "sine":
            table.allow_only("type", "amplitude_m", "angular_frequency_rad_s", "ramp_periods")
            amplitude = table.number("amplitude_m", "m")
            omega = table.number("angular_frequency_rad_s", "rad/s", positive=True)
            periods = table.number("ramp_periods", "periods")
            if periods < 0:
                table.refuse("ramp_periods", "a number >= 0, periods")
            ramp_end = periods * 2 * math.pi / omega
            self.initial_velocity = amplitude * omega if ramp_end == 0 else 0.0
            self.acceleration = lambda t: amplitude * ramped_sine_acceleration(t, omega, ramp_end)
            self.end = math.inf
        else:
            table.allow_only("type", "time_s", "acceleration_m_s2", "initial_velocity_m_s")
            times = table.numbers("time_s", "s")
            values = table.numbers("acceleration_m_s2", "m/s2")
            if times[0] != 0 or any(b <= a for a, b in zip(times, times[1:])):
                table.refuse("time_s", "rising times from 0 s on")
            if len(values) != len(times):
                table.refuse("acceleration_m_s2", f"{len(times)} numbers, one at each time")
            self.initial_velocity = table.number("initial_velocity_m_s", "m/s")
            self.end = times[-1]
            from numpy import interp
            self.acceleration = lambda t: float(interp(t, times, values))


class Definition:
    """A rectangular tank that surges; x from its left wall, z from its bottom."""

    def __init__(self, path, schemes):
        try:
            with open(path, encoding="utf-8") as file:
                values = json.load(file)
        except (OSError, ValueError) as error:
            raise BadInput(f"{path}: expected a JSON file: {error}") from error
        table = Table(values, os.path.basename(path))
        table.allow_only("length_m", "height_m", "depth_m", "gravity_m_s2", "density_kg_m3", "motion",
                         "gauges_m", "duration_s", "sample_interval_s", "spacing_m", "scheme")
        self.length = table.number("length_m", "m", positive=True)
        self.height = table.number("height_m", "m", positive=True)
        self.depth = table.number("depth_m", "m", positive=True)
        if self.depth >= self.height:
            table.refuse("depth_m", f"a depth below the height of {self.height:g} m")
        self.gravity = table.number("gravity_m_s2", "m/s2", positive=True)
        self.density = table.number("density_kg_m3", "kg/m3", positive=True)
        self.duration = table.number("duration_s", "s", positive=True)
        self.sample_interval = table.number("sample_interval_s", "s", positive=True)
        self.spacing = table.number("spacing_m", "m", positive=True)
        for key, size in [("length_m", self.length), ("depth_m", self.depth)]:
            if abs(size / self.spacing - round(size / self.spacing)) > 1e-6 or size < self.spacing:
                table.refuse(key, f"a whole number of spacings of {self.spacing:g} m")
        self.scheme = table.choice("scheme", schemes)
        self.motion = Motion(table.table("motion"))
        if self.motion.end < self.duration:
            table.refuse("motion", f"a motion up to {self.duration:g} s; it ends at "
                                   f"{self.motion.end:g} s")
        gauges = table.table("gauges_m")
        self.gauges = {name: gauges.number(name, "m") for name in gauges.values}
        if not self.gauges:
            table.refuse("gauges_m", "at least one gauge")
        for name, x in self.gauges.items():
            if not 0 <= x <= self.length:
                gauges.refuse(name, f"a place from 0 to {self.length:g} m")
