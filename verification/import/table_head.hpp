// The head of a text table: its columns and how its rows are separated. Private to
// verification/import/.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/input/table_reader.hpp"

namespace slosh {

struct ForeignColumn {
  std::string name, unit;  // the unit is empty where the file does not give it
};

// A program may write a mark in place of a value that it could not find: the value of another
// column.
struct MarkOfNone {
  std::size_t column, mark;  // indices of the value's column and of the mark's
  std::string expected;
};

struct TableHead {
  std::vector<ForeignColumn> columns;
  int line = 1;          // the line with the names
  std::size_t time = 0;  // index of the column of times
  char separator = ' ';  // ' ': any run of blanks, tabs and parentheses
  std::vector<MarkOfNone> marks = {};
};

// A row's fields without the blanks and quotes around them. An empty last field, as after a
// separator at the row's end, is left out.
std::vector<std::string_view> fields_of(std::string_view line, char separator);

// Returns the fields of the reader's row. Throws CaseFileError where they are not as many as the
// columns, or where the file ends within the row.
std::vector<std::string_view> fields_of_row(const TableReader& reader, const TableHead& head);

// "swlz [m]": a name and its unit; a text without brackets at its end is a name without a unit.
ForeignColumn column_of(std::string_view text);

// The columns of a line of such texts.
std::vector<ForeignColumn> columns_of(std::string_view line, char separator);

// The index of the column with this name, given with or without its unit. Throws CaseFileError,
// with the nearest names, where no column or more than one has it.
std::size_t column_place(const TableReader& reader, const TableHead& head, const std::string& key,
                         const std::string& name);

}  // namespace slosh
