#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "verification/case/motion.hpp"
#include "verification/case/shape/outline.hpp"
#include "verification/case/shape/sensor_place.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/case_sections.hpp"

namespace slosh {

using namespace key;
using namespace needed;

namespace {

// A gauge has no surface to measure if an obstacle fills its column from the bottom to the still
// level.
void refuse_swallowed_gauges(const TomlTable& table, const ObstacleDefinition& obstacle,
                             const CaseDefinition& definition) {
  if (obstacle.bottom > 0 || obstacle.top < definition.liquid.fill_depth) return;
  for (const GaugeDefinition& gauge : definition.gauges) {
    if (gauge.x < obstacle.left || gauge.x > obstacle.right) continue;
    table.refuse("top_m", fmt::format("a number below the fill depth ({}), in m, or another place: "
                                      "the obstacle swallows the gauge {} at {} m",
                                      definition.liquid.fill_depth, gauge.name, gauge.x));
  }
}

// A sensor that touches an obstacle at its wall measures the obstacle.
void refuse_covered_sensors(const TomlTable& table, const ObstacleDefinition& obstacle,
                            const CaseDefinition& definition) {
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges) {
    const auto [first, last] = sensor_ends(definition.tank, gauge);
    if (last.x >= obstacle.left && first.x <= obstacle.right && last.z >= obstacle.bottom &&
        first.z <= obstacle.top)
      table.refuse("name", fmt::format("an obstacle elsewhere: it covers the pressure gauge {} at "
                                       "{} m",
                                       gauge.name, gauge.position));
  }
}

void refuse_swallowed_probes(const TomlTable& table, const ObstacleDefinition& obstacle,
                             const CaseDefinition& definition) {
  for (const ProbeDefinition& probe : definition.probes)
    if (probe.x >= obstacle.left && probe.x <= obstacle.right && probe.z >= obstacle.bottom &&
        probe.z <= obstacle.top)
      table.refuse("name", fmt::format("an obstacle elsewhere: it holds the probe {} at ({}, {}) m",
                                       probe.name, probe.x, probe.z));
}

bool overlap(const ObstacleDefinition& a, const ObstacleDefinition& b) {
  return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

// Trough and crest have the same height: the trough must leave the bottom covered, and the crest
// must stay below the roof.
Rule<double> within_liquid(const CaseDefinition& definition) {
  const double depth = definition.liquid.fill_depth, room = definition.tank.height - depth,
               most = std::min(depth, room);
  return {fmt::format("a number other than 0 of a magnitude below {:.6g}, in m: shallower than the "
                      "liquid ({}) and below the roof ({} above it)",
                      most, depth, room),
          [most](double amplitude) { return amplitude != 0 && std::abs(amplitude) < most; }};
}

// Whether the tank is no rectangle.
bool tells_outline(const TomlTable& tank) {
  return tank.has("outline_m") || tank.has("diameter_m");
}

bool is_told_by_sides(const TomlTable& tank) { return !tells_outline(tank); }

// More modes of a section would need finer elements than the reference has.
constexpr int most_section_modes = 150;

// The key of [tank] that tells the outline.
std::string outline_key(const CaseDefinition& definition) {
  return definition.tank.diameter ? "tank.diameter_m" : "tank.outline_m";
}

// Every side is compared with every other one; a circle of as many corners has its area to 1e-5.
constexpr std::size_t most_corners = 1000;

Outline read_corners(const TomlTable& tank) {
  Outline outline;
  for (const auto& [x, z] : tank.pairs("outline_m", "a corner [x, z] of two finite numbers, in m"))
    outline.push_back({x, z});
  if (outline.size() < 3 || outline.size() > most_corners)
    tank.refuse("outline_m", fmt::format("3 to {} corners [x, z], in m, where these are {}",
                                         most_corners, outline.size()));
  return outline;
}

// The tank's frame begins at the left end and at the lowest place of its outline.
void refuse_other_origin(const TomlTable& tank, const Outline& outline) {
  const auto refuse_unless_zero = [&](double Corner::*coordinate, const char* name) {
    const auto least = std::min_element(outline.begin(), outline.end(),
                                        [&](const Corner& one, const Corner& other) {
                                          return one.*coordinate < other.*coordinate;
                                        });
    if ((*least).*coordinate != 0)
      tank.refuse_element("outline_m", static_cast<std::size_t>(least - outline.begin()),
                          fmt::format("corners whose smallest {0} is 0, in m, where this {0} is "
                                      "the smallest",
                                      name));
  };
  refuse_unless_zero(&Corner::x, "x");
  refuse_unless_zero(&Corner::z, "z");
}

void refuse_impossible_shape(const TomlTable& tank, const Outline& outline) {
  if (const auto sides = crossing_sides(outline))
    tank.refuse("outline_m",
                fmt::format("sides that meet at their common corners alone, where the sides that "
                            "begin at the corners {} and {} meet elsewhere",
                            sides->first + 1, sides->second + 1));
  if (!(signed_area(outline) > 0))
    tank.refuse("outline_m", "corners in counter-clockwise order, where these are clockwise");
  if (!is_in_one_piece_at_each_level(outline))
    tank.refuse("outline_m",
                "a tank that each horizontal line cuts in two places at most, so that its liquid "
                "has one surface");
}

// The corners, or the diameter of a lying cylinder.
void read_outline(const TomlTable& tank, const CaseDefinition&, TankDefinition& read) {
  if (!tells_outline(tank)) return;
  const std::string key = tank.has("outline_m") ? "outline_m" : "diameter_m";
  for (const char* other : {"length_m", "height_m", "diameter_m"})
    if (other != key && tank.has(other))
      tank.refuse(other,
                  fmt::format("no {} beside {}, which tells the tank's whole shape", other, key));
  if (key == "diameter_m") {
    read.diameter = tank.get("diameter_m", positive("m"));
    read.outline = cylinder_outline(*read.diameter);
  } else {
    read.outline = read_corners(tank);
    refuse_other_origin(tank, read.outline);
    refuse_impossible_shape(tank, read.outline);
  }
  for (const Corner& corner : read.outline) {
    read.length = std::max(read.length, corner.x);
    read.height = std::max(read.height, corner.z);
  }
}

void refuse_places(const TomlTable& table, const CaseDefinition& definition,
                   const ObstacleDefinition& obstacle) {
  if (obstacle.left == 0 && obstacle.right == definition.tank.length)
    table.refuse("right_m", fmt::format("a number below the tank's length ({}), in m, for an "
                                        "obstacle from the left wall: it must leave a way past it",
                                        definition.tank.length));
  refuse_swallowed_gauges(table, obstacle, definition);
  refuse_covered_sensors(table, obstacle, definition);
  refuse_swallowed_probes(table, obstacle, definition);
}

void refuse_wave(const TomlTable& wave, const CaseDefinition& definition,
                 const InitialWaveDefinition&) {
  if (definition.liquid.column_width)
    wave.refuse_table("a wave on a dam about to break",
                      "liquid without column_width_m, which stands from wall to wall");
  if (!definition.obstacles.empty())
    wave.refuse_table("a wave over an [[obstacle]]",
                      "a tank without one, whose modes are cosines from wall to wall");
}

}  // namespace

const FieldTable<TankDefinition> tank_keys{
    {"tank", "[tank]", "yes",
     "A tank, seen from the side: a rectangle, a polygon or a lying cylinder. x counts from its "
     "left end and z from its lowest place. Beside outline_m or diameter_m there is no obstacle, "
     "no initial wave and no column_width_m, and only the solvers sph, interfoam, "
     "interisofoam, compressible_interfoam, linear, record, external and stored take "
     "the case."},
    {field("length_m", &TankDefinition::length, number("m").above(0),
           one_of_three().when(is_told_by_sides), "The inner length."),
     field("height_m", &TankDefinition::height, number("m").above(0),
           beside("length_m").when(is_told_by_sides), "The inner height, to the roof."),
     {{"outline_m", KeyValue{KeyKind::corners, "list of corners [x, z], m"}, one_of_three(),
       "The corners of the inner outline, counter-clockwise: 3 to 1000, with the smallest x and "
       "the smallest z 0. The sides meet at the corners alone, and each horizontal line cuts the "
       "outline in two places at most."}},
     {{"diameter_m", number("m").above(0), one_of_three(),
       "The diameter of a lying cylinder. The tank is a regular polygon of 128 corners, flat at "
       "the bottom, with the area of the circle; its length and height are 0.9999 diameters."}},
     field("breadth_m", &TankDefinition::breadth, number("m").above(0), no,
           "The inner breadth of a narrow tank, between the two gap walls, which are parallel to "
           "the section. With it, SPH, "
           "interFoam and interIsoFoam count the friction of these two walls, which they do not "
           "see otherwise; the theories and compressibleInterFoam, which have no friction there, "
           "are refused, but for a run of the latter in three dimensions (cells_y). Beside "
           "outline_m or diameter_m the motion must have a single frequency. Default: no "
           "friction.")},
    read_outline};

const FieldTable<LiquidDefinition> liquid_keys{
    {"liquid", "[liquid]", "yes", ""},
    {field("fill_depth_m", &LiquidDefinition::fill_depth, number("m").above(0).below(tank_height),
           yes, "The still depth."),
     field("density_kg_m3", &LiquidDefinition::density, number("kg/m3").above(0),
           beside("kinematic_viscosity_m2_s"),
           fmt::format("Without both the liquid is water at 20 °C, rounded: {} kg/m3 and {:g} "
                       "m2/s (IAPWS R6-95: 998.2; R12-08: 1.003e-6).",
                       water_density, water_kinematic_viscosity)),
     field("kinematic_viscosity_m2_s", &LiquidDefinition::kinematic_viscosity,
           number("m2/s").at_least(0), beside("density_kg_m3")),
     field("column_width_m", &LiquidDefinition::column_width,
           number("m").above(0).below(tank_length), no,
           "Makes the liquid a dam about to break: it stands from the left wall to here.")},
    {},
    {.fill_depth = 0, .density = water_density, .kinematic_viscosity = water_kinematic_viscosity}};

const FieldTable<GasDefinition> gas_keys{
    {"gas", "[gas]", "no",
     fmt::format(
         "The gas above the liquid, for OpenFOAM and the two-layer theory. Without it the gas is "
         "air at 20 °C, rounded: {} kg/m3 and {:g} m2/s (ISO 2533: 1.204 and 1.51e-5).",
         air.density, air.kinematic_viscosity)},
    {field("density_kg_m3", &GasDefinition::density, number("kg/m3").above(0).below(liquid_density),
           yes),
     field("kinematic_viscosity_m2_s", &GasDefinition::kinematic_viscosity,
           number("m2/s").at_least(0), yes)}};

const FieldTable<ObstacleDefinition> obstacle_keys{
    {"obstacle", "[[obstacle]]", "no",
     "A solid rectangle that the tank carries. Rectangles may touch and must not overlap. None "
     "may reach from wall to wall, fill a gauge's column from the bottom to the still level, "
     "touch a pressure gauge, or hold a probe."},
    {field("name", &ObstacleDefinition::name, name(), yes),
     field("left_m", &ObstacleDefinition::left, number("m from the left wall").at_least(0), yes),
     field("right_m", &ObstacleDefinition::right,
           number("m from the left wall").above(Bound("left_m")).at_most(tank_length), yes),
     field("bottom_m", &ObstacleDefinition::bottom, number("m from the bottom").at_least(0), yes),
     field("top_m", &ObstacleDefinition::top,
           number("m from the bottom").above(Bound("bottom_m")).at_most(tank_height), yes)},
    refuse_places};

const FieldTable<InitialWaveDefinition> initial_wave_keys{
    {"initial_wave", "[initial_wave]", "no, and not with column_width_m or an obstacle",
     "A standing wave A cos(mode pi x / L) that is released from rest; x counts from the left "
     "wall."},
    {field("mode", &InitialWaveDefinition::mode, integer().at_least(1), yes,
           "The number of half waves between the walls."),
     field("amplitude_m", &InitialWaveDefinition::amplitude,
           number("m").other_than_zero().by(within_liquid), yes,
           "The amplitude A. Where it is positive, the crest is at the left wall. Its magnitude "
           "is below the fill depth and below the room under the roof.")},
    refuse_wave};

void refuse_overlaps(const std::vector<TomlTable>& tables,
                     const std::vector<ObstacleDefinition>& obstacles) {
  for (std::size_t i = 0; i < obstacles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (overlap(obstacles[i], obstacles[j]))
        tables[i].refuse("left_m", fmt::format("a rectangle that does not overlap that of the "
                                               "obstacle {}",
                                               obstacles[j].name));
}

void refuse_beside_outline(const TomlTable& root, const CaseDefinition& definition) {
  const std::string beside = " beside " + outline_key(definition) + ": ";
  Complaints complaints;
  const auto refuse = [&](const TomlTable& table, const char* key, const std::string& expected) {
    if (table.has(key)) complaints.allow([&] { table.refuse(key, expected); });
  };
  refuse(root, "obstacle",
         "no [[obstacle]]" + beside + "an obstacle stands between the walls of a rectangle");
  refuse(root, "initial_wave",
         "no [initial_wave]" + beside + "its cosine is a mode of a rectangle");
  if (root.has_table("liquid"))
    refuse(root.table("liquid"), "column_width_m",
           "no column_width_m" + beside + "a dam stands at the left wall of a rectangle");
  complaints.tell();
}

void refuse_breadth_of_outline(const TomlTable& root, const CaseDefinition& definition) {
  if (is_rectangle(definition.tank) || !definition.tank.breadth ||
      forcing_frequency(definition) > 0)
    return;
  root.table("tank").refuse(
      "breadth_m", "no breadth_m beside " + outline_key(definition) +
                       " unless the motion has a single frequency, which the friction of the gap "
                       "walls depends on (a table names one by forcing_period_s in [comparison])");
}

Rule<int> modes_of_outline(const CaseDefinition& definition) {
  return {
      fmt::format("an integer from 1 to {} beside {}", most_section_modes, outline_key(definition)),
      [](int modes) { return modes >= 1 && modes <= most_section_modes; }, 40};
}

void refuse_solver_of_outline(const TomlTable& run, const CaseDefinition& definition) {
  if (is_rectangle(definition.tank)) return;
  const std::string name = run.written("solver");
  const SolverKind* kind = find_solver_kind(name);
  const bool is_known = kind || name == "pysph";  // an external run under a name of its own
  if (!is_known || (kind && kind->takes_outline)) return;
  run.refuse("solver",
             fmt::format("one of {}, which know more than rectangles, beside {}",
                         fmt::join(solvers_that_take_outlines(), ", "), outline_key(definition)));
}

}  // namespace slosh
