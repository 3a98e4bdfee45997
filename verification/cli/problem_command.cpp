#include "verification/cli/problem_command.hpp"

#include <fmt/format.h>

#include <iostream>

#include "verification/assessment/problem_assessment.hpp"
#include "verification/cli/stored_run.hpp"
#include "verification/gate/gate.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/problems/problem.hpp"
#include "verification/results/cost_meter.hpp"
#include "verification/results/provenance.hpp"
#include "verification/runs/run_case.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

// Throws CaseFileError where there is none of that name.
const Problem& named_problem(const std::string& name) try {
  return find_problem(name);
} catch (const std::invalid_argument& error) {
  throw CaseFileError(error.what());
}

// Throws SolverError where the solver fails.
ProblemOutcome outcome_of(const Problem& problem, bool quick) try {
  return problem.run(quick);
} catch (const std::runtime_error& error) {
  throw SolverError(error.what());
}

ProblemResult solved(const Problem& problem, bool quick, const std::string& key) {
  const CostMeter meter;
  ProblemResult result;
  result.problem = problem.name;
  result.quick = quick;
  result.key = key;
  result.provenance =
      provenance(fmt::format("./slosh problem {}{}", problem.name, quick ? " --quick" : ""));
  result.outcome = outcome_of(problem, quick);
  result.cost = meter.cost();
  return result;
}

void print(const ProblemOutcome& outcome) {
  for (const MeasuredErrors& measure : outcome.measures) {
    std::cout << measure.name << ":";
    for (const ErrorAtStep& one : measure.errors) std::cout << fmt::format(" {:.3g}", one.error);
    if (const auto order = order_of(measure.errors))
      std::cout << fmt::format(", order {:.2f}", *order);
    std::cout << "\n";
  }
}

}  // namespace

int run_problem(const ProblemOptions& options, const Installation& installation) {
  const Problem& problem = named_problem(options.problem);
  const std::string key = problem_key(problem, options.quick, installation.builds);
  const auto compute = [&] {
    ProblemResult result = solved(problem, options.quick, key);
    print(result.outcome);
    return result;
  };
  if (!options.store.empty()) {
    keep_problem(ResultStore(options.store), key, compute);
    return exit_pass;
  }
  const fs::path file = options.output.empty() ? fs::path(problem.name + ".json") : options.output;
  write_problem_result(compute(), file);
  std::cout << "result: " << file.string() << "\n";
  return exit_pass;
}

}  // namespace slosh
