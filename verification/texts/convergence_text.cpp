#include "verification/texts/convergence_text.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "verification/evidence/soundness.hpp"

namespace slosh {
namespace {

using nlohmann::ordered_json;

std::string order_text(const ConvergedMetric& metric) {
  const auto& order = metric.refined.found.order;
  if (!order) return "no order";
  return fmt::format("order {:.2f} {}", *order,
                     metric.order_half_width ? fmt::format("± {:.2f}", *metric.order_half_width)
                                             : "(its interval is unknown)");
}

std::string metric_text(const ConvergedMetric& metric) {
  const GateRow& row = metric.row;
  const DiscretisationUncertainty& found = metric.refined.found;
  std::string text =
      fmt::format("\n{} {} of {}\n", row.mode, metric_name(row.metric), row.quantity);
  for (const ValueAtStep& one : metric.refined.values)
    text += fmt::format("  {:>8.4g} mm   {}\n", 1000 * one.step,
                        with_interval({one.value, one.noise}, row.unit));
  return text +
         fmt::format(
             "  {}, {}; extrapolated to zero spacing {}; uncertainty of the finest {}\n  {}\n",
             behaviour_name(found.behaviour), order_text(metric),
             in_unit(found.extrapolated, row.unit), in_unit(found.uncertainty, row.unit),
             found.explanation);
}

std::string run_text(const std::string& run, const CaseRuns& runs) {
  const RunStatus& status = runs.status.at(run);
  std::string text = fmt::format("  {:<28} {}", run, state_name(status.state));
  if (!status.message.empty()) text += ": " + status.message;
  if (const auto result = runs.results.find(run); result != runs.results.end())
    text += fmt::format(", {:.3g} core-seconds", result->second.cost.core_seconds());
  return text + "\n";
}

// Of all runs of the study: the order rests on each.
std::string unsound_runs(const ConvergenceStudy& study) {
  std::set<std::string> named;
  for (const RunDefinition& run : study.assessment.definition.runs) named.insert(run.name);
  return soundness_doubt(study.assessment.definition, study.assessment.runs, named);
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

}  // namespace

std::string text_of(const ConvergenceStudy& study) {
  const CaseDefinition& definition = study.assessment.definition;
  std::string text = fmt::format("{}: {} against {}\n", definition.name, study.question.quantity,
                                 study.question.reference);
  for (const RunDefinition& run : definition.runs)
    text += run_text(run.name, study.assessment.runs);
  if (const std::string doubts = unsound_runs(study); !doubts.empty())
    text += "doubtful: " + doubts + "\n";
  for (const ConvergedMetric& metric : study.found.metrics) text += metric_text(metric);
  for (const std::string& one : study.found.not_measured) text += "\nnot measured: " + one + "\n";
  return text;
}

std::string json_of(const ConvergenceStudy& study) {
  ordered_json document{{"case", study.assessment.definition.name},
                        {"case_file", study.assessment.definition.file.string()},
                        {"quantity", study.question.quantity},
                        {"reference", study.question.reference},
                        {"doubtful", unsound_runs(study)},
                        {"metrics", ordered_json::array()},
                        {"not_measured", study.found.not_measured}};
  for (const ConvergedMetric& metric : study.found.metrics)
    document["metrics"].push_back(json_of(metric));
  return document.dump(2) + "\n";
}

}  // namespace slosh
