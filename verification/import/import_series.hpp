// Reads a time series from a file that another program wrote, in one of the formats of
// file_formats.hpp. A component of a vector is part of the column's name: "probe_0.x",
// "weightedVolIntegrate(U).x". A name may be given with its unit as in the file ("swlz [m]") or
// without it ("swlz").
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

// Throws CaseFileError without a place where the format or a unit is unknown, where the format
// needs a time column that is not named, and where it fixes one that is named.
void require_known_form(const SeriesSource& source);

struct ImportedSeries {
  TimeSeries series;
  std::vector<std::string> seams;  // where a part of it goes on or takes over, one sentence each
};

// The series in its quantity's unit over times in s, from files each of which goes on from the last
// or takes its place from an earlier time on. In a table too a part may follow where its head
// stands again. Throws CaseFileError (file:line: what is wrong, what was expected) where a file
// does not have the format or has no such column, and where a unit is missing or contradicts the
// file's (except a force in N that is declared as one per metre of width, "N/m"). Throws
// ResultError (the same text) where the numbers cannot be used: a number that is not finite or
// stands for "none" (table_rows.hpp), a row of another length or without the end of its line, times
// that do not increase, fewer than four rows.
ImportedSeries import_series(const SeriesSource& source,
                             const std::vector<std::filesystem::path>& files);
// The same from the files of source.file (series_files.hpp).
ImportedSeries import_with_seams(const SeriesSource& source);
TimeSeries import_series(const SeriesSource& source);

}  // namespace slosh
