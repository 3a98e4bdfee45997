// What a tank that is no rectangle excludes: all that is measured from walls which it does not
// have, and all solvers that know rectangles alone.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "verification/case/motion.hpp"
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

}  // namespace slosh
