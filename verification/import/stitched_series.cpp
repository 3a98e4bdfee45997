#include "verification/import/stitched_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verification/input/tables/table_head.hpp"

namespace slosh {
namespace {

constexpr double rounding = 1e-5;  // of coordinates, which OpenFOAM writes with six digits

bool is_same_place(const std::string& one, const std::string& other) {
  if (one == other) return true;
  const auto a = fields_of(one, ' '), b = fields_of(other, ' ');
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](auto first, auto second) {
    const auto x = number_in(first), y = number_in(second);
    return x && y && std::abs(*x - *y) <= rounding * std::max(std::abs(*x), std::abs(*y));
  });
}

}  // namespace

void StitchedSeries::append(const SeriesPart& part) {
  if (part.time.empty()) return;
  const double begin = part.time.front();
  if (!time.empty()) {
    if (begin < time.front())
      throw CaseFileError(fmt::format(
          "{}: time = {}: expected a part that begins at {} or later, in s, as the one before it",
          part.place, begin, time.front()));
    if (!is_same_place(part.at, at_))
      throw CaseFileError(fmt::format("{}: place of the gauge = {}: expected {}, as in {}",
                                      part.place, part.at, at_, first_place_));
    const auto kept = std::lower_bound(time.begin(), time.end(), begin) - time.begin();
    const std::size_t replaced = time.size() - static_cast<std::size_t>(kept);
    seams.push_back(
        replaced == 0
            ? fmt::format("{}: goes on at {:.6g} s after {:.6g} s", part.place, begin, time.back())
            : fmt::format("{}: takes over at {:.6g} s; the {} values up to {:.6g} s before it are "
                          "left out",
                          part.place, begin, replaced, time.back()));
    time.erase(time.begin() + kept, time.end());
    value.erase(value.begin() + kept, value.end());
  } else {
    first_place_ = part.place;
    at_ = part.at;
  }
  time.insert(time.end(), part.time.begin(), part.time.end());
  value.insert(value.end(), part.value.begin(), part.value.end());
}

}  // namespace slosh
