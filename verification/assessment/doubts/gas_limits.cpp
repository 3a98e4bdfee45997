#include "verification/assessment/doubts/gas_limits.hpp"

#include <fmt/format.h>

#include <numbers>

#include "verification/case/solver_kinds.hpp"
#include "verification/solvers/theory/natural_frequencies.hpp"

namespace slosh {
namespace {

// Programs and stored results of the user may know the gas.
bool leaves_out_gas(const RunDefinition& run) {
  return solver_kind(run).answered_with == AnsweredWith::own_code && !is_record(run) &&
         !sees_gas(run);
}

}  // namespace

std::vector<ModelLimit> gas_limits(const CaseDefinition& definition) {
  using std::numbers::pi;
  const std::vector<double> frequencies = natural_frequencies(definition, 1);
  const std::vector<std::string> runs = runs_with(definition, leaves_out_gas);
  if (frequencies.empty() || runs.empty()) return {};
  const double hertz = frequencies.front() / (2 * pi), lost = share_lost_to_gas(definition);
  return {{fmt::format("the gas above the liquid, of {:.4g} kg/m3, which lowers the first natural "
                       "frequency from {:.4g} to {:.4g} Hz, in {}",
                       definition.gas.density, hertz, hertz * (1 - lost), few_of(runs)),
           lost, seen_share / (2 * pi), "of the first natural frequency",
           "Lamb, Hydrodynamics, article 231"}};
}

}  // namespace slosh
