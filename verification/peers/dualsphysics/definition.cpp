#include "verification/peers/dualsphysics/definition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <kainjow/mustache.hpp>
#include <stdexcept>
#include <utility>

#include "verification/files/content_hash.hpp"
#include "verification/peers/motion_table.hpp"
#include "verification/peers/tank_file.hpp"

namespace slosh {
namespace {

using kainjow::mustache::data;
using Values = std::initializer_list<std::pair<const char*, std::string>>;

// Ten digits: a lattice place and the end of a box that reaches it must not differ by a rounding.
std::string number(double value) { return fmt::format("{:.10g}", value + 0.0); }

data values(const Values& of) {
  data made;
  for (const auto& [name, value] : of) made.set(name, value);
  return made;
}

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

}  // namespace

double dualsphysics_roof(const CaseDefinition& definition, double spacing) {
  return std::round(definition.tank.height / spacing) * spacing;
}

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
  const auto file = peers_directory() / "dualsphysics/definition.xml.mustache";
  kainjow::mustache::mustache text(read_bytes(file));
  if (!text.is_valid()) throw std::runtime_error(file.string() + ": " + text.error_message());
  return text.render(all);
}

}  // namespace slosh
