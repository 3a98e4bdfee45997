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

// "-2 to 2", "at least 1.25, refuted up to 1".
std::string text_of(const Threshold& threshold, double scale) {
  const double lower = scale * threshold.lower, upper = scale * threshold.upper;
  switch (threshold.relation) {
    case Relation::at_least:
      return lower < upper ? fmt::format("at least {:.3g}, refuted up to {:.3g}", upper, lower)
                           : fmt::format("at least {:.3g}", upper);
    case Relation::at_most:
      return fmt::format("at most {:.3g}", upper);
    case Relation::within_factor:
      return fmt::format("1 within a factor of {:.3g}", threshold.upper);
    case Relation::within:
      break;
  }
  return fmt::format("{:.3g} to {:.3g}", lower, upper);
}

}  // namespace

std::string verdict_of(Held held) {
  if (held == Held::yes) return "confirmed";
  return held == Held::no ? "refuted" : "not decidable";
}

DecidedClaim decide(const Claim& claim) {
  std::vector<std::string> texts, against, unknown;
  const auto add = [](std::vector<std::string>& list, const std::string& text) {
    if (std::find(list.begin(), list.end(), text) == list.end()) list.push_back(text);
  };
  for (const Find& find : claim.findings) try {
      const Finding one = find();
      add(texts, one.text);
      if (one.held != Held::yes) add(one.held == Held::no ? against : unknown, one.text);
    } catch (const std::runtime_error& error) {  // ComparisonError, ResultError and others
      add(unknown, error.what());
    }
  const bool refuted = !against.empty();
  const bool confirmed = !refuted && unknown.empty() && !texts.empty();
  return {claim,
          refuted     ? Held::no
          : confirmed ? Held::yes
                      : Held::undecided,
          fmt::format("{}", fmt::join(texts, "; ")),
          claim.not_decidable.empty()
              ? fmt::format("{}", fmt::join(refuted ? against : unknown, "; "))
              : claim.not_decidable};
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

Finding judged(const Shown& shown, const Estimate& estimate, const Threshold& threshold) {
  const std::string value =
      interval_text({shown.scale * estimate.value, shown.scale * estimate.half_width});
  const bool has_sign = threshold.relation == Relation::within && threshold.lower <= 0;
  const Held held = compare(estimate, threshold);
  std::string text = fmt::format(
      "{} {}{}{} ({})", shown.name, has_sign && !value.starts_with('-') ? "+" : "", value,
      shown.unit.empty() ? "" : " " + shown.unit, text_of(threshold, shown.scale));
  if (held == Held::undecided && std::isnan(estimate.value + estimate.half_width)) text += ": NaN";
  if (held == Held::undecided && estimate.half_width > 0) text += ": within its interval";
  return {held, text};
}

reports::Table claims_table(const std::string& id, const std::vector<Claim>& claims,
                            const RedrawnFigures& redrawn) {
  std::vector<PaperRow> rows;
  for (const Claim& claim : claims) {
    const DecidedClaim decided = decide(claim);
    rows.push_back({{claim.number, claim.statement, claim.printed, verdict_of(decided.held),
                     decided.found, decided.why == decided.found ? "" : decided.why,
                     fmt::format("{}", fmt::join(claim.runs, "; "))},
                    claim.figures});
  }
  return with_figures(
      {id,
       "Claims of the paper",
       "Each claim under the paper's number, in our own words; what a number is held against is in "
       "brackets. The thresholds were set before the numbers were looked at, but for those that "
       "the text above names. A claim cannot be confirmed where a run is absent or failed, a "
       "number is NaN, or an interval reaches over a threshold.",
       {"claim", "in our words", "printed", "verdict", "result",
        "evidence against it, or what is missing", "decided by"},
       {}},
      rows, redrawn);
}

}  // namespace slosh
