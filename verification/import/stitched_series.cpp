#include "verification/import/stitched_series.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "verification/input/case_file_error.hpp"

namespace slosh {

void StitchedSeries::append(const SeriesPart& part) {
  if (part.time.empty()) return;
  const double begin = part.time.front();
  if (!time.empty()) {
    if (begin < time.front())
      throw CaseFileError(fmt::format(
          "{}: time = {}: expected a part that begins at {} or later, in s, as the one before it",
          part.place, begin, time.front()));
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
  }
  time.insert(time.end(), part.time.begin(), part.time.end());
  value.insert(value.end(), part.value.begin(), part.value.end());
}

}  // namespace slosh
