// The name of everything that determines a run's numbers: equal keys, equal results, so that a
// result whose key fits need not be computed again.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>

#include "verification/case/case_definition.hpp"

namespace slosh {

// "<32 digits>-<32 digits>": first what was asked, then what answered.
//
// Hashes the physical part of the case (not its names, comparison and gate; the times of fields
// only of a solver that leaves fields, the gas only of one that reads it: interFoam, theory of two
// layers, an external program), the run's solver and its
// settings (not its name, nor the range in which a reference may gate), a record's content and that
// of an external run's inputs, its arguments that are files among them (external_command.hpp); then
// the content of the solver's file in `builds` (solver_builds.cmake: each changes with the code of
// that solver alone) and, for interFoam, its version and the templates' content, of an external run
// the program's. Throws std::filesystem::filesystem_error where that file or the templates cannot
// be read.
std::string run_key(const CaseDefinition& definition, const RunDefinition& run,
                    const std::filesystem::path& builds,
                    const std::filesystem::path& openfoam_templates);

// What ends the keys of the results that these builds, and the OpenFOAM that is installed, give.
struct PresentAnswers {
  std::set<std::string> answers;
  // Of these nothing can be told without the case file or the machine that computed them: an
  // external run's answer is its program's too, and interFoam's needs an OpenFOAM.
  std::set<std::string> unknown_solvers;

  bool gave(std::string_view key) const;
};
PresentAnswers present_answers(const std::filesystem::path& builds,
                               const std::filesystem::path& openfoam_templates);

// Whether two keys ask the same, be it answered by another build or version.
bool asks_the_same(std::string_view key, std::string_view other);

}  // namespace slosh
