// What a case file alone determines: the tank to scale, and its motion over time.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "reports/figures/case_figures.hpp"
#include "reports/wording/case_text.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/motion/motion_times.hpp"
#include "verification/case/shape/sensor_place.hpp"
#include "verification/case/shape/tank_shape.hpp"

namespace slosh {
namespace {

using reports::Curve;
using reports::Figure;
using reports::Look;

constexpr Look of_tank{true, 0, 0}, of_moved{true, 1, 0}, of_sensor{false, 1, 0},
    of_probe{false, 2, 1}, of_axis{false, 3, 2};

// Those of a closed line begin and end with the same place.
void add_places(const std::string& label, const std::vector<Corner>& places, Curve::Style style,
                Look look, Figure& figure) {
  if (places.empty()) return;
  Curve curve{.label = label, .style = style, .look = look};
  for (const Corner& place : places) {
    curve.x.push_back(place.x);
    curve.y.push_back(place.z);
  }
  figure.curves.push_back(std::move(curve));
}

void add_closed(const std::string& label, Outline corners, Curve::Style style, Look look,
                Figure& figure) {
  corners.push_back(corners.front());
  add_places(label, corners, style, look, figure);
}

// The liquid at the start, between the bottom and its surface.
Curve liquid(const CaseDefinition& definition, const Outline& outline) {
  constexpr int places = 200;
  const double depth = definition.liquid.fill_depth, length = definition.tank.length,
               right = definition.liquid.column_width.value_or(length);
  Curve curve{.label = fmt::format("liquid at the start, {:g} m deep", depth), .ribbon = "liquid"};
  for (int i = 0; i <= places; ++i) {
    const double x = right * i / places;
    double bottom = definition.tank.height, top = 0, level = depth;
    for (std::size_t side = 0; side < outline.size(); ++side) {
      const Corner &a = outline[side], &b = outline[(side + 1) % outline.size()];
      if (std::min(a.x, b.x) > x || std::max(a.x, b.x) < x) continue;
      const double slope = a.x == b.x ? 0 : (b.z - a.z) / (b.x - a.x),
                   one = a.x == b.x ? a.z : a.z + slope * (x - a.x), other = a.x == b.x ? b.z : one;
      bottom = std::min({bottom, one, other});
      top = std::max({top, one, other});
    }
    if (const auto& wave = definition.initial_wave)
      level += wave->amplitude * std::cos(wave->mode * std::numbers::pi * x / length);
    curve.x.push_back(x);
    curve.lower.push_back(std::min(bottom, level));
    curve.y.push_back(bottom < level ? std::min(level, top) : not_a_number);
    curve.upper.push_back(std::max(curve.lower.back(), std::min(level, top)));
  }
  return curve;
}

// The tank where its roll or, without one, its surge is largest, if it is then near its start.
void add_moved(const CaseDefinition& definition, const Outline& outline, Figure& figure) {
  const auto surge = surge_motion(definition).displacement;
  const auto roll = roll_motion(definition);
  const double time = peak_of(definition, roll ? roll->angle : surge).time, shift = surge(time),
               angle = roll ? roll->angle(time) : 0;
  Outline moved = outline;
  double farthest = 0;
  for (Corner& corner : moved) {
    const double x = corner.x - (roll ? roll->axis_x : 0), z = corner.z - (roll ? roll->axis_z : 0),
                 dx = x * (std::cos(angle) - 1) - z * std::sin(angle) + shift,
                 dz = x * std::sin(angle) + z * (std::cos(angle) - 1);
    corner = {corner.x + dx, corner.z + dz};
    farthest = std::max(farthest, std::hypot(dx, dz));
  }
  if (farthest < definition.tank.length)
    add_closed(fmt::format("the tank at {:.3g} s, farthest from its start", time), moved,
               Curve::Style::dashed, of_moved, figure);
}

// Of the curves that set the scale.
void set_ranges(Figure& figure) {
  double left = 0, right = 0, bottom = 0, top = 0;
  for (const Curve& curve : figure.curves) {
    if (!curve.sets_scale) continue;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      left = std::min(left, curve.x[i]);
      right = std::max(right, curve.x[i]);
      bottom = std::min(bottom, std::isnan(curve.y[i]) ? 0 : curve.y[i]);
      top = std::max(top, std::isnan(curve.y[i]) ? 0 : curve.y[i]);
    }
  }
  const double margin = 0.03 * (right - left);
  figure.x_range = {left - margin, right + margin};
  figure.y_range = {bottom - margin, top + margin};
}

// A history of the motion, with its largest magnitude. Its id is the word with a - for each blank.
Figure of_motion(const CaseDefinition& definition, const std::string& word,
                 const std::string& title, const std::string& unit,
                 const std::function<double(double)>& motion, double scale = 1) {
  Curve curve{.label = word, .x = motion_times(definition, definition.sample_interval)};
  for (const double time : curve.x) curve.y.push_back(scale * motion(time));
  const MotionPeak peak = peak_of(definition, motion);
  Curve largest{
      .label = fmt::format("peak, {:.3g} {} at {:.3g} s", scale * peak.value, unit, peak.time),
      .x = {peak.time},
      .y = {scale * peak.value},
      .style = Curve::Style::points};
  Figure figure{.id = word,
                .title = title,
                .caption = "As prescribed to every run.",
                .x_label = "time [s]",
                .y_label = fmt::format("{} [{}]", word, unit),
                .x_range = {0, definition.duration},
                .curves = {std::move(curve), std::move(largest)}};
  std::ranges::replace(figure.id, ' ', '-');
  figure.id = case_id(definition.name) + "-" + figure.id;
  return figure;
}

}  // namespace

