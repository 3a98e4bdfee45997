// A case for DualSPHysics 5.4: GenCase's definition, the tank's acceleration and a script.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/peers/dualsphysics/acceleration.hpp"
#include "verification/peers/motion_table.hpp"
#include "verification/peers/written_files.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

// GenCase's definition of a case (NAME_Def.xml) for DualSPHysics 5.4.

struct DualSphysicsSettings {
  double spacing;                 // [m], of which the tank's length, the liquid and the obstacles
                                  // are whole multiples
  std::string acceleration_file;  // beside the case that GenCase makes; empty: none
};

// DualSPHysics's coefh and the smoothing length in two dimensions, coefh sqrt(2) spacings.
inline constexpr double dualsphysics_coefh = 1.2;

using Values = std::initializer_list<std::pair<const char*, std::string>>;

// Ten digits: a lattice place and the end of a box that reaches it must not differ by a rounding.
std::string number(double value) { return fmt::format("{:.10g}", value + 0.0); }

struct Box {
  double left, right, bottom, top;
};

data with_box(const Box& box, const Values& of) {
  data made = values(of);
  made.set("left", number(box.left));
  made.set("bottom", number(box.bottom));
  made.set("width", number(box.right - box.left));
  made.set("height", number(box.top - box.bottom));
  return made;
}

// Marks of boundaries: the whole tank is one, or each wall where forces are wanted by wall.
enum Mark { tank_mark = 0, left_mark = 0, right_mark, bottom_mark, roof_mark, obstacle_mark };

std::string mark_of(Mark own, const CaseDefinition& definition) {
  return std::to_string(definition.wall_forces.empty() ? tank_mark : own);
}

// The surfaces from which GenCase takes the normals. They point into the liquid: into the tank's
// box, out of an obstacle's.
data surfaces(const CaseDefinition& definition, double roof) {
  data list(data::type::list);
  list << with_box({0, definition.tank.length, 0, roof},
                   {{"faces", "bottom | left | right | top"}, {"into_the_box", "true"}});
  for (const ObstacleDefinition& one : definition.obstacles)
    list << with_box(
        {one.left, one.right, one.bottom, one.top},
        {{"faces", one.bottom > 0 ? "bottom | left | right | top" : "left | right | top"},
         {"into_the_box", "false"}});
  return list;
}

// The liquid, then the walls, then the obstacles, which take the place of liquid. The walls have
// three layers, as the support reaches over 2 coefh sqrt(2) = 3.4 spacings.
data boxes(const CaseDefinition& definition, double dp, double height) {
  // The lattice has its places in the middle of cells of the spacing, from half a one on.
  const auto inside = [dp](const Box& box) {
    return Box{box.left + dp / 2, box.right - dp / 2, box.bottom + dp / 2, box.top - dp / 2};
  };
  data list(data::type::list);
  const auto wall = [&](Mark own, const Box& box) {
    list << with_box(box, {{"kind", "bound"}, {"mark", mark_of(own, definition)}});
  };
  const double length = definition.tank.length, outer = 2.5 * dp, inner = 0.5 * dp;
  const LiquidDefinition& liquid = definition.liquid;
  list << with_box(inside({0, liquid.column_width.value_or(length), 0, liquid.fill_depth}),
                   {{"kind", "fluid"}, {"mark", "0"}});
  wall(left_mark, {-outer, -inner, -outer, height + outer});
  wall(right_mark, {length + inner, length + outer, -outer, height + outer});
  wall(bottom_mark, {inner, length - inner, -outer, -inner});
  wall(roof_mark, {inner, length - inner, height + inner, height + outer});
  for (const ObstacleDefinition& one : definition.obstacles)
    wall(obstacle_mark, inside({one.left, one.right, one.bottom, one.top}));
  return list;
}

// A gauge's line spans the tank's height, so that no surface leaves it.
void set_gauges(const CaseDefinition& definition, double roof, data& all) {
  data gauges(data::type::list), probes(data::type::list), forces(data::type::list);
  for (const GaugeDefinition& one : definition.gauges)
    gauges << values({{"name", one.name}, {"x", number(one.x)}, {"roof", number(roof)}});
  for (const ProbeDefinition& one : definition.probes)
    probes << values({{"name", one.name}, {"x", number(one.x)}, {"z", number(one.z)}});
  if (definition.wall_forces.empty())
    forces << values({{"name", "tank"}, {"mark", mark_of(tank_mark, definition)}});
  for (const Wall wall : definition.wall_forces)
    forces << values({{"name", name_of(wall, wall_names)},
                      {"mark", mark_of(wall == Wall::left     ? left_mark
                                       : wall == Wall::right  ? right_mark
                                       : wall == Wall::bottom ? bottom_mark
                                                              : roof_mark,
                                       definition)}});
  all.set("gauges", gauges);
  all.set("probes", probes);
  all.set("forces", forces);
}

