#include "verification/papers/claims.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "verification/series/interval_text.hpp"

namespace slosh {
namespace {

std::string verdict_of(Held held) {
  if (held == Held::yes) return "confirmed";
  return held == Held::no ? "refuted" : "not decidable";
}

Finding found(const Find& find) try {
  return find();
} catch (const std::runtime_error& error) {  // ComparisonError, ResultError and others
  return {Held::undecided, error.what()};
}

}  // namespace

DecidedClaim decide(const Claim& claim) {
  std::vector<std::string> texts, against, unknown;
  for (const Find& find : claim.findings) {
    const Finding one = found(find);
    if (std::find(texts.begin(), texts.end(), one.text) == texts.end()) texts.push_back(one.text);
    if (one.held == Held::yes) continue;
    std::vector<std::string>& list = one.held == Held::no ? against : unknown;
    if (std::find(list.begin(), list.end(), one.text) == list.end()) list.push_back(one.text);
  }
  const bool refuted = !against.empty();
  const bool confirmed = !refuted && unknown.empty() && !texts.empty();
  return {claim.statement,
          refuted     ? Held::no
          : confirmed ? Held::yes
                      : Held::undecided,
          fmt::format("{}", fmt::join(texts, "; ")),
          fmt::format("{}", fmt::join(refuted ? against : unknown, "; "))};
}

Held compare(const Estimate& estimate, const Threshold& threshold) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const auto [relation, lower, upper] = threshold;
  double holds_from = lower, holds_to = upper, refuted_below = lower, refuted_above = upper;
  if (relation == Relation::at_most) holds_from = refuted_below = -infinite;
  if (relation == Relation::at_least) {
    holds_from = upper;
    holds_to = refuted_above = infinite;
    refuted_below = std::nextafter(lower, infinite);  // at the lower end itself it is refuted
  }
  const double low = estimate.value - estimate.half_width;
  const double high = estimate.value + estimate.half_width;
  if (low >= holds_from && high <= holds_to) return Held::yes;
  return high < refuted_below || low > refuted_above ? Held::no : Held::undecided;
}

Held both(Held one, Held other) {
  if (one == Held::no || other == Held::no) return Held::no;
  return one == Held::yes && other == Held::yes ? Held::yes : Held::undecided;
}

Finding within(const Shown& shown, const Estimate& estimate, const Threshold& range) {
  if (range.relation != Relation::within)
    throw std::logic_error(shown.name + " is compared with a range; the row has another relation");
  const auto in_unit = [&](double value) { return fmt::format("{:.3g}", shown.scale * value); };
  const std::string value =
      interval_text({shown.scale * estimate.value, shown.scale * estimate.half_width});
  const std::string unit = shown.unit.empty() ? "" : " " + shown.unit;
  const std::string text =
      fmt::format("{} {}{}{} ({} to {})", shown.name, value.starts_with('-') ? "" : "+", value,
                  unit, in_unit(range.lower), in_unit(range.upper));
  const Held held = compare(estimate, range);
  if (held != Held::undecided) return {held, text};
  const bool is_number = !std::isnan(estimate.value + estimate.half_width);
  return {held, text + (is_number ? ": within its interval" : ": NaN")};
}

reports::Table claims_table(const std::string& id, const std::vector<Claim>& claims,
                            const RedrawnFigures& redrawn) {
  std::vector<PaperRow> rows;
  for (const Claim& claim : claims) {
    const DecidedClaim decided = decide(claim);
    rows.push_back({{fmt::format("({})", rows.size() + 1), decided.statement, claim.source,
                     verdict_of(decided.held), decided.found, decided.why},
                    claim.figures});
  }
  return with_figures(
      {id,
       "Claims of the paper",
       "Each claim in our own words; the range that a number must keep to is in brackets. The "
       "thresholds were set before any run was looked at. A claim cannot be confirmed where a run "
       "is absent or failed, a number is NaN, or an interval reaches over a threshold.",
       {"claim", "in our words", "source", "verdict", "result",
        "evidence against it, or what is missing"},
       {}},
      rows, redrawn);
}

}  // namespace slosh
