// The subcommand converge: an SPH scheme of a case at several spacings against a reference, run and
// compared as a campaign is, on a case file made for it.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "verification/campaign/campaign_run.hpp"
#include "verification/campaign/convergence.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/case_file/quantities.hpp"
#include "verification/case_file/spacing_study.hpp"
#include "verification/commands/command_tree.hpp"
#include "verification/named_paths.hpp"
#include "verification/runs/atomic_file.hpp"
#include "verification/runs/run_case.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct ConvergeOptions {
  std::string case_name, quantity;
  SpacingStudy study;
  fs::path output, experiments;
  int at_once = 1;
  bool as_json = false;
};

// Two-layer theory is that of the solvers that see the gas.
bool can_refer(const RunDefinition& run) {
  if (const auto* record = std::get_if<RecordRun>(&run.solver)) return record->supplied;
  const auto* linear = std::get_if<LinearRun>(&run.solver);
  return !std::holds_alternative<SphRun>(run.solver) && !(linear && linear->two_layer);
}

// The first theory or record that the case declares, or else its last interFoam run: case files
// list meshes from coarse to fine.
std::string default_reference(const CaseDefinition& definition) {
  std::string mesh;
  for (const RunDefinition& run : definition.runs) {
    if (!can_refer(run)) continue;
    if (!std::holds_alternative<InterFoamRun>(run.solver)) return run.name;
    mesh = run.name;
  }
  if (mesh.empty())
    throw CaseFileError(definition.file.string() +
                        ": expected a run that the scheme can be compared with, of any solver but "
                        "SPH");
  return mesh;
}

std::string asked_quantity(const CaseDefinition& definition, const std::string& asked) {
  const std::vector<std::string> known = compared_quantities(definition);
  if (asked.empty()) return known.front();
  if (std::find(known.begin(), known.end(), asked) != known.end()) return asked;
  std::string names;
  for (const std::string& one : known) names += (names.empty() ? "" : ", ") + one;
  throw CaseFileError(fmt::format("quantity = {}: expected one of {}", asked, names));
}

// Reads the made case, too, so that all it gets wrong is told before anything runs.
CaseDefinition made_case(const CaseDefinition& definition, const SpacingStudy& study,
                         const fs::path& directory, const fs::path& experiments) {
  const fs::path file = directory / (definition.name + ".toml");
  replace_file(file, spacing_study_text(definition, study), Durability::process_crash);
  CaseDefinition made = read_case(file, experiments);
  for (const RunDefinition& run : made.runs) require_runnable(made, run);
  return made;
}

std::string plus_minus(double value, double half_width, const std::string& unit) {
  const double scale = unit == "1" ? 100 : 1;
  return fmt::format("{:.3g} ± {:.2g} {}", scale * value, scale * half_width,
                     unit == "1" ? "%" : unit);
}

std::string order_text(const ConvergedMetric& metric) {
  const auto& order = metric.refined.found.order;
  if (!order) return "no order";
  return fmt::format("order {:.2f} {}", *order,
                     metric.order_half_width ? fmt::format("± {:.2f}", *metric.order_half_width)
                                             : "(which the values' intervals leave open)");
}

void print_text(const std::vector<ConvergedMetric>& metrics) {
  for (const ConvergedMetric& metric : metrics) {
    const GateRow& row = metric.row;
    const DiscretisationUncertainty& found = metric.refined.found;
    std::cout << fmt::format("\n{} {} of {}\n", row.mode, metric_name(row.metric), row.quantity);
    for (const ValueAtStep& one : metric.refined.values)
      std::cout << fmt::format("  {:>8.4g} mm   {}\n", 1000 * one.step,
                               plus_minus(one.value, one.noise, row.unit));
    std::cout << fmt::format("  {}, {}; at no spacing {}; uncertainty of the finest {}\n",
                             behaviour_name(found.behaviour), order_text(metric),
                             in_unit(found.extrapolated, row.unit),
                             in_unit(found.uncertainty, row.unit));
    std::cout << "  " << found.explanation << "\n";
  }
}

ordered_json number_or_null(const std::optional<double>& number) {
  return number ? ordered_json(*number) : ordered_json(nullptr);
}

ordered_json json_of(const ConvergedMetric& metric) {
  const DiscretisationUncertainty& found = metric.refined.found;
  ordered_json values = ordered_json::array();
  for (std::size_t i = 0; i < metric.refined.values.size(); ++i)
    values.push_back({{"run", metric.refined.runs[i]},
                      {"particle_spacing_m", metric.refined.values[i].step},
                      {"value", metric.refined.values[i].value},
                      {"half_width_95", metric.refined.values[i].noise}});
  return {{"mode", metric.row.mode},
          {"metric", metric_name(metric.row.metric)},
          {"unit", metric.row.unit},
          {"values", values},
          {"behaviour", behaviour_name(found.behaviour)},
          {"order", number_or_null(found.order)},
          {"order_half_width_95", number_or_null(metric.order_half_width)},
          {"extrapolated", found.extrapolated},
          {"uncertainty_95", found.uncertainty},
          {"explanation", found.explanation}};
}

