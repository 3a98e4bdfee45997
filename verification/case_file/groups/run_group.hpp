// One [[run]] may hold several runs, as a [[sweep]] of a campaign does: each key that holds a list
// makes a run for each of its values, and `name` is a pattern of the keys.
//
//   name = "recommended_{particle_spacing_mm}mm"     "recommended_25mm", "recommended_12p5mm"
//   particle_spacing_m = [0.025, 0.0125]             {..._mm} is a length at ..._m in millimetres,
//   quick = ["*_25mm"]                               {start_seed:02} a number of two digits
#pragma once

#include <vector>

#include "verification/input/toml_reader.hpp"

namespace slosh {

// Returns the tables of the runs, one for every combination of the values in lists. A table without
// lists is its own only run. Throws CaseFileError.
std::vector<TomlTable> runs_of_group(const TomlTable& group);

// Returns a length in a run's name: "12p5" for 0.0125 m.
std::string millimetres_in_name(double metres);

}  // namespace slosh
