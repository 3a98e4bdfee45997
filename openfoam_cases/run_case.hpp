// Runs a case with the installed OpenFOAM.
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <string>

#include "openfoam_cases/sloshing_tank.hpp"

namespace slosh::openfoam {

// Called repeatedly with the simulated time [s] and the number of steps so far.
using Progress = std::function<void(double time, double steps)>;

// Limits of the wall time of one stage [s].
struct TimeLimits {
  double utility = 600;  // each stage but interFoam; the meshes here take seconds
  double solver = std::numeric_limits<double>::infinity();
};

// Runs blockMesh (not with an outline, whose mesh is written), topoSet and interFoam; on several
// processes also decomposePar and, where there are snapshots, reconstructPar. The output of each
// stays in log.<stage> in the case directory. Throws RunError where a stage fails or reaches its
// time limit. The programs belong to the caller's process group. At a time limit, and where
// `progress` throws, they are ended with every process that they started.
void run_case(const SloshingTank& tank, const std::filesystem::path& case_directory,
              const Progress& progress, const TimeLimits& limits = {});

// Returns the installed version ("1912"), or an empty string where interFoam is not installed.
std::string installed_version();

}  // namespace slosh::openfoam
