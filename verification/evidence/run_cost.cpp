#include "verification/evidence/run_cost.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "verification/case/ensemble.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/series/sample_moments.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {
namespace {

Estimate mean_with_interval(const std::vector<double>& values) {
  const double n = static_cast<double>(values.size());
  if (values.size() < 2) return {mean(values), not_a_number};
  const double t = t95(n - 1);
  return {mean(values), t * rms(without_mean(values)) / std::sqrt(n - 1)};
}

std::vector<WorkPoint> points_of(const WorkFamily& family, Estimate MeasuredCost::*cost) {
  std::vector<WorkPoint> points;
  for (const WorkRun& run : family.runs)
    points.push_back({run.run, run.resolution, run.cost.*cost, run.error});
  return points;
}

// The runs of the candidate's family that `comparison` can compare. Throws what it throws for the
// candidate itself.
WorkFamily family_of_row(const CaseDefinition& definition, const CaseRuns& runs, const GateRow& row,
                         const FindComparison& comparison) {
  const std::string name = work_family(run_named(definition, row.candidate));
  WorkFamily family{name, row.reference, false, {}};
  for (const RunDefinition& run : definition.runs) {
    if (work_family(run) != name || is_later_member(run) || !runs.results.contains(run.name))
      continue;
    try {
      family.runs.push_back(
          work_run(run, runs, comparison(run.name, row.reference, row.quantity).normalised_rms));
    } catch (const std::runtime_error&) {  // ComparisonError and ResultError: no error to count
      if (run.name == row.candidate) throw;
    }
  }
  sort_by_resolution(family);
  return family;
}

void require_all_runs(const CaseDefinition& definition, const CaseRuns& runs,
                      const WorkFamily& family) {
  for (const RunDefinition& run : definition.runs)
    if (work_family(run) == family.name && runs.status.at(run.name).state == RunState::not_selected)
      throw NotSelectedError(fmt::format(
          "not reached, but the run {} is not part of this form of the campaign", run.name));
}

void require_timings(const WorkFamily& family, const CostAtError& found) {
  std::vector<std::string> lacking;
  for (const WorkRun& run : family.runs)
    if (!run.cost.has_interval() &&
        std::find(found.rests_on.begin(), found.rests_on.end(), run.run) != found.rests_on.end())
      lacking.push_back(run.run);
  if (!lacking.empty())
    throw ComparisonError(fmt::format(
        "{} {} not timed twice or more on a core of {} own: run the campaign with timings",
        fmt::join(lacking, " and "), lacking.size() == 1 ? "was" : "were",
        lacking.size() == 1 ? "its" : "their"));
}

std::string measured_elsewhere(const RunResult& result) {
  if (result.cost.core_seconds() == 0)
    return fmt::format("stored result of {}: its cost is not known",
                       result.provenance.at("stored_software"));
  return fmt::format("stored result of {}: its cost was measured on another machine, {}",
                     result.provenance.at("stored_software"),
                     result.provenance.at("stored_machine"));
}

// Empty where the run has kept to its cores, or is not bound.
std::string left_cores(const RunDefinition& run, const RunCost& cost) {
  constexpr double allowance = 1.05;
  const auto* external = std::get_if<ExternalRun>(&run.solver);
  if (!external || !external->cores ||
      cost.core_seconds() <= allowance * cost.wall_time * *external->cores)
    return "";
  return fmt::format("{:.3g} core-seconds in {:.3g} s: more than its cores = {} have",
                     cost.core_seconds(), cost.wall_time, *external->cores);
}

}  // namespace

MeasuredCost cost_of(const CaseRuns& runs, const std::string& run) {
  const auto timed = runs.timings.find(run);
  if (timed == runs.timings.end() || timed->second.empty()) {
    const RunResult& result = runs.results.at(run);
    return {.core_seconds = {result.cost.core_seconds(), not_a_number},
            .memory = {result.cost.peak_memory, not_a_number},
            .timings = 0,
            .elsewhere = result.provenance.contains("stored_software")};
  }
  std::vector<double> times, memories;
  for (const RunCost& one : timed->second) {
    times.push_back(one.core_seconds());
    memories.push_back(one.peak_memory);
  }
  return {mean_with_interval(times), mean_with_interval(memories), times.size()};
}

