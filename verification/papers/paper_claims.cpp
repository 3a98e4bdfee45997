#include "verification/papers/paper_claims.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "verification/case/ensemble.hpp"
#include "verification/papers/claim_evidence.hpp"

namespace slosh {
namespace {

using std::string;

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

// Returns the row, and where it asks for it the same row for the finest mesh of its first case.
std::vector<FindingRow> rows_to_evaluate(const FindingRow& row,
                                         const std::vector<CaseAssessment>& cases) {
  std::vector<FindingRow> rows{row};
  const CaseAssessment* assessment = find_case(cases, row.cases.front());
  if (!row.by_finest_mesh_too || !assessment) return rows;
  if (const string mesh = finest_mesh(assessment->definition); !mesh.empty()) {
    rows.push_back(row);
    rows.back().runs = {mesh};
  }
  return rows;
}

void add_findings(const FindingRow& row, const std::vector<CaseAssessment>& cases, Claim& claim) {
  for (const FindingRow& each : rows_to_evaluate(row, cases)) {
    claim.findings.push_back([each, &cases] { return each.evidence(cases, each); });
    for (const string& one : each.cases)
      if (const string runs = fmt::format("{}: {}", one, fmt::join(each.runs, ", "));
          std::find(claim.runs.begin(), claim.runs.end(), runs) == claim.runs.end())
        claim.runs.push_back(runs);
  }
}

// Adds the findings of the claim itself and of those that it rests on.
void add_findings(const ClaimsOfPaper& paper, const PaperClaim& of,
                  const std::vector<CaseAssessment>& cases, Claim& claim) {
  for (const FindingRow& row : of.findings) add_findings(row, cases, claim);
  for (const string& number : of.rests_on)
    for (const PaperClaim& other : paper.claims)
      if (other.number == number) add_findings(paper, other, cases, claim);
}

}  // namespace

const ClaimsOfPaper& claims_named(const string& paper) {
  for (const ClaimsOfPaper* one : {&li2010_claims(), &zhao2021_claims()})
    if (one->paper == paper) return *one;
  throw std::invalid_argument("no paper has the name " + paper);
}

std::vector<Claim> claims_of(const string& paper, const std::vector<CaseAssessment>& cases) {
  const ClaimsOfPaper& of = claims_named(paper);
  std::vector<Claim> claims;
  for (const PaperClaim& one : of.claims) {
    claims.push_back(
        {one.number, one.statement, one.printed, one.figures, {}, {}, one.not_decidable});
    add_findings(of, one, cases, claims.back());
  }
  return claims;
}

reports::Table deviations_table(const string& paper) {
  reports::Table table{paper + "-deviations",
                       "Deviations from the paper as printed",
                       "What the schemes and the cases do in another way than the paper says, and "
                       "what the paper leaves open.",
                       {"of", "the paper", "here", "why"},
                       {}};
  for (const Deviation& one : claims_named(paper).deviations)
    table.rows.push_back({one.of, one.printed, one.here, one.why});
  return table;
}

}  // namespace slosh
