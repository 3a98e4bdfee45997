// The head of a text table: its columns with their units, and how its rows are parted.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "verification/input/tables/table_reader.hpp"

namespace slosh {

struct TableColumn {
  std::string name, unit;  // the unit is empty where the file does not give it
  std::string at = {};     // the coordinates of a gauge, "(0.5 0 0.1)", where the head has them
};

// A value that a file does not hold, but its summands.
struct ColumnSum {
  std::string name;
  std::vector<std::size_t> columns;  // their indices
};

// A program may write a mark in place of a value that it could not find: the value of another
// column.
struct MarkOfNone {
  std::size_t column, mark;  // indices of the value's column and of the mark's
  std::string expected;
};

struct TableHead {
  std::vector<TableColumn> columns;
  int line = 1;           // the line with the names
  std::string text = {};  // of that line
  std::size_t time = 0;   // index of the column of times
  char separator = ' ';   // ' ': any run of blanks, tabs and parentheses
  std::vector<ColumnSum> sums = {};
  std::vector<MarkOfNone> marks = {};
};

// A row's fields without the blanks and quotes around them. An empty last field, as after a
// separator at the row's end, is left out.
std::vector<std::string_view> fields_of(std::string_view line, char separator);

// Returns the fields of the reader's row. Throws CaseFileError where they are not as many as the
// columns, or where the file ends within the row.
std::vector<std::string_view> fields_of_row(const TableReader& reader, const TableHead& head);

// Whether the line begins with '#' or '%'.
bool is_comment(std::string_view line);
// Returns the line without such a beginning and the blanks about it.
std::string_view without_comment_mark(std::string_view line);

// A name and its unit: "swlz [m]", "p[mbar]", "P1 (kPa)". Brackets that hold an index or a place
// ("Position[0]", "phi [0.5 0.1 0]") and parentheses that hold no known unit belong to the name.
// Each run of blanks counts as one.
TableColumn column_of(std::string_view text);

// The columns of a line of such texts. Separators within quotes or brackets part no names, and a
// unit between blanks belongs to the name before it ("t [s] eta [m]").
std::vector<TableColumn> columns_of(std::string_view line, char separator);

// The head of the reader's line, which may begin with a comment mark.
TableHead head_of_line(const TableReader& reader, char separator);

// Finds the head of any program's table: the first line that `is_head` accepts with one of the
// separators ';', tab, ',' and blank, or a later one of the lines before the rows that it accepts
// too. Where there is none, returns the last line before the first row of numbers. Leaves the
// reader on the first row, or at the end. Throws CaseFileError where no line precedes the numbers.
TableHead find_head(TableReader& reader, const std::function<bool(const TableHead&)>& is_head);
// The same with a head that has all these columns, given with or without their units.
TableHead find_head(TableReader& reader, const std::vector<std::string>& columns);

// The index of the column with this name, given with or without its unit. Throws CaseFileError,
// with the nearest names, where no column or more than one has it.
std::size_t column_place(const TableReader& reader, const TableHead& head, const std::string& key,
                         const std::string& name);
// The indices of the columns whose sum has this name: those of a ColumnSum, or one column.
std::vector<std::size_t> column_places(const TableReader& reader, const TableHead& head,
                                       const std::string& key, const std::string& name);

// What the user says of a column's unit.
struct ToldUnit {
  std::string key, unit;    // the unit is empty where nothing is said
  std::string of;           // what has the unit, "elevation@right"
  std::string si_unit;      // of that
  std::string column = {};  // as the user names it, which may be with its unit
};

// Returns the unit that the user or the file gives: in the column's unit, or at the end of its name
// ("p_kPa"). If both do, they must agree; a force in N may be told to be one per metre of width,
// which no file can know. Throws CaseFileError where they do not agree, where neither gives a unit
// and where it is none of this kind.
std::string agreed_unit(const std::filesystem::path& file, const ToldUnit& told,
                        const TableColumn& column);

}  // namespace slosh
