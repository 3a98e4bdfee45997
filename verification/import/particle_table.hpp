// Reads the positions of particles at one time or more from a table that any program can write:
// a line with names, then a row for each particle. The rows of one time follow one another.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace slosh {

// The names of the columns, each with its unit in brackets or without one, which is then SI.
struct ParticleColumns {
  std::string time = "time", x = "x", z = "z";
  std::string volume = {};  // per metre of width; empty: the table has none
};

// The particles of the liquid at one time.
struct ParticlesAt {
  double time;                 // [s]
  std::vector<double> x, z;    // [m]
  std::vector<double> volume;  // per metre of width [m2]; empty where the table has none
  std::vector<int> line;       // of each row in the table
};

// Throws CaseFileError, "file:line: ...", where the table has no such column, a unit is not SI, a
// number cannot be used, a volume is not positive, a row is of another length, times decrease or
// there is no row.
std::vector<ParticlesAt> read_particle_table(const std::filesystem::path& file,
                                             const ParticleColumns& columns);

}  // namespace slosh