void mark_other_costs(const CaseDefinition& definition, CaseRuns& runs) {
  for (const RunDefinition& run : definition.runs) {
    const auto result = runs.results.find(run.name);
    if (result == runs.results.end()) continue;
    const std::string remark =
        is_stored(run) ? measured_elsewhere(result->second) : left_cores(run, result->second.cost);
    std::string& message = runs.status.at(run.name).message;
    if (!remark.empty()) message += (message.empty() ? "" : "; ") + remark;
  }
}

WorkRun work_run(const RunDefinition& run, const CaseRuns& runs, const Estimate& error) {
  return {run.name, resolution(run), cost_of(runs, run.name), error};
}

void sort_by_resolution(WorkFamily& family) {
  std::stable_sort(family.runs.begin(), family.runs.end(),
                   [](const WorkRun& a, const WorkRun& b) { return a.resolution < b.resolution; });
}

std::vector<WorkPoint> by_core_seconds(const WorkFamily& family) {
  return points_of(family, &MeasuredCost::core_seconds);
}

std::vector<WorkPoint> by_memory(const WorkFamily& family) {
  std::vector<WorkPoint> points = points_of(family, &MeasuredCost::memory);
  std::erase_if(points, [](const WorkPoint& point) { return point.cost.value == 0; });
  return points;
}

RowDoubts left_out_as_compiling(const CaseDefinition& definition, const CaseRuns& runs,
                                const GateRow& row) {
  const std::string name = work_family(run_named(definition, row.candidate));
  constexpr double least_kept = 0.1;  // [s]; a first start may take so much to load the program
  double largest = 0;
  std::string text, kept;
  for (const RunDefinition& run : definition.runs) {
    const auto found = runs.results.find(run.name);
    if (work_family(run) != name || found == runs.results.end()) continue;
    const Estimate again = cost_of(runs, run.name).core_seconds;
    const double first = found->second.cost.core_seconds();
    if (first > 2 * (again.value + again.half_width) && first > again.value + least_kept)
      kept += fmt::format(
          "; doubtful: {} took {:.2g} s of one core when it ran first: it may keep "
          "what it computes",
          run.name, first);
    const auto said = found->second.diagnostics.find("compile_processor_time_s");
    if (said == found->second.diagnostics.end()) continue;
    const double share = said->second / (said->second + found->second.cost.core_seconds());
    if (!(share > largest)) continue;
    largest = share;
    text = fmt::format(
        "{} says itself that {:.3g} s were compiling, {} of what it took; they do not count",
        run.name, said->second, in_unit(share, "1"));
  }
  const bool is_most = largest > 0.5;
  return {kept + (text.empty() ? "" : (is_most ? "; doubtful: " : "; ") + text), false,
          is_most || !kept.empty()};
}

CostAtError cost_to_reach(const CaseDefinition& definition, const CaseRuns& runs,
                          const GateRow& row, const FindComparison& comparison) {
  const WorkFamily family = family_of_row(definition, runs, row, comparison);
  CostAtError found = cost_at_error(by_core_seconds(family), row.error.value());
  if (found.reach == Reach::not_at_all) require_all_runs(definition, runs, family);
  require_timings(family, found);
  // The cost is then an upper bound, which is enough to pass where it is within the limit.
  if (found.reach == Reach::by_cheapest && row.limit && found.cost > *row.limit)
    throw ComparisonError(fmt::format(
        "the error of {} is below {} at {}: without a coarser run the cost of that error is "
        "unknown",
        found.rests_on.front(), in_unit(*row.error, "1"), in_unit(found.cost, row.unit)));
  return found;
}

}  // namespace slosh
