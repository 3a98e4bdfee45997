#include "verification/texts/impact_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "verification/case/quantities.hpp"
#include "verification/gate/impact_metrics.hpp"

namespace slosh {
namespace {

std::string numbers_text(const ImpactNumbers& impact) {
  std::string text = impact.peak ? fmt::format("peak {:.4g} Pa at {:.4f} s", impact.peak->pressure,
                                               impact.peak->time)
                                 : std::string("no impact");
  const auto add = [&](const char* what, const std::optional<double>& value, const char* unit) {
    if (value) text += fmt::format(", {} {:.4g} {}", what, *value, unit);
  };
  add("rise time", impact.rise_time, "s");
  if (impact.arrival) text += fmt::format(", arrival {:.4f} s", *impact.arrival);
  add("impulse", impact.impulse, "Pa s");
  return text;
}

std::vector<ImpactNumbers> published_numbers(const ImpactsDefinition& impacts) {
  std::vector<ImpactNumbers> all;
  for (std::size_t n = 0; n < impacts.times.size(); ++n) {
    ImpactNumbers one{.peak = ImpactPeak{impacts.times[n], impacts.peak_means[n]}};
    if (impacts.rise_times) one.rise_time = impacts.rise_times->values[n];
    if (impacts.arrivals) one.arrival = impacts.arrivals->times[n];
    if (impacts.impulses) one.impulse = impacts.impulses->values[n];
    all.push_back(one);
  }
  return all;
}

// Empty where the series cannot be searched; `lines` then says why.
std::vector<ImpactNumbers> found_numbers(const CaseDefinition& definition, const char* role,
                                         const TimeSeries& series, std::string& lines) try {
  return impact_numbers(series, definition);
} catch (const ComparisonError& error) {
  lines += fmt::format("impacts of {}: {}\n", role, error.what());
  return {};
}

// A series that does not cover the plateau has a line that says why.
std::string plateau_line(const CaseDefinition& definition, const char* role,
                         const TimeSeries& series) try {
  const double error = plateau_error(series, definition);
  return fmt::format("plateau of {}: {:.4g} Pa, {:+.3g} %\n", role,
                     (1 + error) * definition.impacts->plateau, 100 * error);
} catch (const ComparisonError& error) {
  return fmt::format("plateau of {}: {}\n", role, error.what());
}

std::string plateau_lines(const CaseDefinition& definition, const TimeSeries& candidate,
                          const TimeSeries& reference) {
  if (!(definition.impacts->plateau > 0)) return "";
  return plateau_line(definition, "the candidate", candidate) +
         plateau_line(definition, "the reference", reference) +
         fmt::format("plateau as published: {:.4g} Pa\n", definition.impacts->plateau);
}

}  // namespace

bool has_impacts(const CaseDefinition& definition, const std::string& quantity) {
  if (!definition.impacts) return false;
  const std::vector<std::string> pressures = impact_pressures(definition);
  return std::find(pressures.begin(), pressures.end(), quantity) != pressures.end();
}

std::string impact_lines(const CaseDefinition& definition, const TimeSeries& candidate,
                         const TimeSeries& reference) {
  std::string lines;
  const auto of_candidate = found_numbers(definition, "the candidate", candidate, lines);
  const auto of_reference = found_numbers(definition, "the reference", reference, lines);
  const auto published = published_numbers(*definition.impacts);
  const auto add = [&](std::size_t n, const char* whose, const std::vector<ImpactNumbers>& all) {
    if (n < all.size())
      lines += fmt::format("impact_{} {}: {}\n", n + 1, whose, numbers_text(all[n]));
  };
  for (std::size_t n = 0; n < published.size(); ++n) {
    add(n, "of the candidate", of_candidate);
    add(n, "of the reference", of_reference);
    add(n, "as published", published);
  }
  return lines + plateau_lines(definition, candidate, reference);
}

}  // namespace slosh
