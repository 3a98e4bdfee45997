// The units in which other programs and laboratories write what this project keeps in SI units: one
// table for whoever reads their files.
#pragma once

#include <string>
#include <vector>

namespace slosh {

struct Unit {
  std::string name;
  double si;  // how many of the SI unit it is
};

// Those of the quantities in this SI unit ("s", "m", "Pa", "N/m", "N", "kg/s"), itself first; of
// another the unit alone.
std::vector<Unit> units_of(const std::string& si_unit);

// Their names alone, in the same order.
std::vector<std::string> unit_names(const std::string& si_unit);

// How many of the SI unit one of the units is. Throws std::invalid_argument for none of them.
double si_value(const std::string& unit, const std::string& si_unit);

}  // namespace slosh
