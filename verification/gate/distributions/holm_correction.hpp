// p-values that are judged together. Of m true hypotheses one has p < 5 % by chance in up to 5 m %
// of all cases; of twelve tests of a perfect model, three of each of four impacts, in 19 to 46 %.
// Holm's step-down correction (Holm 1979, Scand. J. Stat. 6:65) holds the chance that any of the
// true ones is rejected at 5 %, however they depend on one another: with p_(1) <= ... <= p_(m)
//   corrected p_(i) = max over j <= i of min(1, (m - j + 1) p_(j))
#pragma once

#include <cstddef>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

// The corrected p-value of the i-th of a family, with the half width of that p_(j) to which it is
// equal, multiplied alike. A p-value of NaN, of an impact that does not occur, counts as 0.
Estimate holm_corrected(const std::vector<Estimate>& family, std::size_t i);

// The other rows of the family of a row on a p-value: all of `rows` on a p-value of the same
// candidate and the same pressure, which one model must hold together.
std::vector<GateRow> rest_of_family(const GateRow& row, const std::vector<GateRow>& rows);

}  // namespace slosh
