#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "reports/summary/report_sections.hpp"
#include "reports/summary/verdict_matrix.hpp"

namespace slosh {
namespace {

constexpr const char* not_available = "not available";

std::string number_text(double value) {
  if (!std::isfinite(value)) return not_available;
  return value < 100 ? fmt::format("{:.2g}", value) : fmt::format("{:.0f}", value);
}

std::string cell_text(const BasketValue& one, const GateRow& row) {
  if (std::isnan(one.ratio)) return not_available;
  return fmt::format("{}, {} of the goal", with_interval(one.value, row.unit),
                     number_text(one.ratio));
}

// Returns "ramped surge (li2010_small_amplitude_ramp): normalised_rms of elevation@right against
// potential, whole, goal 1 %".
std::string measure_text(const BasketMeasure& measure) {
  const GateRow& row = measure.row;
  return fmt::format("{}{}: {} of {}{}, {}, goal {}", measure.title,
                     measure.title == measure.case_name ? "" : " (" + measure.case_name + ")",
                     metric_name(row.metric), row.quantity,
                     row.reference.empty() ? "" : " against " + row.reference, row.mode,
                     in_unit(*row.limit, row.unit));
}

std::string measures_text(const std::vector<BasketMeasure>& measures) {
  std::string text = "The basket has these measures.";
  for (const BasketMeasure& one : measures) text += " " + measure_text(one) + ".";
  return text;
}

std::vector<std::string> cells_of(const BasketChoice& choice,
                                  const std::vector<BasketMeasure>& measures) {
  std::vector<std::string> cells{choice.name};
  for (std::size_t i = 0; i < measures.size(); ++i)
    cells.push_back(cell_text(choice.values[i], measures[i].row));
  const std::size_t missing = missing_values(choice);
  for (const double ratio : {choice.worst, choice.mean})
    cells.push_back(missing == 0 ? number_text(ratio)
                                 : fmt::format("{}: {} of {} values missing", not_available,
                                               missing, measures.size()));
  cells.push_back(number_text(choice.core_seconds));
  return cells;
}

}  // namespace

reports::Section basket_section(const BasketAssessment& basket) {
  reports::Section section{"basket", "Basket", {measures_text(basket.measures)}, {}, {}};
  if (basket.choices.empty()) {
    section.paragraphs.push_back("No run stands in two or more of the basket's cases.");
    return section;
  }
  reports::Table table{
      "basket",
      "The choices on the basket of cases",
      "Each line is a choice: the runs of that name in the cases of the basket. A cell has the "
      "value that a gate row would judge, with the half width of its 95 % interval where it has "
      "one, and its ratio: |value| / goal. At a ratio of 1 the goal is just met, and below 1 the "
      "value is better than the goal. The worst and the mean ratio are over all measures. The "
      "choices are sorted by the worst ratio; a choice for which a value is missing stands last. "
      "A goal is no gate and decides no verdict.",
      {"choice"},
      {}};
  for (const BasketMeasure& one : basket.measures) table.header.push_back(one.title);
  for (const char* heading : {"worst ratio", "mean ratio", "processor time [core-seconds]"})
    table.header.push_back(heading);
  for (const BasketChoice& choice : basket.choices) {
    table.rows.push_back(cells_of(choice, basket.measures));
    for (std::size_t i = 0; i < choice.values.size(); ++i)
      if (std::isnan(choice.values[i].ratio))
        section.paragraphs.push_back(fmt::format("The value of {} in the column {} is {}: {}.",
                                                 choice.name, basket.measures[i].title,
                                                 not_available, choice.values[i].message));
  }
  section.tables.push_back(std::move(table));
  return section;
}

}  // namespace slosh
