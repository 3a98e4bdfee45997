#include "verification/case/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "verification/case/motion.hpp"
#include "verification/case/shape/tank_shape.hpp"

namespace slosh {
namespace {

bool is_dam_break(const CaseDefinition& definition) {
  return definition.liquid.column_width.has_value();
}

bool rolls(const CaseDefinition& definition) { return definition.motion.roll.has_value(); }

constexpr const char *on_tank = "On the tank, per metre of width, along the tank's axes.",
                     *on_wall = "On this wall alone, per metre of width, along the tank's axes.",
                     *at_probe =
                         "Relative to the tank, along its axes; zero while the place is dry.",
                     *momentum =
                         "Of the liquid against the earth, along the earth's axes, per "
                         "metre of width.";

// A load of the liquid on the tank: SPH, interFoam and theory obtain all of them alike.
Quantity load(Quantity quantity) {
  quantity.shown_unit = quantity.unit;
  quantity.sph = "the reaction to the forces of the walls on the particles";
  quantity.interfoam = "the load of liquid and gas on walls and obstacles";
  quantity.theory =
      "the liquid's pressure on the walls and the bottom up to the still surface; of two layers, "
      "the gas's too";
  quantity.tells_sampling = true;
  return quantity;
}

// The load on one wall. The solvers obtain it as that on the tank.
Quantity wall_load(Quantity quantity) {
  quantity.shown_unit = quantity.unit;
  quantity.meaning = on_wall;
  quantity.sph = "the reaction to the forces of the images or the particles of this wall";
  quantity.interfoam = "the load of liquid and gas on this wall";
  quantity.theory = "the liquid's pressure on this wall up to the surface";
  quantity.tells_sampling = true;
  return quantity;
}

Quantity probed_velocity(Quantity quantity) {
  quantity.shown_unit = quantity.unit;
  quantity.has_modes = true;
  quantity.is_gauged = true;
  quantity.meaning = at_probe;
  quantity.sph = "linear fit to the particles within three spacings";
  quantity.interfoam = "interpolated between the centres of the cells";
  return quantity;
}

std::string series_name(const Quantity& quantity, const std::string& gauge) {
  return std::string(quantity.name) + "@" + gauge;
}

std::string wall_name(Wall wall) { return name_of(wall, wall_names); }

// Whether a quantity of this wall's name, "left" or "WALL" as in lists of names, can exist.
bool is_wall(const std::string& name) {
  return name == "WALL" ||
         std::any_of(std::begin(wall_names), std::end(wall_names),
                     [&](const EnumName<Wall>& wall) { return wall.name == name; });
}

// The component that acts normal to a wall. Runs are compared on it alone: the other one, the
// friction, is zero at every wall along which the liquid slides.
std::string normal_force(Wall wall) {
  return wall == Wall::left || wall == Wall::right ? "force_x" : "force_z";
}

const char* placeholder(MeasuredAt at) {
  return at == MeasuredAt::probe ? "PROBE" : at == MeasuredAt::wall ? "WALL" : "GAUGE";
}

// Adds the series of a pressure gauge, which has a filtered one beside it if it has a filter.
void add_series(const Quantity& quantity, const PressureGaugeDefinition& gauge,
                std::vector<std::string>& series) {
  series.push_back(series_name(quantity, gauge.name));
  if (gauge.filter_cutoff) series.push_back(series_name(quantity, gauge.name) + through_filter);
}

}  // namespace

const std::vector<Quantity>& quantity_table() {
  static const std::vector<Quantity> table{
      {.name = "front_position",
       .unit = "m",
       .at = MeasuredAt::tank,
       .exists_in = is_dam_break,
       .title = "Front of the breaking dam, from the left wall",
       .label = "front position",
       .shown_unit = "mm",
       .shown_per_si = 1000},
      {.name = "elevation",  // above the still level
       .unit = "m",
       .at = MeasuredAt::surface_gauge,
       .has_modes = true,
       .is_gauged = true,
       .amplitude = "elevation amplitude",
       .title = "Surface elevation",
       .label = "elevation",
       .shown_unit = "mm",
       .shown_per_si = 1000,
       .sph = "the depth of liquid over the gauge, drops and overturning jets included, minus "
              "the still depth",
       .interfoam = "the liquid in the column of cells at the gauge, minus the still depth"},
      {.name = "wall_pressure",
       .unit = "Pa",
       .at = MeasuredAt::pressure_gauge,
       .has_modes = true,
       .is_gauged = true,
       .amplitude = "wall pressure amplitude",
       .title = "Pressure",
       .label = "pressure",
       .shown_unit = "Pa",
       .meaning = "Pressure above that of the gas",  // the sensor's size follows
       .sph =
           "kernel average over three spacings, extrapolated to the wall by the pressure gradient",
       .interfoam = "interpolated between the wall's faces, minus the mean gas pressure",
       .tells_sampling = true},
      probed_velocity({.name = "velocity_x",
                       .unit = "m/s",
                       .at = MeasuredAt::probe,
                       .title = "Velocity along the tank's bottom",
                       .label = "velocity x"}),
      probed_velocity({.name = "velocity_z",
                       .unit = "m/s",
                       .at = MeasuredAt::probe,
                       .title = "Velocity normal to the tank's bottom",
                       .label = "velocity z"}),
      {.name = "pressure",
       .unit = "Pa",
       .at = MeasuredAt::probe,
       .has_modes = true,
       .is_gauged = true,
       .title = "Pressure",
       .label = "pressure",
       .shown_unit = "Pa",
       .meaning = "Pressure above that of the gas; zero while the place is dry.",
       .sph = "kernel average over three spacings, extrapolated by the pressure gradient",
       .interfoam = "interpolated between the centres of the cells, minus the mean gas pressure",
       .tells_sampling = true},
      load({.name = "force_x",
            .unit = "N/m",
            .at = MeasuredAt::tank,
            .has_modes = true,
            .amplitude = "force amplitude",
            .title = "Force along the tank's bottom",
            .label = "force x",
            .meaning = on_tank}),
      load({.name = "force_z",
            .unit = "N/m",
            .at = MeasuredAt::tank,
            .title = "Force normal to the tank's bottom",
            .label = "force z",
            .meaning = on_tank}),
      wall_load({.name = "force_x",
                 .unit = "N/m",
                 .at = MeasuredAt::wall,
                 .has_modes = true,
                 .title = "Force along the tank's bottom",
                 .label = "force x"}),
      wall_load({.name = "force_z",
                 .unit = "N/m",
                 .at = MeasuredAt::wall,
                 .title = "Force normal to the tank's bottom",
                 .label = "force z"}),
      load({.name = "moment",  // about the axis of the roll
            .unit = "N",
            .at = MeasuredAt::tank,
            .exists_in = rolls,
            .has_modes = true,
            .amplitude = "moment amplitude",
            .title = "Moment about the roll's axis",
            .label = "moment",
            .meaning = "On the tank, per metre of width, counter-clockwise."}),
      {.name = "momentum_x",
       .unit = "kg/s",
       .at = MeasuredAt::tank,
       .has_modes = true,
       .amplitude = "momentum amplitude",
       .title = "Total momentum, horizontal",
       .label = "momentum x",
       .shown_unit = "kg/s",
       .meaning = momentum},
      {.name = "momentum_z",
       .unit = "kg/s",
       .at = MeasuredAt::tank,
       .title = "Total momentum, vertical",
       .label = "momentum z",
       .shown_unit = "kg/s",
       .meaning = momentum},
      {.name = "highest_surface",  // above the still level, of whatever is wet
       .unit = "m",
       .at = MeasuredAt::surface_gauge,
       .has_modes = true,
       .title = "Highest surface",
       .label = "highest surface",
       .shown_unit = "mm",
       .shown_per_si = 1000,
       .label_over_depth = "highest surface, η/h [1]",
       .meaning = "Of whatever is wet over the gauge, above the still level.",
       .sph = "the upper edge of the highest particle within a spacing",
       .interfoam = "the highest place of the column where a cell is half full"}};
  return table;
}

const Quantity* find_quantity(const std::string& series) {
  const std::size_t at = series.find('@');
  const std::string name = series.substr(0, at);
  const bool has_gauge = at != std::string::npos;
  for (const Quantity& one : quantity_table())
    if (one.name == name && (one.at != MeasuredAt::tank) == has_gauge &&
        (one.at != MeasuredAt::wall || is_wall(series.substr(at + 1))))
      return &one;
  return nullptr;
}

std::vector<std::string> compared_quantities(const CaseDefinition& definition) {
  std::vector<std::string> series;
  for (const Quantity& quantity : quantity_table()) {
    if (quantity.exists_in && !quantity.exists_in(definition)) continue;
    if (quantity.at == MeasuredAt::tank) series.push_back(quantity.name);
    if (quantity.at == MeasuredAt::surface_gauge)
      for (const GaugeDefinition& gauge : definition.gauges)
        series.push_back(series_name(quantity, gauge.name));
    if (quantity.at == MeasuredAt::pressure_gauge)
      for (const PressureGaugeDefinition& gauge : definition.pressure_gauges)
        add_series(quantity, gauge, series);
    if (quantity.at == MeasuredAt::probe)
      for (const ProbeDefinition& probe : definition.probes)
        series.push_back(series_name(quantity, probe.name));
    if (quantity.at == MeasuredAt::wall)
      for (const Wall wall : definition.wall_forces)
        if (quantity.name == normal_force(wall))
          series.push_back(series_name(quantity, wall_name(wall)));
  }
  return series;
}

bool is_filtered(const std::string& series) { return series.ends_with(through_filter); }

std::string wall_pressure(const std::string& gauge) { return "wall_pressure@" + gauge; }

std::string smoothest_pressure(const PressureGaugeDefinition& gauge) {
  return wall_pressure(gauge.name) + (gauge.filter_cutoff ? through_filter : "");
}

std::vector<std::string> impact_pressures(const CaseDefinition& definition) {
  const std::string& impacts_gauge = definition.impacts.value().gauge;
  std::vector<std::string> series;
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges)
    for (const Quantity& quantity : quantity_table())
      if (gauge.name == impacts_gauge && quantity.at == MeasuredAt::pressure_gauge)
        add_series(quantity, gauge, series);
  return series;
}

