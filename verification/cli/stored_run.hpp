// What a campaign starts for each run and problem: into the store, once.
#pragma once

#include <functional>

#include "verification/problems/problem_result.hpp"
#include "verification/results/result_file.hpp"
#include "verification/results/result_store.hpp"

namespace slosh {

// Keeps what `compute` gives under the key, unless a result that can be used is there once this
// process holds the key. Throws what `compute` and write_result() throw; a SolverError is left
// beside where the result would lie (run_failure.hpp).
void keep_run(const ResultStore& store, const std::string& key,
              const std::function<RunResult()>& compute);
void keep_problem(const ResultStore& store, const std::string& key,
                  const std::function<ProblemResult()>& compute);

// Keeps a copy of a result that lies elsewhere, so that a campaign takes it; not where one that can
// be used is there, or a process holds the key, which computes the same. Of a store that cannot be
// written it tells on standard error: the result itself is where it was asked for.
void keep_copy(const ResultStore& store, const std::string& key, const RunResult& result);

// Adds what `compute` took to the timings of the key; not of a run that failed, nor of one that
// took more than `longest` seconds of processor time. Throws ResultError where the new result has
// other series by as much as a bit: what was timed was another answer.
void time_run(const ResultStore& store, const std::string& key, double longest,
              const std::function<RunResult()>& compute);

}  // namespace slosh
