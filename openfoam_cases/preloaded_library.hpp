// The library of dictionary_digest.cpp, where the build has left it.
#pragma once

#include <filesystem>

namespace slosh::openfoam {

// In the build tree of this program; empty where the program stands in none: the runs then rest on
// OpenFOAM's own.
std::filesystem::path preloaded_library();

}  // namespace slosh::openfoam
