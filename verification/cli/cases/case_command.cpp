// The subcommand case: writes a case for another code, with the run that takes its output back.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <system_error>

#include "verification/assessment/doubts/motion_noise.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/cli/command_tree.hpp"
#include "verification/gate/gate.hpp"
#include "verification/peers/peer_codes.hpp"
#include "verification/peers/written_files.hpp"
#include "verification/runs/fitting_spacing.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

struct CaseOptions {
  std::string case_name, code;
  std::optional<double> spacing;
  fs::path output;
};

// The coarsest of the case's SPH runs, or a twentieth of the depth.
double usual_spacing(const CaseDefinition& definition) {
  double coarsest = 0;
  for (const RunDefinition& run : definition.runs)
    if (const auto* sph = std::get_if<SphRun>(&run.solver))
      coarsest = std::max(coarsest, sph->particle_spacing);
  return coarsest > 0 ? coarsest : definition.liquid.fill_depth / 20;
}

// Returns the spacing nearest to this one, or finer, that divides the liquid; this one itself where
// there is none of a sixty-fourth of it or more.
double dividing_spacing(const CaseDefinition& definition, double spacing) {
  for (double near = spacing; near > spacing / 64; near /= 2) {
    const std::optional<double> found = nearest_fitting_spacing(definition, near);
    if (found && is_whole_multiple(definition.liquid.fill_depth, *found)) return *found;
  }
  return spacing;
}

// The cells of a spacing, those of the case's first interFoam run, or those of the usual spacing.
std::pair<int, int> cells_of(const CaseDefinition& definition, const CaseOptions& options) {
  if (!options.spacing)
    for (const RunDefinition& run : definition.runs)
      if (const auto* mesh = std::get_if<InterFoamRun>(&run.solver))
        return {mesh->cells_x, mesh->cells_z};
  const double size = options.spacing.value_or(usual_spacing(definition));
  const auto cells = [&](double length) {
    return std::max(2, static_cast<int>(std::lround(length / size)));
  };
  return {cells(definition.tank.length), cells(definition.tank.height)};
}

// Throws for a spacing of more rows than any code computes: their number would overflow.
void require_usual_size(const CaseDefinition& definition, const std::optional<double>& spacing) {
  constexpr double most_rows = 10000;
  const double depth = definition.liquid.fill_depth;
  if (spacing && !(*spacing <= depth && depth / *spacing <= most_rows))
    throw CaseFileError(fmt::format(
        "--spacing: {:g}: expected a spacing of at most the fill depth, {:g} m, and of at least a "
        "ten-thousandth of it",
        *spacing, depth));
}

int leave_case_for_code(const CaseOptions& options, const Installation& installation) {
  const CaseDefinition definition = read_case(find_case(options.case_name, installation.cases));
  require_usual_size(definition, options.spacing);
  const auto [cells_x, cells_z] = cells_of(definition, options);
  const double spacing =
      options.spacing.value_or(dividing_spacing(definition, usual_spacing(definition)));
  try {
    write_for_code(options.code, {.definition = definition,
                                  .spacing = spacing,
                                  .cells_x = cells_x,
                                  .cells_z = cells_z,
                                  .place = whole(options.output),
                                  .openfoam_templates = installation.openfoam_templates});
  } catch (const fs::filesystem_error& error) {
    throw CaseFileError(std::string("--output: ") + error.what());
  }
  std::cout << "case: " << options.output.string() << "\n" << doubtful_motion(definition);
  return exit_pass;
}

}  // namespace

void add_case_command(const CommandTree& tree) {
  const auto [command, options] = add_command_with<CaseOptions>(
      tree,
      {"case",
       "Writes a case for another code, with the run that takes its output back",
       {"./slosh case li2010_small_amplitude --for dualsphysics -o li2010_dualsphysics",
        "./slosh case zhao2021_mild_roll --for csv -o zhao2021_tables"}},
      leave_case_for_code);
  add_case_argument(command, options.case_name)->required();
  add_option(command, "--for", options.code, "CODE", "The code")
      ->check(one_of("a code", peer_code_names()))
      ->required();
  add_option(command, "--spacing", options.spacing, "DP",
             "Spacing of particles or size of cells, in m (default: the nearest to that of the "
             "case's coarsest SPH run that divides the liquid; the cells of its first "
             "interFoam run)")
      ->check(keeps(positive("m")));
  add_option(command, "-o,--output", options.output, directory_type,
             "The directory to write, which is not there yet or empty")
      ->required();
}

}  // namespace slosh
