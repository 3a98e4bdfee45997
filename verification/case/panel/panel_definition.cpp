#include "verification/case/panel/panel_definition.hpp"

namespace slosh {

const std::vector<PanelMetricEntry>& panel_metric_table() {
  static const std::vector<PanelMetricEntry> table{
      {PanelMetric::impact_peak, "impact_peak", "Pa", "peak", true, true, true},
      {PanelMetric::impact_arrival, "impact_arrival", "s", "arrival", true, true, false},
      {PanelMetric::impulse, "impulse", "Pa s", "impulse", true, true, true},
      {PanelMetric::plateau, "plateau", "Pa", "plateau", false, true, true},
      {PanelMetric::rms, "rms", "", "rms about the mean", false, false, true},
      {PanelMetric::lag, "lag", "s", "lag behind the mean of the solvers", false, false, false}};
  return table;
}

const PanelMetricEntry& panel_metric_entry(PanelMetric metric) {
  return panel_metric_table().at(static_cast<std::size_t>(metric));
}

std::vector<std::string> panel_metric_names() {
  std::vector<std::string> names;
  for (const PanelMetricEntry& entry : panel_metric_table()) names.push_back(entry.name);
  return names;
}

std::string panel_unit(PanelMetric metric, const std::string& quantity_unit) {
  const std::string unit = panel_metric_entry(metric).unit;
  return unit.empty() ? quantity_unit : unit;
}

}  // namespace slosh