std::string unit_of(const std::string& series) {
  if (const Quantity* quantity = find_quantity(series)) return quantity->unit;
  throw std::invalid_argument("no compared quantity: " + series);
}

double largest_in_tank(const CaseDefinition& definition, const std::string& unit) {
  const double length = definition.tank.length, height = definition.tank.height,
               sides = length + height;
  const SurgeMotion surge = surge_motion(definition);
  const std::optional<RollMotion> roll = roll_motion(definition);
  const double reach =
      roll ? sides + std::hypot(roll->axis_x, roll->axis_z) : 0;  // from the axis of the roll
  double of_tank = 0;
  constexpr int times = 1000;
  for (int i = 0; i <= times; ++i) {
    const double time = definition.duration * i / times;
    of_tank = std::max(
        of_tank, std::abs(surge.velocity(time)) + (roll ? reach * std::abs(roll->rate(time)) : 0));
  }
  constexpr double faster = 10, speed_of_sound = 1500;  // [1], [m/s]
  const double speed = std::sqrt(2 * definition.gravity * sides) + of_tank;
  const double pressure = definition.liquid.density * speed_of_sound * speed;
  if (unit == "m") return std::max(length, height);
  if (unit == "m/s") return faster * speed;
  if (unit == "Pa") return pressure;
  if (unit == "N/m") return pressure * sides;
  if (unit == "N") return pressure * sides * sides;
  if (unit == "kg/s") return definition.liquid.density * liquid_area(definition) * faster * speed;
  return 1e9;
}

