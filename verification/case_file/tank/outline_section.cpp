// The outline of a tank that is no rectangle: corners, or the diameter of a lying cylinder.
//
// What a tank that is no rectangle excludes: all that is measured from walls which it does not
// have, and all solvers that know rectangles alone.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "verification/case/motion.hpp"
#include "verification/case/shape/outline.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/case_sections.hpp"

namespace slosh {
namespace {

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

}  // namespace

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
  refuse(root, "wall_forces",
         "no wall_forces" + beside + "its sides have no names; force_x and force_z are recorded");
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
      "breadth_m",
      "no breadth_m beside " + outline_key(definition) +
          " unless the motion has a single frequency, which the friction of the front and the back "
          "wall depends on (a table names one by forcing_period_s in [comparison])");
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

bool tells_outline(const TomlTable& tank) {
  return tank.has("outline_m") || tank.has("diameter_m");
}

TankDefinition read_outline(const TomlTable& tank) {
  const std::string key = tank.has("outline_m") ? "outline_m" : "diameter_m";
  for (const char* other : {"length_m", "height_m", "diameter_m"})
    if (other != key && tank.has(other))
      tank.refuse(other,
                  fmt::format("no {} beside {}, which tells the tank's whole shape", other, key));
  TankDefinition read{};
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
  return read;
}

}  // namespace slosh
