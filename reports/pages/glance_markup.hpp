// The list of a report's pages with their verdicts, and for each the small figure of its main
// result: the report at a glance, as data of the HTML templates.
#pragma once

#include <kainjow/mustache.hpp>

#include "reports/model/report_model.hpp"
#include "reports/pages/report_documents.hpp"

namespace slosh::reports {

// The entry of a page, in the list of pages and in the links of its neighbours. `glance` may be
// null.
kainjow::mustache::data entry_data(const Page& page, const DrawnFigure* glance = nullptr);

// All entries with their figures, and the one legend of these figures.
kainjow::mustache::data glances_data(const Report& report, const Drawings& drawings);

// A verdict as a class, a sign, a word and a sentence.
kainjow::mustache::data outcome_data(Outcome outcome, const std::string& sentence);

}  // namespace slosh::reports
