#include "verification/input/units.hpp"

#include <algorithm>
#include <map>
#include <set>
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

const std::map<std::string, std::string> other_spellings{{"sec", "s"},     {"seconds", "s"},
                                                         {"mBar", "mbar"}, {"Bar", "bar"},
                                                         {"N/m2", "Pa"},   {"N/m^2", "Pa"}};

// Recognised, so that a column in one of them is not taken for one in another.
const std::set<std::string> units_unread{
    "hPa", "MPa", "atm",  "psi",  "mmHg",  "us",    "h",     "Hz",     "ft",    "in",
    "km",  "m/s", "cm/s", "mm/s", "m/s2",  "m/s^2", "deg",   "rad",    "deg/s", "V",
    "mV",  "m2",  "m3",   "kg",   "rad/s", "K",     "kg/m3", "kg/m^3", "kg/m2", "kg m/s"};

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

std::string unit_spelt(const std::string& unit) {
  const auto found = other_spellings.find(unit);
  return found == other_spellings.end() ? unit : found->second;
}

bool is_unit(const std::string& text) {
  const std::string unit = unit_spelt(text);
  return units_unread.contains(unit) ||
         std::any_of(units.begin(), units.end(), [&](const auto& of_kind) {
           return std::any_of(of_kind.second.begin(), of_kind.second.end(),
                              [&](const Unit& one) { return one.name == unit; });
         });
}

std::string unit_at_end(const std::string& name, const std::string& si_unit) {
  const std::size_t bar = name.rfind('_');
  if (bar == name.npos || bar == 0) return "";
  const std::string unit = unit_spelt(name.substr(bar + 1));
  const std::vector<std::string> known = unit_names(si_unit);
  return std::find(known.begin(), known.end(), unit) == known.end() ? "" : unit;
}

}  // namespace slosh
