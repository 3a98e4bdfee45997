#include "verification/assessment/work_points.hpp"

#include <algorithm>

#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"

namespace slosh {
namespace {

// A theory without the gas: its difference from a theory with the gas would be no error.
bool is_theory_of_liquid(const RunDefinition& run) { return is_theory(run) && !sees_gas(run); }

std::vector<const RunDefinition*> references_in_range(const CaseAssessment& assessment) {
  std::vector<const RunDefinition*> found;
  for (const RunDefinition& run : assessment.definition.runs)
    if (is_theory_of_liquid(run) && assessment.runs.results.contains(run.name) &&
        assessment.runs.status.at(run.name).state == RunState::finished)
      found.push_back(&run);
  return found;
}

}  // namespace

std::vector<WorkFamily> work_families(const CaseAssessment& assessment) {
  std::vector<WorkFamily> families;
  for (const Comparison* judging : judging_comparisons(assessment)) {
    const RunDefinition& run = run_named(assessment.definition, judging->candidate);
    const std::string name = work_family(run);
    auto family = std::find_if(families.begin(), families.end(), [&](const WorkFamily& one) {
      return one.name == name && one.reference == judging->reference;
    });
    if (family == families.end())
      family = families.insert(family, {name, judging->reference, is_changed(run), {}});
    family->runs.push_back(work_run(run, assessment.runs, judging->normalised_rms));
  }
  for (WorkFamily& family : families) sort_by_resolution(family);
  return families;
}

std::vector<WorkFamily> reference_families(const CaseAssessment& assessment) {
  const std::string quantity = compared_quantities(assessment.definition).front();
  const auto references = references_in_range(assessment);
  CaseEvidence evidence(assessment.definition, assessment.runs, &assessment.fitted);
  std::vector<WorkFamily> families;
  for (const RunDefinition* run : references) {
    const auto other = std::find_if(references.begin(), references.end(),
                                    [&](const RunDefinition* one) { return one != run; });
    if (other == references.end()) continue;
    try {
      const Comparison& apart = evidence.comparison(run->name, (*other)->name, quantity);
      families.push_back({run->name,
                          (*other)->name,
                          false,
                          {work_run(*run, assessment.runs, apart.normalised_rms)}});
    } catch (const std::runtime_error&) {  // ComparisonError and ResultError: nothing to show
      continue;
    }
  }
  return families;
}

}  // namespace slosh
