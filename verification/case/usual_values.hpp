// What a case file means where it says nothing: the earth's gravity, water and air at 20 °C, each
// rounded as the papers of the field round it.
#pragma once

#include "verification/case/case_definition.hpp"

namespace slosh {

// [m/s2]. Standard gravity is 9.80665 (3rd CGPM, 1901).
inline constexpr double usual_gravity = 9.81;

// Water at 20 °C and 101325 Pa has 998.2 kg/m3 (IAPWS R6-95) and 1.003e-6 m2/s (IAPWS R12-08).
inline constexpr double water_density = 1000;              // [kg/m3]
inline constexpr double water_kinematic_viscosity = 1e-6;  // [m2/s]

// Dry air at 20 °C and 101325 Pa has 1.204 kg/m3 and 1.51e-5 m2/s: the equation of state and
// Sutherland's formula as ISO 2533:1975 gives them.
inline constexpr GasDefinition air{.density = 1.2, .kinematic_viscosity = 1.5e-5};

}  // namespace slosh
