#include <nlohmann/json.hpp>

#include "reports/summary/results_json.hpp"
#include "verification/assessment/across_runs/panels.hpp"

namespace slosh {
namespace {

using Json = nlohmann::ordered_json;

Json apart_entry(const SolverApart& apart) {
  return {{"difference", estimate_json(apart.difference)},
          {"p", apart.p},
          {"corrected_p", apart.corrected_p},
          {"others_agree_p", apart.others_agree_p},
          {"further_solver_p", apart.further_solver_p}};
}

Json solver_entry(const PanelSolver& solver) {
  return {{"run", solver.run},
          {"members", solver.values.size()},
          {"without_value", solver.without_value},
          {"left_out", solver.left_out},
          {"mean", solver.mean ? estimate_json(solver.mean->estimate()) : Json(nullptr)},
          {"standard_deviation", solver.mean ? Json(solver.mean->deviation) : Json(nullptr)},
          {"apart", nullptr}};
}

Json row_entry(const PanelRow& row) {
  Json solvers = Json::array();
  for (const PanelSolver& solver : row.solvers) solvers.push_back(solver_entry(solver));
  if (row.verdict)
    for (std::size_t j = 0; j < row.verdict->each.size(); ++j)
      solvers[row.judged[j]]["apart"] = apart_entry(row.verdict->each[j]);
  return {{"mode", row.mode},
          {"metric", panel_metric_entry(row.metric).name},
          {"unit", row.unit},
          {"finding", panel_finding(row)},
          {"agree_p", row.verdict ? Json(row.verdict->agree_p) : Json(nullptr)},
          {"odd", row.odd() ? Json(row.odd()->run) : Json(nullptr)},
          {"air_share", row.air_share ? estimate_json(*row.air_share) : Json(nullptr)},
          {"solvers", solvers}};
}

}  // namespace

Json panels_json(const CaseAssessment& assessment) {
  Json panels = Json::array();
  for (const PanelAssessment& panel : panels_of(assessment)) {
    Json rows = Json::array();
    for (const PanelRow& row : panel.rows) rows.push_back(row_entry(row));
    const auto& air = panel.definition.air;
    panels.push_back(
        {{"name", panel.definition.name},
         {"quantity", panel.definition.quantity},
         {"reason", panel.definition.reason},
         {"compressibility", air ? Json{air->compressible, air->incompressible} : Json(nullptr)},
         {"rows", rows}});
  }
  return panels;
}

}  // namespace slosh
