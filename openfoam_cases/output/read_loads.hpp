// Reads pressures, velocities and loads: those on the tank, on each wall, at sensors and at probes.
// Pressures are those above the gas's mean pressure at the same time.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "openfoam_cases/geometry/tank_mesh.hpp"
#include "openfoam_cases/output/read_log.hpp"
#include "openfoam_cases/output/read_series.hpp"

namespace slosh::openfoam {

// Throws RunError unless the function object averaged over this many cells: a zone that contains no
// cell, or also those of a neighbouring column, gives a wrong average without an error.
void check_cell_count(const std::filesystem::path& file, int expected);

// Returns one value of each row, times a factor.
History column_of(const Rows& rows, std::size_t index, double factor);

// Returns rows of vectors, those on the mesh's depth: the total load on the tank, its pressure and
// its viscous part, and that of the gap walls where they cause friction. `name` is
// that of the file.
Rows wall_loads(const SloshingTank& tank, const std::filesystem::path& case_directory,
                const char* name, const LogReader& log);

std::map<std::string, History> wall_pressures(const SloshingTank& tank, const TankMesh& mesh,
                                              const std::filesystem::path& case_directory,
                                              const LogReader& log);

// By probe [m/s], [Pa].
struct ProbeSeries {
  std::map<std::string, History> velocity_x, velocity_z, pressure;
};
// While less than half of what a probe reads is liquid, its values are zero.
ProbeSeries probe_series(const SloshingTank& tank, const TankMesh& mesh,
                         const std::filesystem::path& case_directory, const LogReader& log);

// By wall [N/m].
struct WallForces {
  std::map<std::string, History> x, z;
};
WallForces wall_forces(const SloshingTank& tank, const TankMesh& mesh,
                       const std::filesystem::path& case_directory, const LogReader& log);

}  // namespace slosh::openfoam
