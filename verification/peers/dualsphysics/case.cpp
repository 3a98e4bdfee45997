// A case for DualSPHysics 5.4: GenCase's definition, the tank's acceleration and a script.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "verification/peers/dualsphysics/acceleration.hpp"
#include "verification/peers/dualsphysics/definition.hpp"
#include "verification/peers/motion_table.hpp"
#include "verification/peers/run_block.hpp"
#include "verification/peers/written_files.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

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
  if (definition.tank.breadth)
    refuse("tank.breadth_m", "a tank whose front and back walls do not count");
  if (definition.gravity == 0)
    refuse("gravity_m_s2", "a number > 0, in m/s2, from which comes the speed of sound");
  if (starts_against_roll(definition))
    refuse("time.start",
           "\"tank\" where the roll begins at a rate, as the liquid starts with one velocity");
  require_spacing(handed);
}

std::string script(const std::string& name, bool moves) {
  const std::string copy = moves ? "cp \"$here/" + name + "_acceleration.csv\" \"$out\"\n" : "";
  return "#!/bin/sh\n"
         "# Runs the case: ./run.sh [DIRECTORY]. GENCASE and DUALSPHYSICS name the two programs.\n"
         "set -eu\n"
         "here=$(CDPATH= cd -- \"$(dirname -- \"$0\")\" && pwd)\n"
         "out=${1:-$here/out}\n"
         "mkdir -p \"$out\"\n" +
         copy + "\"${GENCASE:-GenCase_linux64}\" \"$here/" + name + "_Def\" \"$out/" + name +
         "\" -save:all\n"
         "\"${DUALSPHYSICS:-DualSPHysics5.4CPU_linux64}\" -cpu "
         "-ompthreads:\"${OMP_NUM_THREADS:-1}\" \"$out/" +
         name + "\" \"$out\" -dirdataout data -svres\n";
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
  return readme_head(handed, "DualSPHysics 5.4") +
         fmt::format(
             "`./run.sh DIRECTORY` runs GenCase and DualSPHysicsCPU, which `GENCASE` and "
             "`DUALSPHYSICS` name (default: `GenCase_linux64` and `DualSPHysics5.4CPU_linux64` on "
             "the PATH).\n\n"
             "| file | holds |\n|---|---|\n"
             "| `{0}_Def.xml` | GenCase's definition: particles {1} m apart, modified dynamic "
             "walls with normals, gauges fixed in the tank |\n{2}"
             "\n## What this code is not told, or says otherwise\n\n"
             "- The viscosity: the flow has artificial viscosity, alpha 0.01, and density "
             "diffusion "
             "(Fourtakas, 0.1), symplectic steps, c0 = 20 sqrt(g h), h = 1.2 sqrt(2) spacings.\n"
             "- The gas.\n"
             "- Pressures: no gauge of DualSPHysics measures one, MeasureTool does.\n"
             "- What was run: the definition follows one of a surging tank that DualSPHysics 5.4 "
             "has "
             "run. Its roof, obstacles, and the accelerations in a file of their own follow "
             "DualSPHysics's documents and were not run.\n"
             "- Still water: a gauge of the surface reads some 0.2 spacings too high, one of the "
             "highest particle half a spacing too low. {3}\n{4}{5}{6}",
             definition.name, handed.spacing,
             definition.motion.still()
                 ? ""
                 : fmt::format("| `{}_acceleration.csv` | minus the acceleration of the tank along "
                               "its own axes, and of a roll, for its AccInput |\n",
                               definition.name),
             definition.liquid.column_width
                 ? "`run.toml` takes the depth off."
                 : "`run.toml` therefore takes each gauge's first reading for its datum.",
             roof(handed), near_walls(handed), rolls(handed)) +
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
