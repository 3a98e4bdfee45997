// The formats of other programs' files, one row each. A new format needs a row in file_formats.cpp
// and a reader in the file that knows the format.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/input/tables/table_head.hpp"

namespace slosh {

// A series as it stands in a file, with its units; a unit is empty where the file does not give it.
struct RawSeries {
  std::vector<double> time, value;
  std::string time_unit, unit;
};

// Whether the user names the column of times.
enum class TimeColumn { known_by_format, must_be_named, may_be_named };

struct FileFormat {
  std::string name;     // as in `--format` and in case files
  std::string files;    // which files have the format; shown by `import --help`
  std::string columns;  // how their columns are named; shown there too
  std::string example;  // a column that such a file has; empty where any name may stand
  TimeColumn time_column = TimeColumn::known_by_format;
  // Exactly one of these two is set. `read_head` reads the head of a text table: it gets a reader
  // on the file's first line and leaves it on the first row, or on the empty line after the end
  // where there is no row. `read_series` reads any other kind of file. Both throw CaseFileError
  // where the file does not have the format, read_series also where it has no such column.
  TableHead (*read_head)(TableReader& reader, const SeriesSource& source) = nullptr;
  RawSeries (*read_series)(const SeriesSource& source) = nullptr;
};

const std::vector<FileFormat>& file_formats();
std::vector<std::string> format_names();

}  // namespace slosh
