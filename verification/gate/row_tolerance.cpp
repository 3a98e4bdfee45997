#include "verification/gate/row_tolerance.hpp"

namespace slosh {

std::optional<AllowedRange> tolerance_of(const CaseDefinition& definition,
                                         const Comparison& comparison, const std::string& mode,
                                         Metric metric) {
  for (const GateRow& row : definition.gate)
    if (row.metric == metric && row.mode == mode && (row.limit || row.between) &&
        row.candidate == comparison.candidate && row.reference == comparison.reference &&
        row.quantity == comparison.quantity)
      return allowed_by(row);
  return std::nullopt;
}

}  // namespace slosh
