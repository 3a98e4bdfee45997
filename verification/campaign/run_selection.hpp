// The selection of a campaign's runs: all, those of the quick form, or those that the user names by
// patterns and tags. The runs that a selected gate row needs are selected too, so that its verdict
// is that of the whole campaign: the reference, the run that the row improves on, the runs from
// which its uncertainty comes (refinements, repeats, records, and theory and coarse runs for its
// inputs), and the family whose cost it bounds.
// Patterns are those of fnmatch(3), in which a '*' ends at a '/': "CASE" matches whole cases and
// problems, "CASE/RUN" single runs.
#pragma once

#include <string>
#include <vector>

#include "verification/case/campaign_definition.hpp"
#include "verification/case/case_definition.hpp"

namespace slosh {

struct RunSelection {
  bool quick = false;               // only the runs marked so; they alone decide a quick verdict
  std::vector<std::string> only{};  // patterns, one of which must match; none: everything does
  std::vector<std::string> tags{};  // one of which the case must have; none: every case does

  bool is_partial() const { return !only.empty() || !tags.empty(); }
};

// Returns whether the patterns and tags name the run or the problem.
bool names_run(const RunSelection& selection, const CaseDefinition& definition,
               const RunDefinition& run);
bool names_problem(const RunSelection& selection, const std::string& problem);

// Returns whether the run is to be executed and judged: it is named, or the gate rows of a named
// run need it. In the quick form it must also be marked as quick. A repeat at the bound of an input
// is of use to such gate rows alone.
bool is_selected(const RunSelection& selection, const CaseDefinition& definition,
                 const RunDefinition& run);

// The names in which patterns and tags are looked up.
struct Selectable {
  const std::vector<CaseDefinition>& cases;
  std::vector<std::string> others;  // names that a pattern without '/' may match: problems, ...
};

// Throws CaseFileError with the nearest names for a pattern or a tag that matches nothing.
void require_matches(const RunSelection& selection, const Selectable& among);

// Returns "only a/b, c; tagged surge"; empty for a selection that is not partial.
std::string selection_text(const RunSelection& selection);
// Returns " --only 'a/b' --tag 'surge'", the command-line options of the selection, --quick
// included.
std::string selection_options(const RunSelection& selection);

}  // namespace slosh
