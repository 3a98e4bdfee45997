// The units in which other programs and laboratories write quantities. The project itself keeps
// them in SI units.
#pragma once

#include <string>
#include <vector>

namespace slosh {

struct Unit {
  std::string name;
  double si;  // in the SI unit
};

// Returns the units of quantities with this SI unit ("s", "m", "Pa", "N/m", "N", "kg/s"), the SI
// unit first. Any other unit is the only one of its quantities.
std::vector<Unit> units_of(const std::string& si_unit);

// Returns their names, in the same order.
std::vector<std::string> unit_names(const std::string& si_unit);

// Returns the value of a unit in the SI unit. Throws std::invalid_argument for an unknown unit.
double si_value(const std::string& unit, const std::string& si_unit);

// Returns the unit as it is written here, where laboratories write it otherwise: "mBar", "sec".
std::string unit_spelt(const std::string& unit);

// Whether the text is a unit: one of those above or one that is only recognised, as psi.
bool is_unit(const std::string& text);

// Returns the unit of this kind with which a name ends, "kPa" of "p_kPa"; else the empty text.
std::string unit_at_end(const std::string& name, const std::string& si_unit);

}  // namespace slosh
