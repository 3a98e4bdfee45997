#include "verification/papers/claims.hpp"

#include <fmt/args.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "verification/case/ensemble.hpp"
#include "verification/papers/measured_values.hpp"
#include "verification/series/interval_text.hpp"

namespace slosh {
namespace {

using std::string;
using Texts = std::vector<string>;

// "-2 to 2", "at least 1.25, refuted up to 1".
string text_of(const Threshold& threshold, double scale) {
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

// The interval of a mean over fewer repeats of a wave that breaks is too wide to decide anything.
constexpr std::size_t enough_repeats = 3;

// Returns the finest interFoam run that the case declares, with or without a result, of those with
// enough repeats, or of all where none has enough. Empty where there is none.
string finest_mesh(const CaseDefinition& definition) {
  string finest;
  std::pair<bool, double> highest{false, 0};  // whether it has enough repeats, and its cells
  for (const RunDefinition& run : definition.runs) {
    const InterFoamRun* mesh = std::get_if<InterFoamRun>(&run.solver);
    if (!mesh || mesh->program != FoamProgram::inter_foam || is_later_member(run)) continue;
    const std::pair rank{members_of(definition, run.name).size() >= enough_repeats,
                         number_of_cells(*mesh)};
    if (rank <= highest) continue;
    highest = rank;
    finest = run.name;
  }
  return finest;
}

// Returns the rows of the claim itself and of those that it rests on. A row that asks for it is
// followed by the same one for the finest mesh of its first case.
std::vector<FindingRow> rows_of(const Claim& claim, const Paper& paper,
                                const std::vector<CaseAssessment>& cases) {
  std::vector<FindingRow> rows;
  for (const FindingRow& row : claim.findings) {
    rows.push_back(row);
    const CaseAssessment* first = find_case(cases, row.cases.front());
    if (!row.by_finest_mesh_too || !first) continue;
    if (const string mesh = finest_mesh(first->definition); !mesh.empty()) {
      rows.push_back(row);
      rows.back().runs = {mesh};
    }
  }
  for (const string& number : claim.rests_on)
    for (const Claim& other : paper.claims)
      if (other.number == number)
        std::ranges::move(rows_of(other, paper, cases), std::back_inserter(rows));
  return rows;
}

Finding found(const FindingRow& row, const std::vector<CaseAssessment>& cases) {
  const auto& waves = wave_findings();
  const auto evidence = waves.find(row.evidence);
  const Evidence find =
      evidence != waves.end() ? evidence->second : pressure_findings().at(row.evidence);
  try {
    const CaseAssessment& last = case_named(cases, row.cases.back());
    return find({case_named(cases, row.cases.front()), last, row});
  } catch (const std::runtime_error& error) {  // ComparisonError, ResultError and others
    return {Held::undecided, error.what(), true};
  }
}

void add_once(Texts& list, const string& text) {
  if (std::find(list.begin(), list.end(), text) == list.end()) list.push_back(text);
}

}  // namespace

string verdict_of(Held held) {
  if (held == Held::yes) return "confirmed";
  return held == Held::no ? "refuted" : "not decidable";
}

const RunResult& Question::result(std::size_t i) const { return standing_result(first, run(i)); }

Finding Question::judge(const string& name, double scale, const string& unit,
                        const Estimate& estimate) const {
  fmt::dynamic_format_arg_store<fmt::format_context> runs;
  for (const string& one : row.runs) runs.push_back(one);
  return judged({fmt::vformat(name, runs), scale, unit}, estimate, threshold());
}

DecidedClaim decided(const Claim& claim, const std::vector<Finding>& findings) {
  Texts texts, against, unknown;
  for (const Finding& one : findings) {
    if (!one.is_missing) add_once(texts, one.text);
    if (one.held != Held::yes) add_once(one.held == Held::no ? against : unknown, one.text);
  }
  const bool refuted = !against.empty(), confirmed = unknown.empty() && !texts.empty();
  return {claim,
          {},
          refuted     ? Held::no
          : confirmed ? Held::yes
                      : Held::undecided,
          fmt::format("{}", fmt::join(texts, "; ")),
          claim.not_decidable.empty()
              ? fmt::format("{}", fmt::join(refuted ? against : unknown, "; "))
              : claim.not_decidable};
}

std::vector<DecidedClaim> decided_claims(const Paper& paper,
                                         const std::vector<CaseAssessment>& cases) {
  std::vector<DecidedClaim> all;
  for (const Claim& claim : paper.claims) {
    std::vector<Finding> findings;
    Texts runs;
    for (const FindingRow& row : rows_of(claim, paper, cases)) {
      findings.push_back(found(row, cases));
      for (const string& one : row.cases)
        add_once(runs, fmt::format("{}: {}", one, fmt::join(row.runs, ", ")));
    }
    all.push_back(decided(claim, findings));
    all.back().runs = runs;
  }
  return all;
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
  const string value =
      interval_text({shown.scale * estimate.value, shown.scale * estimate.half_width});
  const bool has_sign = threshold.relation == Relation::within && threshold.lower <= 0;
  const Held held = compare(estimate, threshold);
  string text = fmt::format(
      "{} {}{}{} ({})", shown.name, has_sign && !value.starts_with('-') ? "+" : "", value,
      shown.unit.empty() ? "" : " " + shown.unit, text_of(threshold, shown.scale));
  if (held == Held::undecided && std::isnan(estimate.value + estimate.half_width)) text += ": NaN";
  if (held == Held::undecided && estimate.half_width > 0) text += ": within its interval";
  return {held, text};
}

}  // namespace slosh