void set_motion(const CaseDefinition& definition, const std::string& file, data& all) {
  data start(data::type::list), acceleration(data::type::list);
  if (const double velocity = initial_velocity_x(definition); velocity != 0)
    start << values(
        {{"direction", velocity < 0 ? "-1" : "1"}, {"speed", number(std::abs(velocity))}});
  const auto& roll = definition.motion.roll;
  if (!file.empty())
    acceleration << values({{"axis_x", number(roll ? roll->axis_x : 0)},
                            {"axis_z", number(roll ? roll->axis_z : 0)},
                            {"file", file}});
  all.set("start", start);
  all.set("acceleration", acceleration);
}

// Returns the height [m] of the roof: the place between rows of the lattice nearest to the case's.
double dualsphysics_roof(const CaseDefinition& definition, double spacing) {
  return std::round(definition.tank.height / spacing) * spacing;
}

// Returns the text: modified dynamic walls of three layers with their normals, and the gauges of
// the case, fixed in the tank.
std::string dualsphysics_definition(const CaseDefinition& definition,
                                    const DualSphysicsSettings& settings) {
  const double dp = settings.spacing, roof = dualsphysics_roof(definition, dp),
               margin = 12 * dp,                                     // beyond the walls' layers
      last_time = definition.duration + definition.sample_interval;  // past the last sample
  data all = values({{"gravity_z", number(-definition.gravity)},
                     {"density", number(definition.liquid.density)},
                     {"coefh", number(dualsphysics_coefh)},
                     {"spacing", number(dp)},
                     {"half_spacing", number(dp / 2)},
                     {"lowest", number(-margin)},
                     {"highest_x", number(definition.tank.length + margin)},
                     {"highest_z", number(definition.tank.height + margin)},
                     {"interval", number(definition.sample_interval)},
                     {"end", number(last_time)},
                     {"output_interval", number(std::max(0.1, definition.sample_interval))}});
  all.set("surfaces", surfaces(definition, roof));
  all.set("boxes", boxes(definition, dp, roof));
  set_gauges(definition, roof, all);
  set_motion(definition, settings.acceleration_file, all);
  return filled("dualsphysics/definition.xml.mustache", all);
}

void require_spacing(const HandedCase& handed) {
  const CaseDefinition& definition = handed.definition;
  for (const double size : {definition.tank.length, definition.liquid.fill_depth,
                            definition.liquid.column_width.value_or(definition.tank.length)})
    if (!is_whole_multiple(size, handed.spacing))
      throw CaseFileError(fmt::format(
          "--spacing: {}: expected a whole fraction of the tank's length and of the liquid's depth "
          "and width, for DualSPHysics; {:.6g} m is none of its multiples",
          handed.spacing, size));
  for (const ObstacleDefinition& one : definition.obstacles)
    for (const double edge : {one.left, one.right, one.bottom, one.top})
      if (!is_whole_multiple(edge, handed.spacing))
        refuse_for_code(definition, "obstacle",
                        fmt::format("edges that are whole multiples of the spacing, {} m, for "
                                    "DualSPHysics: {} has one at {:.6g} m",
                                    handed.spacing, one.name, edge));
}

void require_for_dualsphysics(const HandedCase& handed) {
  const CaseDefinition& definition = handed.definition;
  const auto refuse = [&](const char* key, const std::string& expected) {
    refuse_for_code(definition, key, expected + ", for DualSPHysics");
  };
  if (definition.initial_wave)
    refuse("initial_wave", "a liquid that starts under a level surface, as GenCase fills boxes");
  if (definition.tank.breadth) refuse("tank.breadth_m", "a tank whose gap walls do not count");
  if (definition.gravity == 0)
    refuse("gravity_m_s2", "a number > 0, in m/s2, from which comes the speed of sound");
  if (starts_against_roll(definition))
    refuse("time.start",
           "\"tank\" where the roll begins at a rate, as the liquid starts with one velocity");
  require_spacing(handed);
}

// GaugesSWL reads still water too high and GaugesMaxZ too low, by parts of a spacing: the first
// reading is the datum, but for a dam, at whose gauges the surface need not be level at first.
std::vector<SeriesSource> dualsphysics_series(const CaseDefinition& definition) {
  std::vector<SeriesSource> series;
  const auto add_series = [&](const std::string& quantity, const std::string& file,
                              const char* column, const char* unit) -> SeriesSource& {
    series.push_back({.quantity = quantity,
                      .file = file + ".csv",
                      .format = "dualsphysics_gauge",
                      .column = column,
                      .unit = unit});
    return series.back();
  };
  const auto above_still_level = [&](SeriesSource& source) {
    if (definition.liquid.column_width)
      source.offset = -definition.liquid.fill_depth;
    else
      source.first_is_zero = true;
  };
  for (const auto& [name, x] : definition.gauges) {
    above_still_level(add_series("elevation@" + name, "GaugesSWL_surface_" + name, "swlz", ""));
    above_still_level(
        add_series("highest_surface@" + name, "GaugesMaxZ_highest_" + name, "zmax", ""));
  }
  for (const ProbeDefinition& probe : definition.probes)
    for (const auto& [component, column] :
         {std::pair{"velocity_x@", "velx"}, {"velocity_z@", "velz"}})
      add_series(component + probe.name, "GaugesVel_probe_" + probe.name, column, "");
  if (definition.wall_forces.empty())
    for (const auto& [force, column] : {std::pair{"force_x", "forcex"}, {"force_z", "forcez"}})
      add_series(force, "GaugesForce_on_tank", column, "N/m").whole_tank = true;
  for (const Wall wall : definition.wall_forces)
    for (const auto& [force, column] : {std::pair{"force_x@", "forcex"}, {"force_z@", "forcez"}})
      add_series(force + name_of(wall, wall_names), "GaugesForce_on_" + name_of(wall, wall_names),
                 column, "N/m");
  return series;
}

