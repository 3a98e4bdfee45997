// The result of a run: one HDF5 file, written under a temporary name and renamed when complete.
// All later steps (metrics, gate, report) can be redone without running a solver. Layout,
// version 2 (texts are UTF-8, numbers float64):
//   /              attributes format ("slosh result"), format_version, case_name, run_name,
//                  solver, key
//   /case_text     the case file as read, one text
//   /active_terms  texts
//   /cost          attributes wall_time_s, user_time_s, system_time_s, peak_memory_byte, steps,
//                  elements
//   /provenance    attributes, texts
//   /diagnostics   attributes, numbers, the unit in the name
//   /series/NAME   attribute name; data sets time and value, each with the attribute unit and
//                  Fletcher32 sums; in NAME a '/' is "%2F" and a '%' is "%25"
//   /snapshots/N   N = 00000, 00001, ...: attributes time_s, width_m, height_m; data sets x, z,
//                  velocity_x, velocity_z, pressure, each with the attribute unit
// The file is sealed (sealed_file.hpp).
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "verification/files/result_error.hpp"
#include "verification/series/field_snapshot.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

// The cost of a run, by the operating system's account of its process and its children.
struct RunCost {
  double wall_time = 0;    // [s]
  double user_time = 0;    // [s], all threads and children
  double system_time = 0;  // [s]
  double peak_memory = 0;  // [byte], largest single process
  // 0 where they are not counted.
  double steps = 0;
  double elements = 0;  // particles (walls apart) or cells

  double core_seconds() const { return user_time + system_time; }  // [s]
};

struct RunResult {
  std::string case_name, run_name, solver;
  std::string case_text;  // the case file as read
  std::string key;        // hash of all that determined the run
  std::map<std::string, std::string>
      provenance;  // versions, compiler, host's processor, time of the run, command
  std::vector<std::string> active_terms;  // the physics compiled in or switched on
  std::map<std::string, double>
      diagnostics;  // "max_courant_number", "mass_loss", ... (unit in the name)
  RunCost cost;
  std::vector<TimeSeries> series;
  std::vector<FieldSnapshot> snapshots = {};  // at the case's snapshot times

  // Returns the series of that name. Throws ResultError where there is none.
  const TimeSeries& at(const std::string& series_name) const;
};

// Writes the result and makes the directory if need be. Throws ResultError, also for a series that
// has no name, the name of another, or unequal numbers of times and values; an earlier file stays
// then.
void write_result(const RunResult& result, const std::filesystem::path& file);

// Reads a result. Throws ResultError with the file's name.
RunResult read_result(const std::filesystem::path& file);

}  // namespace slosh
