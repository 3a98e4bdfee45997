#include "verification/case/field_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace slosh {

std::vector<double> field_times(const CaseDefinition& definition) {
  std::vector<double> times = definition.snapshot_times;
  times.insert(times.end(), definition.animation_times.begin(), definition.animation_times.end());
  std::sort(times.begin(), times.end());
  // Both are multiples of the sample interval, but for round-off.
  const auto same = [&](double a, double b) {
    return std::abs(a - b) < 0.5 * definition.sample_interval;
  };
  times.erase(std::unique(times.begin(), times.end(), same), times.end());
  return times;
}

std::vector<std::string> moment_names(const CaseDefinition& definition) {
  std::vector<std::string> names;
  for (std::size_t n = 1; n <= definition.snapshot_times.size(); ++n)
    names.push_back(fmt::format("moment_{}", n));
  return names;
}

}  // namespace slosh
