#include "verification/assessment/doubts/model_limit.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace slosh {
namespace {

std::string in_percent(double share) {
  const double percent = 100 * share;
  return percent < 99.5 ? fmt::format("{:.2g} %", percent) : fmt::format("{:.0f} %", percent);
}

}  // namespace

std::string limit_text(const ModelLimit& limit) {
  return fmt::format("{}: {} {}, limit {} ({})", limit.effect, in_percent(limit.value), limit.what,
                     in_percent(limit.limit), limit.source);
}

std::vector<std::string> runs_with(const CaseDefinition& definition,
                                   const std::function<bool(const RunDefinition&)>& test) {
  std::vector<std::string> names;
  for (const RunDefinition& run : definition.runs)
    if (test(run)) names.push_back(run.name);
  return names;
}

std::string few_of(const std::vector<std::string>& runs) {
  constexpr std::size_t told = 3;
  const std::vector<std::string> first(
      runs.begin(), runs.begin() + static_cast<std::ptrdiff_t>(std::min(told, runs.size())));
  return fmt::format("{}{}", fmt::join(first, ", "),
                     runs.size() > told ? fmt::format(" and {} more", runs.size() - told) : "");
}

}  // namespace slosh
