// Reads a time series from a file that another program wrote, in one of the formats of
// file_formats.hpp. A component of a vector is part of the column's name: "probe_0.x",
// "weightedVolIntegrate(U).x". A name may be given with its unit as in the file ("swlz [m]") or
// without it ("swlz").
#pragma once

#include "verification/case/case_definition.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

// Throws CaseFileError without a place where the format or a unit is unknown, where the format
// needs a time column that is not named, and where it fixes one that is named.
void require_known_form(const SeriesSource& source);

// The series in its quantity's unit over times in s. Throws CaseFileError (file:line: what is
// wrong, what was expected) where the file does not have the format or has no such column, and
// where a unit is missing or contradicts the file's (except a force in N that is declared as one
// per metre of width, "N/m"). Throws ResultError (the same text) where the numbers cannot be used:
// a number that is not finite or stands for "none" (beyond 1e30), a row of another length or
// without the end of its line, times that do not increase (as after a restart), fewer than four
// rows.
TimeSeries import_series(const SeriesSource& source);

}  // namespace slosh
