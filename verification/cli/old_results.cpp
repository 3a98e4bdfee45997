#include "verification/cli/old_results.hpp"

#include <optional>

#include "verification/problems/problem_result.hpp"
#include "verification/results/result_file.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

constexpr const char* unreadable = "a result that cannot be read";

// What lies under a key of another build; nothing where that may still be a present result.
std::optional<std::string> name_of_old(const ResultStore& store, const std::string& key,
                                       const PresentAnswers& present) try {
  if (const fs::path file = store.file(key, ".h5"); fs::exists(file)) {
    const RunResult result = read_result(file);
    if (present.unknown_solvers.contains(result.solver)) return std::nullopt;
    return result.case_name + "/" + result.run_name + " (" + result.solver + ")";
  }
  if (const fs::path file = store.file(key, ".json"); fs::exists(file))
    return read_problem_result(file).problem + " (a problem)";
  return "what a failed or interrupted run left";
} catch (const ResultError&) {
  return unreadable;
}

}  // namespace

std::vector<OldResult> old_results(const ResultStore& store, const PresentAnswers& present) {
  std::vector<OldResult> old;
  for (const std::string& key : store.keys()) {
    if (present.gave(key)) continue;
    if (const auto name = name_of_old(store, key, present))
      old.push_back({key, *name, store.size(key)});
  }
  return old;
}

}  // namespace slosh
