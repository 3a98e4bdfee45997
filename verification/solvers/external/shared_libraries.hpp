// The shared libraries of a user's own that a program loads as it starts, read from its file and
// from the environment. No program is run.
#pragma once

#include <filesystem>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

// Returns the files that the loader may take (ld.so(8)) for the run's program and for each of its
// input files that is an ELF file, such as the solver behind mpirun: of each library that they, or
// their libraries, need (DT_NEEDED) and that LD_PRELOAD names, the files in all directories that
// are searched (RPATH, RUNPATH, LD_LIBRARY_PATH, /etc/ld.so.conf.d). All of them count, so that a
// library that is put before another one counts too. Those of the system (is_of_system) are left
// out, and so is what a program opens later, by dlopen(). Throws as external_inputs() does.
std::vector<std::filesystem::path> own_libraries(const ExternalRun& external,
                                                 const CaseDefinition& definition);

// Whether a file belongs to the system: below /bin, /sbin, /lib*, /etc, /dev, /proc, /sys, and
// below /usr without /usr/local.
bool is_of_system(const std::filesystem::path& file);

}  // namespace slosh
