// How the head of a text table tells of its columns: what each format's reader of heads gives.
// Private to verification/import/.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/input/table_reader.hpp"

namespace slosh {

struct ForeignColumn {
  std::string name, unit;  // the unit empty where the file does not say it
};

struct TableHead {
  std::vector<ForeignColumn> columns;
  int line = 1;          // that names them
  std::size_t time = 0;  // which of them
  char separator = ' ';  // ' ': any run of blanks, tabs and parentheses
};

// Each gets a reader on the file's first line and leaves it on the first row, or on the empty
// line after the end where there is none. They throw CaseFileError where the file is not of their
// format.
TableHead read_csv_head(TableReader& reader, const SeriesSource& source);
TableHead read_dualsphysics_gauge_head(TableReader& reader);
TableHead read_dualsphysics_points_head(TableReader& reader);
TableHead read_openfoam_probes_head(TableReader& reader);
TableHead read_openfoam_interface_height_head(TableReader& reader);
TableHead read_openfoam_table_head(TableReader& reader);
TableHead read_sphinxsys_head(TableReader& reader);

// A row's fields without the blanks and quotes around them; an empty last one, as a separator at
// the row's end leaves it, is none.
std::vector<std::string_view> fields_of(std::string_view line, char separator);

// "swlz [m]": a name and its unit; a text without brackets at its end is a name alone.
ForeignColumn column_of(std::string_view text);

// The columns of a line of such texts.
std::vector<ForeignColumn> columns_of(std::string_view line, char separator);

// Which of the columns has this name, with or without its unit. Throws CaseFileError, naming the
// nearest, where none has or more than one.
std::size_t column_place(const TableReader& reader, const TableHead& head, const std::string& key,
                         const std::string& name);

}  // namespace slosh
