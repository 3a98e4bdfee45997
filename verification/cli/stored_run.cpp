#include "verification/cli/stored_run.hpp"

#include <fmt/format.h>

#include <iostream>

#include "reports/model/legible_text.hpp"
#include "verification/results/timings.hpp"
#include "verification/runs/run_case.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

// Returns whether the file holds a usable result.
template <class Read>
bool stands(const fs::path& file, Read read) try {
  read(file);
  return true;
} catch (const ResultError&) {
  return false;
}

// Returns the name of a series in which the results differ, or an empty text.
std::string difference(const RunResult& one, const RunResult& other) {
  if (one.series.size() != other.series.size()) return "number of series";
  for (const TimeSeries& series : one.series) {
    const TimeSeries& twin = other.at(series.name);
    if (series.time != twin.time || series.value != twin.value) return series.name;
  }
  return "";
}

// Returns the result of `compute`. If its solver fails, the reason is written to the file, which
// holds only that of the last attempt.
template <class Result>
Result computed(const std::function<Result()>& compute, const fs::path& failure_file) {
  fs::remove(failure_file);
  try {
    return compute();
  } catch (const SolverError& error) {
    try {
      write_failure(error.failure, failure_file);
    } catch (const ResultError&) {  // a full disk must not hide the failure
    }
    throw;
  }
}

template <class Result, class Read, class Write>
void keep(const ResultStore& store, const std::string& key, const char* extension, Read read,
          Write write, const std::function<Result()>& compute) {
  const StoreLock lock(store, key);
  const fs::path file = store.file(key, extension);
  if (!stands(file, read)) write(computed(compute, store.file(key, failure_extension)), file);
  std::cout << "result: " << file.string() << "\n";
}

}  // namespace

void keep_run(const ResultStore& store, const std::string& key,
              const std::function<RunResult()>& compute) {
  keep(store, key, ".h5", read_result, write_result, compute);
}

void keep_problem(const ResultStore& store, const std::string& key,
                  const std::function<ProblemResult()>& compute) {
  keep(store, key, ".json", read_problem_result, write_problem_result, compute);
}

void keep_copy(const ResultStore& store, const std::string& key, const RunResult& result) {
  struct Held {};
  const fs::path file = store.file(key, ".h5");
  try {
    const StoreLock lock(store, key, [] { throw Held(); });
    if (stands(file, read_result)) return;
    write_result(result, file);
    fs::remove(store.file(key, failure_extension));
  } catch (const Held&) {
  } catch (const std::runtime_error& error) {
    std::cerr << "slosh: no campaign can take the result: " << error.what() << "\n";
  }
}

RunResult named_result(const fs::path& file) {
  using reports::legible;
  RunResult result = read_result(file);
  for (std::string* text : {&result.case_name, &result.run_name, &result.solver})
    *text = legible(*text);
  for (TimeSeries& series : result.series) {
    series.name = legible(series.name);
    series.unit = legible(series.unit);
  }
  return result;
}

void time_run(const ResultStore& store, const std::string& key, double longest,
              const std::function<RunResult()>& compute) {
  const StoreLock lock(store, key);
  if (!fs::exists(store.file(key, ".h5"))) {
    std::cout << "there is no result whose run could be repeated\n";
    return;
  }
  const RunResult kept = read_result(store.file(key, ".h5"));
  if (kept.cost.core_seconds() > longest) {
    std::cout << fmt::format("not repeated: it takes more than {} s\n", longest);
    return;
  }
  const RunResult again = compute();
  if (const std::string series = difference(kept, again); !series.empty())
    throw ResultError(fmt::format("{}: expected the same {} of a repeated run, for its timing",
                                  store.file(key, ".h5").string(), series));
  const fs::path file = store.file(key, ".timings.json");
  add_timing({again.cost, again.provenance.at("processor"), again.provenance.at("date_utc")}, file);
  std::cout << "timing: " << file.string() << "\n";
}

}  // namespace slosh
