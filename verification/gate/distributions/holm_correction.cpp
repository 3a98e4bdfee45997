#include "verification/gate/distributions/holm_correction.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "verification/case/metric_table.hpp"

namespace slosh {

Estimate holm_corrected(const std::vector<Estimate>& family, std::size_t i) {
  const auto p = [&](std::size_t k) {
    return std::isnan(family[k].value) ? Estimate{0, 0} : family[k];
  };
  std::vector<std::size_t> order(family.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return p(a).value < p(b).value; });
  Estimate corrected{0, 0};
  for (std::size_t j = 0; j < order.size(); ++j) {
    const double factor = static_cast<double>(order.size() - j);
    const Estimate here = p(order[j]);
    if (factor * here.value >= corrected.value)
      corrected = {factor * here.value, factor * here.half_width};
    if (order[j] == i) break;
  }
  return {std::min(1.0, corrected.value), corrected.half_width};
}

std::vector<GateRow> rest_of_family(const GateRow& row, const std::vector<GateRow>& rows) {
  std::vector<GateRow> rest;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(rest), [&](const GateRow& other) {
    const bool is_itself = other.metric == row.metric && other.mode == row.mode;
    return is_p_value(other.metric) && other.candidate == row.candidate &&
           other.quantity == row.quantity && !is_itself;
  });
  return rest;
}

}  // namespace slosh
