// What repeats of a run took that had their core for themselves: a sealed JSON file
// (sealed_json.hpp) beside its result.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/results/result_file.hpp"

namespace slosh {

struct Timing {
  RunCost cost;
  std::string processor, date;  // as in a result's provenance
};

// None where the file is absent, altered, or no such file: they are made again then.
std::vector<Timing> read_timings(const std::filesystem::path& file);

// Adds one; the file is replaced as a whole. Throws ResultError. The caller sees to it that no
// other process does the same (StoreLock).
void add_timing(const Timing& timing, const std::filesystem::path& file);

// Of those on the processor of the last one: times on two machines are no repeats.
std::vector<RunCost> comparable_costs(const std::vector<Timing>& timings);

}  // namespace slosh
