// A panel of a case: ensembles of several solvers that are compared with one another, where none of
// them is the reference. A panel judges no gate row. The table of what it compares says how each
// number is named in case files, its unit and what it is measured on; a new one is a row here and a
// value in assessment/across_runs/panel_values.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace slosh {

// What each member has by itself, without a reference.
enum class PanelMetric { impact_peak, impact_arrival, impulse, plateau, rms, lag };

struct PanelMetricEntry {
  PanelMetric metric;
  const char* name;
  const char* unit;         // "": the quantity's
  const char* description;  // in texts and captions
  bool of_each_impact;      // else it has one value, the mode "whole"
  bool of_impact_pressure;  // of the pressure at the gauge of [impacts] alone
  bool has_zero;            // so that a ratio of two values means something; a time has none
};

// In the order of the enumeration.
const std::vector<PanelMetricEntry>& panel_metric_table();
const PanelMetricEntry& panel_metric_entry(PanelMetric metric);
// The names of all, in the order of the table.
std::vector<std::string> panel_metric_names();
// "Pa" of impact_peak, the quantity's unit of rms.
std::string panel_unit(PanelMetric metric, const std::string& quantity_unit);

// A run that counts the air as compressible and one that does not, both of interFoam's kind.
struct AirPair {
  std::string compressible, incompressible;
};

struct PanelDefinition {
  std::string name;
  std::vector<std::string> runs;  // the first members of ensembles, two or more
  std::string quantity;           // one of compared_quantities()
  std::vector<PanelMetric> metrics;
  std::optional<double> impulse_duration = {};  // [s] from the arrival on, of the metric impulse
  std::optional<AirPair> air = {};              // two of the runs
  std::string reason;
};

}  // namespace slosh
