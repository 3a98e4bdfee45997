#include "verification/runs/cost_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <variant>

#include "verification/case/shape/tank_shape.hpp"
#include "verification/runs/run_effort.hpp"

namespace slosh {
namespace {

constexpr double nanosecond = 1e-9, microsecond = 1e-6, millisecond = 1e-3;

// The figures of the model were measured on an idle two-core virtual machine. The same machine at
// work takes longer by this factor; a crowded one takes longer still.
constexpr double at_work = 1.4;

struct SchemeWork {
  double support;      // of the kernel [h]
  double ratio;        // h / dp
  double evaluations;  // of the sums in a step
  double terms;        // cost of its terms over that of `recommended`
};

SchemeWork work_of(const SphRun& sph) {
  SchemeWork work{3, 1.5, 1, 1};
  const std::string& variant = sph.variant;
  const bool wendland = variant.starts_with("wendland_");
  if (sph.scheme == "li2010") work = {2, 1.5, 2, 1.4};
  if (sph.scheme == "delta_sph") work = {2, 2, 1, 3};
  if (sph.scheme.starts_with("zhao2021")) work = {2, 1.5, 2, 1.5};
  if (wendland || variant == "cubic_spline") work.support = 2;
  if (variant == "predictor_corrector" || variant == "symplectic") work.evaluations = 2;
  if (variant == "antuono") work.terms = 2;
  work.ratio = sph.numbers.smoothing_length_ratio.value_or(work.ratio);
  return work;
}

double time_of(const SphRun& sph, const RunEffort& effort, const CaseDefinition&) {
  const SchemeWork work = work_of(sph);
  const double reach = work.support * work.ratio,  // [dp]
      neighbours = std::numbers::pi * reach * reach;
  return effort.steps * effort.elements * work.evaluations * work.terms * (24 + 1.16 * neighbours) *
         nanosecond;
}

// The first of a step's pressure corrections costs more than the later ones, which start near their
// solution. In a shallow tank bores and the gas that they drive halve the steps, and the pressure
// takes twice as many iterations. This was measured on one run alone, the violent roll on 90 x 51
// cells.
double time_of(const InterFoamRun&, const RunEffort& effort, const CaseDefinition& definition) {
  constexpr double start = 0.5;                // [s], the mesh and the reading of the results
  constexpr double shallow = 0.15, bores = 3;  // depth over length; times as long
  const double equations =
      effort.outer_corrections * (effort.pressure_corrections + 2) / 4.0 * effort.elements;
  const bool is_shallow =
      definition.liquid.fill_depth < shallow * still_surface(definition).length();
  return start + effort.steps * (is_shallow ? bores : 1) *
                     (0.36 * millisecond + equations * 0.83 * microsecond);
}

// The flow is solved on all nodes, and on three quarters of them along each axis.
double time_of(const PotentialRun&, const RunEffort& effort, const CaseDefinition& definition) {
  const double nodes = std::pow(effort.elements, 1.6) + std::pow(effort.elements * 9 / 16, 1.6);
  return effort.steps * nodes * 0.06 * microsecond * (definition.motion.roll ? 1.6 : 1);
}

double time_of(const LinearRun&, const RunEffort& effort, const CaseDefinition&) {
  return effort.steps * effort.elements * 0.2 * microsecond;
}

// Nothing is known of an external program. A record, a stored result or a formula takes no more
// than the start of its process.
double time_of(const ExternalRun&, const RunEffort&, const CaseDefinition&) { return 0; }
double time_of(const RecordRun&, const RunEffort&, const CaseDefinition&) { return 0; }
double time_of(const StoredRun&, const RunEffort&, const CaseDefinition&) { return 0; }
double time_of(const ViscousWaveRun&, const RunEffort&, const CaseDefinition&) { return 0; }

}  // namespace

double modelled_time(const CaseDefinition& definition, const RunDefinition& run) {
  constexpr double shortest = 0.02;  // [s], of any process
  const RunEffort effort = run_effort(definition, run);
  return std::max(
      shortest,
      at_work * std::visit([&](const auto& solver) { return time_of(solver, effort, definition); },
                           run.solver));
}

}  // namespace slosh
