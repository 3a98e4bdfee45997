// The key of a run: a hash of everything that determines its numbers. Runs of equal keys have equal
// results, so that a stored result whose key fits need not be computed again.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "verification/case/case_definition.hpp"

namespace slosh {

// Returns "<32 digits>-<32 digits>": the hash of the question, then that of the answer's origin.
// The question is
//   - the physical part of the case: not its names, comparison and gate; the times of fields only
//     for a solver that leaves fields, the gas only for one that reads it
//   - the solver and its settings: not the run's name, nor the range in which a reference may gate
//   - the directory that an external run starts in, relative to the case file
//   - the content of a record and of an external run's inputs, which include those of its arguments
//     that are files (external_command.hpp)
// The origin is
//   - the content of the solver's file in `builds`: its sources without comments and layout, the
//     compiler and its options (solver_builds.cmake)
//   - for interFoam, its version and the templates' content; for an external run, its program's
//     and that of the libraries of the user's own that it loads (shared_libraries.hpp)
// Throws std::filesystem::filesystem_error where one of these files cannot be read.
std::string run_key(const CaseDefinition& definition, const RunDefinition& run,
                    const std::filesystem::path& builds,
                    const std::filesystem::path& openfoam_templates);

// Returns 32 digits: the hash of the physical part of the case and of the settings of the runs and
// ensembles of these names, as they enter the questions of their keys, but not of the content of a
// program's files.
std::string setup_hash(const CaseDefinition& definition, const std::set<std::string>& names);

// The path of a file relative to the directory of the case file: the same text on every machine.
std::string from_case_file(const std::filesystem::path& case_file,
                           const std::filesystem::path& file);

// Makes the files that an external or a stored run reads inputs of this process
// (protected_inputs.hpp). run_key() does so too.
void protect_inputs(const CaseDefinition& definition, const RunDefinition& run);

// Returns the files whose content counts as part of an external or a stored run's key, with the
// hashes of their contents.
std::map<std::filesystem::path, std::string> files_read_by(const RunDefinition& run,
                                                           const CaseDefinition& definition);

// Throws SolverError where one of these files has another content now: the run's result would be
// kept under the key of another one.
void require_unchanged(const std::map<std::filesystem::path, std::string>& contents);

// The second halves of the keys of all results that these builds and the installed OpenFOAM give.
struct PresentAnswers {
  std::set<std::string> answers;
  // Solvers whose answers cannot be listed: an external run's depends on its program, which only
  // the case file names, and interFoam's on an OpenFOAM that may not be installed.
  std::set<std::string> unknown_solvers;

  bool gave(std::string_view key) const;
};
PresentAnswers present_answers(const std::filesystem::path& builds,
                               const std::filesystem::path& openfoam_templates);

}  // namespace slosh
