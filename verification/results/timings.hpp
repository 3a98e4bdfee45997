// The costs of repeats of a run that ran alone on their core, as a sealed JSON file
// (sealed_json.hpp) beside the run's result.
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

// Returns an empty list where the file is absent, altered or of another kind: the repeats are then
// run again.
std::vector<Timing> read_timings(const std::filesystem::path& file);

// Adds a timing; the file is replaced as a whole. Throws ResultError. The caller holds the
// key's StoreLock, so that no other process writes the file.
void add_timing(const Timing& timing, const std::filesystem::path& file);

// Returns the costs of the timings that have the processor of the last one: times on two kinds of
// machine are no repeats.
std::vector<RunCost> comparable_costs(const std::vector<Timing>& timings);

}  // namespace slosh
