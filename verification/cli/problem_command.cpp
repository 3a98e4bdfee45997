// The subcommand problem: solves one verification problem in this process.

#include <fmt/format.h>

#include <iostream>
#include <memory>

#include "verification/assessment/problem_assessment.hpp"
#include "verification/cli/command_tree.hpp"
#include "verification/cli/stored_run.hpp"
#include "verification/files/own_files.hpp"
#include "verification/gate/gate.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/problems/problem_list.hpp"
#include "verification/results/provenance.hpp"
#include "verification/runs/run_case.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

struct ProblemOptions {
  std::string problem;
  bool quick = false;
  std::filesystem::path output;  // empty: NAME.json
  std::filesystem::path store;   // the result is kept there under its key; empty: in the output
};

// Throws CaseFileError for an unknown name.
const Problem& named_problem(const std::string& name) try {
  return find_problem(name);
} catch (const std::invalid_argument& error) {
  throw CaseFileError(error.what());
}

// Throws SolverError if the solver fails.
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

int run_problem(const ProblemOptions& options, const Installation& installation) {
  const Problem& problem = named_problem(options.problem);
  const std::string key = problem_key(problem, options.quick, installation.builds);
  const auto compute = [&] {
    ProblemResult result = solved(problem, options.quick, key);
    print(result.outcome);
    return result;
  };
  if (!options.store.empty()) {
    keep_problem(ResultStore(whole(options.store)), key, compute);
    return exit_pass;
  }
  const fs::path file = options.output.empty() ? fs::path(problem.name + ".json") : options.output;
  const OpenOutputs output(file, "problem");
  const ProblemResult result = compute();
  output.make_room();
  write_problem_result(result, file);
  std::cout << "result: " << file.string() << "\n";
  return exit_pass;
}

}  // namespace

void add_problem_command(const CommandTree& tree) {
  auto options = std::make_shared<ProblemOptions>();
  CLI::App& command = add_command(
      tree,
      {"problem",
       "Solves one verification problem and writes its errors at each resolution",
       {"./slosh problem rigid_rotation --quick"}},
      [options, &installation = tree.installation] { return run_problem(*options, installation); });
  command.add_option("name", options->problem, "A problem of `slosh list`")
      ->type_name(problem_type)
      ->required();
  command.add_flag("--quick", options->quick, "Without the finest resolutions");
  command.add_option("-o,--output", options->output, "Result file (default: NAME.json)")
      ->type_name(file_type);
  add_result_store_option(command, options->store);
}

}  // namespace slosh
