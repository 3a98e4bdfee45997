// How far from rest each run of a still tank is: the largest values of what SPH records of it
// (sph/still_water.hpp).
#pragma once

#include <optional>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"

namespace slosh {

// The series that a still tank's SPH run leaves beside its elevations.
inline constexpr const char* rest_quantities[] = {
    "hydrostatic_pressure_error", "kinetic_over_potential_energy", "wall_gap", "volume_drift"};

// Over the whole run and over the comparison's window. Nothing where no run recorded any.
std::optional<reports::Table> rest_table(const CaseAssessment& assessment);

}  // namespace slosh
