#include "verification/papers/claims.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace slosh {
namespace {

std::string verdict_of(Held held) {
  if (held == Held::yes) return "confirmed";
  return held == Held::no ? "refuted" : "not decidable";
}

Finding found(const Find& find) try {
  return find();
} catch (const std::runtime_error& error) {  // what is missing, ComparisonError, ResultError
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

Finding within(const Shown& shown, const Estimate& estimate, double lower, double upper) {
  const double low = estimate.value - estimate.half_width,
               high = estimate.value + estimate.half_width;
  const auto in_unit = [&](double value) { return fmt::format("{:.3g}", shown.scale * value); };
  const std::string interval =
      estimate.half_width > 0 ? " ± " + fmt::format("{:.2g}", shown.scale * estimate.half_width)
                              : "";
  const std::string unit = shown.unit.empty() ? "" : " " + shown.unit;
  const std::string text =
      fmt::format("{} {:+.3g}{}{} ({} to {})", shown.name, shown.scale * estimate.value, interval,
                  unit, in_unit(lower), in_unit(upper));
  if (low >= lower && high <= upper) return {Held::yes, text};
  if (low > upper || high < lower) return {Held::no, text};
  return {Held::undecided,
          text + (std::isnan(low + high) ? ": no number" : ": within its interval")};
}

Held at_least(double value, double refuted, double confirmed) {
  if (value >= confirmed) return Held::yes;
  return value <= refuted ? Held::no : Held::undecided;
}

reports::Table claims_table(const std::string& id, const std::vector<Claim>& claims) {
  reports::Table table{
      id,
      "Claims of the paper",
      "Each claim in our own words, as restated here; in brackets what a number must keep to. The "
      "thresholds were set before any run was looked at. A run that is absent or failed, a number "
      "that is none and an interval that reaches over a threshold confirm nothing.",
      {"claim", "as restated here", "verdict", "found", "what speaks against it or is missing"},
      {}};
  for (const Claim& claim : claims) {
    const DecidedClaim decided = decide(claim);
    table.rows.push_back({fmt::format("({})", table.rows.size() + 1), decided.statement,
                          verdict_of(decided.held), decided.found, decided.why});
  }
  return table;
}

}  // namespace slosh
