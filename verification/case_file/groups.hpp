// One [[gate]] or [[problem.gate]] may hold several rows: it lists what is judged, by names or by
// patterns, and the metrics with their bounds at `limits`. Each of its rows becomes a table with
// the keys of a single row, so that what reads rows knows nothing of groups.
//
//   candidates = ["recommended_*", "interfoam_50x50"]      a row for each run that is matched
//   modes = ["natural_1", "natural_3"]                     and for each mode
//   limits.amplitude_error = 0.05                          and for each metric: its limit,
//   limits.phase_lag = { limit = 5, reason = "..." }       or the keys that are its own
#pragma once

#include <string>
#include <vector>

#include "verification/input/toml_reader.hpp"

namespace slosh {

// What the rows of a kind judge: the runs of a case, or the measures of a problem.
struct RowSubjects {
  std::string key, key_of_several;  // "candidate", "candidates"
  std::string what;                 // "a run"
  std::vector<std::string> names;   // in the order of the rows
  std::vector<std::string> metrics;
  std::string table;  // of a row's keys, in key_table.hpp
};

// Returns the rows of the group, by subject, then by mode, then by metric. A table that is no group
// is its own only row. Throws CaseFileError for a pattern that matches none of the names.
std::vector<TomlTable> rows_of_group(const TomlTable& group, const RowSubjects& subjects);

// One [[run]] may hold several runs, as a [[sweep]] of a campaign does: each key that holds a list
// makes a run for each of its values, and `name` is a pattern of the keys.
//
//   name = "recommended_{particle_spacing_mm}mm"     "recommended_25mm", "recommended_12p5mm"
//   particle_spacing_m = [0.025, 0.0125]             {..._mm} is a length at ..._m in millimetres,
//   quick = ["*_25mm"]                               {start_seed:02} a number of two digits

// Returns the tables of the runs, one for every combination of the values in lists. A table without
// lists is its own only run. Throws CaseFileError.
std::vector<TomlTable> runs_of_group(const TomlTable& group);

// Returns a length in a run's name: "12p5" for 0.0125 m.
std::string millimetres_in_name(double metres);

}  // namespace slosh
