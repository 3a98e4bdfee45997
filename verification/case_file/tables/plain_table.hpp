// The series of a plain table: a line with names, then rows. Nothing else says what is in it.
#pragma once

#include <filesystem>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

// Takes each column that is named as a quantity of the case ("elevation@right", "elevation@right
// [mm]"). A table with one column beside the times, of any name, has the case's first quantity. The
// times stand in the column t or time. What has no unit is in SI units. Throws CaseFileError
// (file:line) where there are no times or no such column.
std::vector<SeriesSource> series_of_table(const std::filesystem::path& file,
                                          const CaseDefinition& definition);

}  // namespace slosh
