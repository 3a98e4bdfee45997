// A case in words, for reports and explanations, and the places of its results in a report.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "verification/case/case_definition.hpp"

namespace slosh {

// Returns "surge X = 0.02 m sin(1.48346 rad/s t)" or "at rest".
std::string motion_text(const CaseDefinition& definition);

// The largest magnitude of a motion over the case's time [SI], with its sign.
struct MotionPeak {
  double time, value;
};

MotionPeak peak_of(const CaseDefinition& definition, const std::function<double(double)>& motion);

// Returns "; at most 0.02 m, 0.03 m/s and 0.044 m/s2" for a surge, the same in degrees for a roll,
// and by how much the curve through a table goes beyond it; "" for a tank at rest.
std::string motion_peaks(const CaseDefinition& definition);

// Returns "1 m long, 0.8 m high", "a polygon of 5 corners, 1 m long, 0.8 m high" or "a lying
// cylinder of 1 m diameter, as a polygon of 128 corners".
std::string tank_text(const TankDefinition& tank);

// Returns "0.35 m deep", the initial state where it is not at rest, and the obstacles.
std::string liquid_text(const CaseDefinition& definition);

// Returns "SPH at 5 mm", "SPH li2010 at 10 mm", "interFoam at 50 x 100 cells", "linear theory",
// "potential flow", "the record peaks": a run as a headline names it.
std::string short_text(const RunDefinition& run);

// Returns "Peers reach 1 %. Source: Li et al. 2010.", the reason for a gate row's limit.
std::string limit_reason(const std::string& reason, const std::string& source);

// The pages of a campaign's report, and the anchors of its gate rows.

inline constexpr const char* problems_page = "problems";
inline constexpr const char* across_page = "across";  // results of several cases together

// The id of a name of letters, digits, _ and -, as a part of longer ids, whose parts a single -
// joins: a - in the name is doubled, so that the parts tell apart what "wave-appendix" names.
std::string name_id(const std::string& name);

// The id of a case's page, with which those of its sections, tables and figures begin: its
// name_id(), or "case-NAME" for a name that something else in the report has.
std::string case_id(const std::string& case_name);

// Returns the page of a case's further figures and tables.
std::string appendix_of_case(const std::string& case_name);

// Returns the id of a gate row, counted from 0 in the order of the case or campaign file.
std::string case_row_id(const std::string& case_name, std::size_t row);
std::string problem_row_id(const std::string& problem_name, std::size_t row);

}  // namespace slosh
