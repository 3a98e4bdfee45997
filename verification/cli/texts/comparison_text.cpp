#include "verification/cli/texts/comparison_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <vector>

#include "verification/case/quantities.hpp"
#include "verification/evidence/soundness.hpp"
#include "verification/gate/impact_metrics.hpp"

namespace slosh {
namespace {

using nlohmann::ordered_json;

std::string numbers_text(const ImpactNumbers& impact) {
  std::string text = impact.peak ? fmt::format("peak {:.4g} Pa at {:.4f} s", impact.peak->pressure,
                                               impact.peak->time)
                                 : std::string("no impact");
  const auto add = [&](const char* what, const std::optional<double>& value, const char* unit) {
    if (value) text += fmt::format(", {} {:.4g} {}", what, *value, unit);
  };
  add("rise time", impact.rise_time, "s");
  if (impact.arrival) text += fmt::format(", arrival {:.4f} s", *impact.arrival);
  add("impulse", impact.impulse, "Pa s");
  return text;
}

std::vector<ImpactNumbers> published_numbers(const ImpactsDefinition& impacts) {
  std::vector<ImpactNumbers> all;
  for (std::size_t n = 0; n < impacts.times.size(); ++n) {
    ImpactNumbers one{.peak = ImpactPeak{impacts.times[n], impacts.peak_means[n]}};
    if (impacts.rise_times) one.rise_time = impacts.rise_times->values[n];
    if (impacts.arrivals) one.arrival = impacts.arrivals->times[n];
    if (impacts.impulses) one.impulse = impacts.impulses->values[n];
    all.push_back(one);
  }
  return all;
}

// Empty where the series cannot be searched; `lines` then says why.
std::vector<ImpactNumbers> found_numbers(const CaseDefinition& definition, const char* role,
                                         const TimeSeries& series, std::string& lines) try {
  return impact_numbers(series, definition);
} catch (const ComparisonError& error) {
  lines += fmt::format("impacts of {}: {}\n", role, error.what());
  return {};
}

// A series that does not cover the plateau has a line that says why.
std::string plateau_line(const CaseDefinition& definition, const char* role,
                         const TimeSeries& series) try {
  const double error = plateau_error(series, definition);
  return fmt::format("plateau of {}: {:.4g} Pa, {:+.3g} %\n", role,
                     (1 + error) * definition.impacts->plateau, 100 * error);
} catch (const ComparisonError& error) {
  return fmt::format("plateau of {}: {}\n", role, error.what());
}

std::string plateau_lines(const CaseDefinition& definition, const TimeSeries& candidate,
                          const TimeSeries& reference) {
  if (!(definition.impacts->plateau > 0)) return "";
  return plateau_line(definition, "the candidate", candidate) +
         plateau_line(definition, "the reference", reference) +
         fmt::format("plateau as published: {:.4g} Pa\n", definition.impacts->plateau);
}

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

bool has_impacts(const CaseDefinition& definition, const std::string& quantity) {
  if (!definition.impacts) return false;
  const std::vector<std::string> pressures = impact_pressures(definition);
  return std::find(pressures.begin(), pressures.end(), quantity) != pressures.end();
}

std::string impact_lines(const CaseDefinition& definition, const TimeSeries& candidate,
                         const TimeSeries& reference) {
  std::string lines;
  const auto of_candidate = found_numbers(definition, "the candidate", candidate, lines);
  const auto of_reference = found_numbers(definition, "the reference", reference, lines);
  const auto published = published_numbers(*definition.impacts);
  const auto add = [&](std::size_t n, const char* whose, const std::vector<ImpactNumbers>& all) {
    if (n < all.size())
      lines += fmt::format("impact_{} {}: {}\n", n + 1, whose, numbers_text(all[n]));
  };
  for (std::size_t n = 0; n < published.size(); ++n) {
    add(n, "of the candidate", of_candidate);
    add(n, "of the reference", of_reference);
    add(n, "as published", published);
  }
  return lines + plateau_lines(definition, candidate, reference);
}

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
