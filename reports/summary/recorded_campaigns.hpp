// What the reports of several campaigns come to together, read from the results.json of each: one
// page with their verdicts, and bias and scatter of each model over all their comparisons, as the
// FDS Validation Guide sums up a whole set.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/predictions.hpp"

namespace slosh {

struct RecordedCampaign {
  std::string name;
  bool is_quick;
  int exit_status;
  std::size_t rows, passed;  // gate rows that were judged, and those of them that hold
  std::string place;         // of its report
  std::vector<PredictionSet> predictions;
};

// `text` is that of a results.json. Throws std::invalid_argument, with what is wrong, for any
// other.
RecordedCampaign recorded_campaign(const std::string& text, const std::string& place);

// Whether the exit status is that of a worse verdict: a solver failed, violated, not compared,
// inconclusive, pass.
bool is_worse_status(int status, int other);

// The report in place of that of a start that has come to no verdict, or of one that a later start
// contradicts.
reports::Report superseded_report(const std::string& campaign, int status, const std::string& why);

// A comparison that several campaigns make counts once, that of a whole campaign before that of a
// quick form. `left_out` tells of the reports that could not be read.
std::vector<PredictionSet> merged_predictions(const std::vector<RecordedCampaign>& campaigns);
reports::Report report_of_campaigns(const std::vector<RecordedCampaign>& campaigns,
                                    const std::vector<std::string>& left_out);

// The worst exit status of them. A report that could not be read counts as not compared.
int exit_status(const std::vector<RecordedCampaign>& campaigns,
                const std::vector<std::string>& left_out);

}  // namespace slosh
