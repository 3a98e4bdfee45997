#include "verification/cli/stored_run.hpp"

#include <fmt/format.h>

#include <iostream>
#include <optional>
#include <utility>

#include "verification/files/foreign/legible_text.hpp"
#include "verification/files/protected_inputs.hpp"
#include "verification/results/timings.hpp"
#include "verification/runs/run_case.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

// Returns the usable result of the key, unless the run failed when it was last tried.
template <class Read>
auto kept(const ResultStore& store, const std::string& key, const char* extension, const Read& read)
    -> std::optional<decltype(read(store.root()))> try {
  if (read_failure(store.file(key, failure_extension))) return std::nullopt;
  return read_stored(store.file(key, extension), read);
} catch (const ResultError&) {
  return std::nullopt;
}

void record_failure(const ResultStore& store, const std::string& key, const RunFailure& why) try {
  write_failure(why, store.file(key, failure_extension));
} catch (const ResultError&) {  // a full disk must not hide the failure
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

// Writes to a key of the store unless another process holds it, and tells of a store that cannot be
// written.
void if_free(const ResultStore& store, const std::string& key, const std::function<void()>& write) {
  struct Held {};
  try {
    const StoreLock lock(store, key, [] { throw Held(); });
    write();
  } catch (const Held&) {
  } catch (const std::runtime_error& error) {
    std::cerr << "slosh: no campaign can take the result: " << error.what() << "\n";
  }
}

template <class Result, class Read, class Write>
void keep(const ResultStore& store, const std::string& key, const char* extension, Read read,
          Write write, const std::function<Result()>& compute) {
  const StoreLock lock(store, key, telling_once("computes this result"));
  const fs::path file = store.file(key, extension);
  if (!kept(store, key, extension, read)) try {
      write(compute(), file);
      fs::remove(store.file(key, failure_extension));  // of an earlier attempt
    } catch (const SolverError& error) {
      record_failure(store, key, error.failure);
      throw;
    }
  std::cout << "result: " << file.string() << "\n";
}

}  // namespace

std::optional<RunResult> kept_run(const ResultStore& store, const std::string& key) {
  return kept(store, key, ".h5", read_result);
}

void keep_run(const ResultStore& store, const std::string& key,
              const std::function<RunResult()>& compute) {
  keep(store, key, ".h5", read_result, write_result, compute);
}

void keep_problem(const ResultStore& store, const std::string& key,
                  const std::function<ProblemResult()>& compute) {
  keep(store, key, ".json", read_problem_result, write_problem_result, compute);
}

void keep_copy(const ResultStore& store, const std::string& key, const RunResult& result) {
  if_free(store, key, [&] {
    if (kept_run(store, key)) return;
    write_result(result, store.file(key, ".h5"));
    fs::remove(store.file(key, failure_extension));
  });
}

void keep_failure(const ResultStore& store, const std::string& key, const RunFailure& why) {
  if_free(store, key, [&] { record_failure(store, key, why); });
}

RunResult named_result(const fs::path& file) {
  protect_input(file);
  RunResult result = read_result(file);
  for (std::string* text : {&result.case_name, &result.run_name, &result.solver})
    *text = legible_message(*text);
  for (TimeSeries& series : result.series) {
    series.name = legible_message(series.name);
    series.unit = legible_message(series.unit);
  }
  return result;
}

void time_run(const ResultStore& store, const std::string& key, double longest,
              const std::function<RunResult()>& compute) {
  const StoreLock lock(store, key, telling_once("computes this result"));
  if (!fs::exists(store.file(key, ".h5"))) {
    std::cout << "there is no result whose run could be repeated\n";
    return;
  }
  const RunResult kept = read_stored(store.file(key, ".h5"), read_result);
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