std::vector<double> resting_values(const CaseDefinition& definition, const std::string& series) {
  const Quantity* quantity = find_quantity(series);
  if (!quantity) return {};
  if (quantity->unit == std::string("Pa") || quantity->at == MeasuredAt::wall) return {0};
  const TankDefinition& tank = definition.tank;
  std::vector<double> values;
  if (quantity->name == std::string("front_position")) {
    values = {tank.length};
    for (const ObstacleDefinition& one : definition.obstacles) values.push_back(one.left);
  } else if (quantity->at == MeasuredAt::surface_gauge) {
    values = {0, tank.height};
    for (const ObstacleDefinition& one : definition.obstacles)
      values.insert(values.end(), {one.bottom, one.top});
    for (const Corner& corner : tank.outline) values.push_back(corner.z);
    for (double& value : values) value -= definition.liquid.fill_depth;
  }
  return values;
}

std::vector<std::string> quantity_names() {
  std::vector<std::string> names;
  for (const Quantity& one : quantity_table())
    names.push_back(one.at == MeasuredAt::tank ? one.name : series_name(one, placeholder(one.at)));
  return names;
}

bool has_modes(const std::string& series) {
  const Quantity* quantity = find_quantity(series);
  return quantity && quantity->has_modes;
}

bool is_gauged(const std::string& series) {
  const Quantity* quantity = find_quantity(series);
  return quantity && quantity->is_gauged;
}

std::vector<int> natural_modes(const CaseDefinition& definition, int count) {
  std::vector<int> modes;
  if (definition.gravity == 0) return modes;
  if (definition.initial_wave) modes.push_back(definition.initial_wave->mode);
  const bool wave_alone = definition.motion.still() && definition.initial_wave;
  const int step = excited_mode_step(definition.tank);
  for (int n = 0; n < count && !wave_alone; ++n) modes.push_back(step * n + 1);
  std::sort(modes.begin(), modes.end());
  modes.erase(std::unique(modes.begin(), modes.end()), modes.end());
  modes.resize(std::min<std::size_t>(modes.size(), count));
  return modes;
}

}  // namespace slosh
