#include "verification/input/units.hpp"

#include <map>
#include <stdexcept>

namespace slosh {
namespace {

// Exact, by the definitions of the SI brochure (9th edition, 2019): the bar is 100 kPa.
const std::map<std::string, std::vector<Unit>> units{
    {"s", {{"s", 1}, {"ms", 1e-3}, {"min", 60}}},
    {"m", {{"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}}},
    {"Pa", {{"Pa", 1}, {"kPa", 1e3}, {"mbar", 1e2}, {"bar", 1e5}}},
    {"N/m", {{"N/m", 1}, {"kN/m", 1e3}}},
    // Moments per metre of width.
    {"N", {{"N", 1}, {"kN", 1e3}}},
    // Momentum per metre of width.
    {"kg/s", {{"kg/s", 1}}}};

}  // namespace

std::vector<Unit> units_of(const std::string& si_unit) {
  const auto found = units.find(si_unit);
  return found == units.end() ? std::vector<Unit>{{si_unit, 1}} : found->second;
}

std::vector<std::string> unit_names(const std::string& si_unit) {
  std::vector<std::string> names;
  for (const Unit& unit : units_of(si_unit)) names.push_back(unit.name);
  return names;
}

double si_value(const std::string& unit, const std::string& si_unit) {
  for (const Unit& one : units_of(si_unit))
    if (one.name == unit) return one.si;
  throw std::invalid_argument(unit + " is no unit of what is measured in " + si_unit);
}

}  // namespace slosh
