#include "reports/tables/order_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <span>

#include "verification/assessment/observed_order.hpp"

namespace slosh {
namespace {

// The heads of the columns of orders, in the order of a scheme's families.
constexpr const char* order_heads[] = {"order of rms", "order of frequency", "order of decay"};

std::string error_text(const Estimate& error, double scale) {
  if (std::isnan(error.value)) return "";
  const std::string value = fmt::format("{:.3g}", scale * error.value);
  return error.half_width > 0 ? fmt::format("{} ± {:.2g}", value, scale * error.half_width) : value;
}

std::string order_text(const std::optional<double>& order) {
  return order ? fmt::format("{:.2f}", *order) : "";
}

// Of one scheme's families, which have the same spacings.
void add_scheme(std::span<const ErrorFamily> families, reports::Table& table) {
  const std::string& scheme = families.front().name;
  const std::size_t first = table.rows.size();
  for (const ErrorAtSpacing& one : families.front().errors)
    table.rows.push_back({scheme, fmt::format("{:.4g}", 1000 * one.spacing)});
  table.rows.push_back({scheme, "all, least squares"});
  for (const ErrorFamily& family : families) {
    for (std::size_t i = 0; i < family.errors.size(); ++i) {
      auto& row = table.rows[first + i];
      row.push_back(error_text(family.errors[i].error, family.scale));
      row.push_back(i == 0 ? ""
                           : order_text(observed_order(family.errors[i - 1], family.errors[i])));
    }
    table.rows.back().push_back("");
    table.rows.back().push_back(order_text(least_squares_order(family.errors)));
  }
}

}  // namespace

std::optional<reports::Table> order_table(const CaseAssessment& assessment) {
  const std::vector<ErrorFamily> families = scheme_error_families(assessment);
  if (families.empty()) return std::nullopt;
  reports::Table table{
      assessment.definition.name + "-orders",
      "Observed order",
      "Errors against theory or a published record over the particle spacing; the order between a "
      "spacing and the coarser one above it, and the slope through all. An error within its own 95 "
      "% interval has no order.",
      {"scheme", "spacing [mm]"},
      {}};
  constexpr std::size_t measures = std::size(order_heads);
  for (std::size_t i = 0; i < measures; ++i) {
    table.header.push_back(families[i].measure);
    table.header.push_back(order_heads[i]);
  }
  for (std::size_t first = 0; first < families.size(); first += measures)
    add_scheme(std::span(families).subspan(first, measures), table);
  return table;
}

}  // namespace slosh