struct Study {
  CaseAssessment assessment;
  ConvergenceQuestion question;
  std::vector<ConvergedMetric> metrics;
};

void print_head(const Study& study) {
  const CaseDefinition& definition = study.assessment.definition;
  std::cout << fmt::format("{}: {} against {}\n", definition.name, study.question.quantity,
                           study.question.reference);
  for (const RunDefinition& run : definition.runs) {
    const RunStatus& status = study.assessment.runs.status.at(run.name);
    const auto result = study.assessment.runs.results.find(run.name);
    std::cout << fmt::format("  {:<28} {}", run.name, state_name(status.state));
    if (!status.message.empty()) std::cout << ": " << status.message;
    if (result != study.assessment.runs.results.end())
      std::cout << fmt::format(", {:.3g} core-seconds",
                               result->second.cost.user_time + result->second.cost.system_time);
    std::cout << "\n";
  }
}

void print_json(const Study& study) {
  ordered_json document{{"case", study.assessment.definition.name},
                        {"case_file", study.assessment.definition.file.string()},
                        {"quantity", study.question.quantity},
                        {"reference", study.question.reference},
                        {"metrics", ordered_json::array()}};
  for (const ConvergedMetric& metric : study.metrics)
    document["metrics"].push_back(json_of(metric));
  std::cout << document.dump(2) << "\n";
}

int status_of(const Study& study) {
  for (const auto& [run, status] : study.assessment.runs.status)
    if (status.state == RunState::failed) return exit_solver_failed;
  return study.metrics.empty() ? exit_not_compared : exit_pass;
}

int converge(const ConvergeOptions& options, const CommandTree& tree) {
  if (options.study.candidate.empty() && options.study.family.empty())
    throw CaseFileError("expected --candidate RUN or --family SCHEME: what is to converge");
  tree.stop_on_signals();
  const fs::path experiments = whole(options.experiments);
  const CaseDefinition definition =
      read_case(find_case(options.case_name, tree.installation.cases), experiments);
  SpacingStudy study = options.study;
  if (study.reference.empty()) study.reference = default_reference(definition);
  const std::string quantity = asked_quantity(definition, options.quantity);
  const std::string scheme = study.candidate.empty() ? study.family : study.candidate;
  const fs::path output =
      fs::absolute(options.output.empty()
                       ? tree.installation.build / "converge" / (definition.name + "-" + scheme)
                       : options.output);
  const CaseDefinition made = made_case(definition, study, output, experiments);
  CampaignSettings settings{output,
                            tree.installation.executable,
                            tree.installation.solver_build,
                            tree.installation.problem_build,
                            tree.installation.openfoam_templates,
                            experiments};
  settings.at_once = options.at_once;
  const double finest = *std::min_element(study.spacings.begin(), study.spacings.end());
  Study done{assess(made, run_cases({made}, settings, tree.stop).front()),
             {study_run_name(study, finest), study.reference, quantity},
             {}};
  done.metrics = converged_metrics(done.assessment, done.question);
  if (options.as_json) {
    print_json(done);
  } else {
    print_head(done);
    print_text(done.metrics);
  }
  return status_of(done);
}

}  // namespace

void add_converge_command(const CommandTree& tree) {
  auto options = std::make_shared<ConvergeOptions>();
  const std::string example =
      "./slosh converge li2010_small_amplitude --family recommended --spacings 0.05,0.035,0.025 "
      "-o orders";
  CLI::App& command = add_command(
      tree,
      {"converge",
       "Runs an SPH scheme of a case at several spacings and tells the order of its errors",
       {example, example + " --json"}},
      [options, tree] { return converge(*options, tree); });
  command.add_option("case", options->case_name, "A case of `slosh list`, or a case file's path")
      ->type_name(case_type)
      ->required();
  CLI::Option* candidate =
      command
          .add_option("--candidate", options->study.candidate,
                      "A run of the case, all of whose settings but the spacing are kept")
          ->type_name(run_type);
  command.add_option("--family", options->study.family, "Or a scheme as it is")
      ->type_name("SCHEME")
      ->excludes(candidate);
  command.add_option("--spacings", options->study.spacings, "Three or more particle spacings [m]")
      ->type_name("M,M,M")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->required();
  command
      .add_option("--reference", options->study.reference,
                  "The run of the case to compare with (default: its first theory or record)")
      ->type_name(run_type);
  command
      .add_option("--quantity", options->quantity,
                  "What is compared (default: what the case is about)")
      ->type_name("QUANTITY");
  command
      .add_option("-o,--output", options->output,
                  "Directory of the case file that is made and its results (default: "
                  "build/converge/CASE-SCHEME)")
      ->type_name(directory_type);
  command.add_flag("--json", options->as_json, "As JSON");
  add_jobs_option(command, options->at_once, "Runs side by side");
  add_experiments_option(command, options->experiments);
}

}  // namespace slosh
