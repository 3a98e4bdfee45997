// Computes the result of a run or problem once and keeps it in the store.
#pragma once

#include <functional>
#include <optional>

#include "verification/problems/problem_result.hpp"
#include "verification/results/result_file.hpp"
#include "verification/results/result_store.hpp"
#include "verification/results/run_failure.hpp"

namespace slosh {

// Returns the usable result of the key. Returns nullopt where there is none, and where the run
// failed when it was last tried.
std::optional<RunResult> kept_run(const ResultStore& store, const std::string& key);

// Compute a result and keep it under the key. They wait until this process holds the key, and
// compute nothing if a usable result is there by then. Throw what `compute` and write_result()
// throw; a SolverError is also recorded beside the place of the result (run_failure.hpp).
void keep_run(const ResultStore& store, const std::string& key,
              const std::function<RunResult()>& compute);
void keep_problem(const ResultStore& store, const std::string& key,
                  const std::function<ProblemResult()>& compute);

// Keeps a copy of a result that lies elsewhere, so that a campaign can use it. Does nothing if
// there is a usable result, or if another process holds the key and so computes the same. A store
// that cannot be written is only reported on standard error: the result itself is already written.
void keep_copy(const ResultStore& store, const std::string& key, const RunResult& result);

// Records that a run failed which was not started for the store (run_failure.hpp): a report must
// not take an older result instead. Does nothing where another process holds the key.
void keep_failure(const ResultStore& store, const std::string& key, const RunFailure& why);

// Reads a result that the user names, with names that can be shown (legible_text.hpp), and makes
// its file an input (protected_inputs.hpp).
RunResult named_result(const std::filesystem::path& file);

// Adds the cost of `compute` to the timings of the key. Skips a run without a result, and one that
// took more than `longest` seconds of processor time. Throws ResultError if the series differ from
// those of the stored result in a single bit: the timing would belong to another answer.
void time_run(const ResultStore& store, const std::string& key, double longest,
              const std::function<RunResult()>& compute);

}  // namespace slosh