std::string script(const std::string& name, bool moves) {
  const std::string copy = moves ? "cp \"$here/" + name + "_acceleration.csv\" \"$out\"\n" : "";
  return filled("dualsphysics/run.sh.mustache", values({{"name", name}, {"copy", copy}}));
}

std::string block(const HandedCase& handed, const fs::path& directory, const std::string& run) {
  return run_block(run,
                   {.command = {(handed.place / "run.sh").string(), "{work_directory}"},
                    .inputs = inputs_in(handed, directory),
                    .series = dualsphysics_series(handed.definition),
                    .method = "dualsphysics",
                    .particle_spacing = handed.spacing,
                    .fail_on = {"without normal data"},
                    .cores = 1},
                   handed.definition,
                   "DualSPHysics, whose programs GENCASE and DUALSPHYSICS name or which are on the "
                   "PATH.");
}

// Within twice the smoothing length of a wall the sum over particles lacks those beyond it.
std::string near_walls(const HandedCase& handed) {
  const double reach = 2 * dualsphysics_coefh * std::numbers::sqrt2 * handed.spacing;
  std::string text;
  for (const GaugeDefinition& gauge : handed.definition.gauges)
    if (std::min(gauge.x, handed.definition.tank.length - gauge.x) < reach)
      text += fmt::format(
          "- The gauge `{}` is nearer to a wall than twice the smoothing length, "
          "{:.3g} m: its sum over the liquid's particles lacks those beyond the "
          "wall, so that it reads the surface lower.\n",
          gauge.name, reach);
  return text;
}

std::string rolls(const HandedCase& handed) {
  if (!handed.definition.motion.roll) return "";
  return fmt::format(
      "- The centrifugal force of the roll: DualSPHysics adds it with the wrong sign "
      "(DualSPHysics#296). In this case that is an error of at most {:.3g} m/s2, {:.2g} of "
      "gravity, in the tank's farthest corner. The table of accelerations takes off that its "
      "Coriolis force counts the sum of the table's own linear accelerations as a velocity.\n",
      largest_centrifugal_error(handed.definition),
      largest_centrifugal_error(handed.definition) / handed.definition.gravity);
}

std::string roof(const HandedCase& handed) {
  const double roof = dualsphysics_roof(handed.definition, handed.spacing);
  if (is_whole_multiple(handed.definition.tank.height, handed.spacing)) return "";
  return fmt::format(
      "- The tank's height: its roof is at {:.6g} m in place of {:.6g} m, between "
      "two rows of the lattice.\n",
      roof, handed.definition.tank.height);
}

std::string readme(const HandedCase& handed, const std::string& run) {
  const CaseDefinition& definition = handed.definition;
  const std::string acceleration =
      definition.motion.still()
          ? ""
          : fmt::format(
                "| `{}_acceleration.csv` | minus the acceleration of the tank along its own "
                "axes, and of a roll, for its AccInput |\n",
                definition.name);
  return readme_head(handed, "DualSPHysics 5.4") +
         filled("dualsphysics/README.md.mustache",
                values({{"name", definition.name},
                        {"spacing", fmt::format("{}", handed.spacing)},
                        {"acceleration", acceleration},
                        {"datum", definition.liquid.column_width
                                      ? "`run.toml` takes the depth off."
                                      : "`run.toml` therefore takes each gauge's first reading for "
                                        "its datum."},
                        {"notes", roof(handed) + near_walls(handed) + rolls(handed)}})) +
         readme_end(handed, run);
}

}  // namespace

void write_dualsphysics_case(const HandedCase& handed, const fs::path& directory) {
  require_for_dualsphysics(handed);
  const std::string& name = handed.definition.name;
  const std::vector<AccInputRow> rows = acc_input(handed.definition);
  const std::string table = rows.empty() ? "" : name + "_acceleration.csv";
  if (!rows.empty()) write_text(directory / table, acc_input_file(rows));
  write_text(directory / (name + "_Def.xml"),
             dualsphysics_definition(handed.definition, {handed.spacing, table}));
  write_script(directory / "run.sh", script(name, !rows.empty()));
  const std::string run = run_name("dualsphysics", handed.spacing);
  write_text(directory / "run.toml", block(handed, directory, run));
  write_text(directory / "README.md", readme(handed, run));
}

}  // namespace slosh
