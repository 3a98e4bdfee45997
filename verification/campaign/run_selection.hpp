// Which runs of a campaign are wanted: all, those of the quick form, those that the user names by
// patterns and tags. A run that a selected gate row is judged by is selected too, so that the row's
// verdict is that of the whole campaign: the reference, the run that the row improves on, and those
// its uncertainty comes from (refinements, repeats, records), or the family whose cost it bounds.
// Patterns are those of fnmatch(3), a
// '*' ending at a '/': "CASE" matches whole cases and problems, "CASE/RUN" single runs.
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

// Whether the patterns and tags name it.
bool names_run(const RunSelection& selection, const CaseDefinition& definition,
               const RunDefinition& run);
bool names_problem(const RunSelection& selection, const std::string& problem);

// Whether it is to be run and judged: named, or needed by the gate rows of what is named; of a
// quick form marked as quick besides.
bool is_selected(const RunSelection& selection, const CaseDefinition& definition,
                 const RunDefinition& run);

// What patterns and tags are sought in.
struct Selectable {
  const std::vector<CaseDefinition>& cases;
  std::vector<std::string> others;  // names that a pattern without '/' may match: problems, ...
};

// Throws CaseFileError with the nearest names for a pattern or a tag that matches nothing.
void require_matches(const RunSelection& selection, const Selectable& among);

// "only a/b, c; tagged surge", empty of a selection that is not partial.
std::string selection_text(const RunSelection& selection);
// " --only 'a/b' --tag 'surge'": the options that select the same, quick's included.
std::string selection_options(const RunSelection& selection);

}  // namespace slosh
