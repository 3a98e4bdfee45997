// The results of a store that no build of this tree gives any more: nothing takes them but a report
// that starts no solver, and the estimates of what a run will take.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "verification/results/result_store.hpp"
#include "verification/runs/run_key.hpp"

namespace slosh {

struct OldResult {
  std::string key, name;  // "CASE/RUN (sph)", or what else lies there
  std::uintmax_t size;    // [byte]
};

// A result of a present build is never old, whatever case file asked for it: that may lie anywhere.
// Nor is one of a solver of which this cannot be told.
std::vector<OldResult> old_results(const ResultStore& store, const PresentAnswers& present);

}  // namespace slosh