Figure tank_figure(const CaseDefinition& definition) {
  const Outline outline = corners_of(definition.tank);
  Figure figure{
      .id = case_id(definition.name) + "-tank",
      .title = "The tank and its gauges",
      .caption =
          "To scale; x counts from the left wall and z from the bottom. A surge is positive "
          "to the right, a roll counter-clockwise. Dotted lines are gauges of the surface. "
          "The tank " +
          std::string(definition.motion.still() ? "is " : "moves by ") + motion_text(definition) +
          motion_peaks(definition) + ".",
      .x_label = "x [m]",
      .y_label = "z [m]",
      .curves = {liquid(definition, outline)},
      .to_scale = true};
  add_closed("tank", outline, Curve::Style::line, of_tank, figure);
  for (const ObstacleDefinition& one : definition.obstacles)
    add_closed("obstacle " + one.name,
               {{one.left, one.bottom},
                {one.right, one.bottom},
                {one.right, one.top},
                {one.left, one.top}},
               Curve::Style::line, of_tank, figure);
  if (!definition.motion.still()) add_moved(definition, outline, figure);
  std::vector<Corner> sensors, probes;
  std::vector<std::string> sensor_names, probe_names;
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges) {
    sensors.push_back(sensor_middle(definition.tank, gauge));
    sensor_names.push_back(gauge.name);
  }
  for (const ProbeDefinition& probe : definition.probes) {
    probes.push_back({probe.x, probe.z});
    probe_names.push_back(probe.name);
  }
  add_places(fmt::format("pressure sensors {}", fmt::join(sensor_names, ", ")), sensors,
             Curve::Style::points, of_sensor, figure);
  add_places(fmt::format("probes {}", fmt::join(probe_names, ", ")), probes, Curve::Style::points,
             of_probe, figure);
  if (const auto& roll = definition.motion.roll) {
    add_places("axis of the roll", {{roll->axis_x, roll->axis_z}}, Curve::Style::points, of_axis,
               figure);
    figure.curves.back().sets_scale = std::hypot(roll->axis_x, roll->axis_z) <
                                      2 * (definition.tank.length + definition.tank.height);
  }
  for (const GaugeDefinition& gauge : definition.gauges)
    figure.markers.push_back({gauge.name, gauge.x});
  set_ranges(figure);
  return figure;
}

std::vector<Figure> motion_figures(const CaseDefinition& definition) {
  std::vector<Figure> figures;
  const auto add = [&](auto&&... parts) { figures.push_back(of_motion(definition, parts...)); };
  const SurgeMotion surge = surge_motion(definition);
  const bool is_small = definition.tank.length < 5;  // [m]
  if (definition.motion.surge) {
    add("surge", "Surge of the tank", is_small ? "mm" : "m", surge.displacement,
        is_small ? 1000 : 1);
    add("surge speed", "Speed of the surge", "m/s", surge.velocity);
    add("surge acceleration", "Acceleration of the surge", "m/s2", surge.acceleration);
  }
  if (const auto roll = roll_motion(definition)) {
    constexpr double degrees = 1 / radians_per_degree;
    add("roll", "Roll of the tank", "deg", roll->angle, degrees);
    add("roll speed", "Speed of the roll", "deg/s", roll->rate, degrees);
    add("roll acceleration", "Acceleration of the roll", "deg/s2", roll->acceleration, degrees);
  }
  return figures;
}

}  // namespace slosh
