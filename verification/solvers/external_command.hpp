// The command line of an external program, as a case gives it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/input/input_files.hpp"

namespace slosh {

// Returns the program's file, relative to the case file or on the PATH; empty where there is none.
std::filesystem::path external_program(const ExternalRun& external,
                                       const CaseDefinition& definition);

// Return the program and its arguments with the placeholders filled in, of the run and of what
// tells the program's version; an empty program where there is none. Throw std::invalid_argument
// for a name in braces that is no placeholder.
std::vector<std::string> external_command(const ExternalRun& external,
                                          const CaseDefinition& definition,
                                          const std::filesystem::path& work_directory);
std::vector<std::string> version_command(const ExternalRun& external,
                                         const CaseDefinition& definition,
                                         const std::filesystem::path& work_directory);

// The file that {tank_file} stands for, in the work directory (verification/peers/tank_file.hpp).
inline constexpr const char* tank_file_name = "tank.json";

// Whether the command has {tank_file}, so that the run writes this file.
bool asks_for_tank_file(const ExternalRun& external);

// Returns the paths that each argument may name, also by its part behind an "=" or an "@", relative
// to the case file and to the run's directory. Throws as external_command() does.
std::vector<std::filesystem::path> argument_paths(const ExternalRun& external,
                                                  const CaseDefinition& definition);

// Returns the files whose content counts as part of the run: the inputs that the case declares, and
// those of argument_paths() that are files. Each file is named once. The case file itself is left
// out, for only its physical part counts (run_key.hpp). Throws as external_command() and
// input_files() do.
std::vector<InputFile> external_inputs(const ExternalRun& external,
                                       const CaseDefinition& definition);

}  // namespace slosh
