// The rows of a table below its head, and a series of values over time in them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verification/input/tables/table_head.hpp"

namespace slosh {

// Goes through the rows from the reader's line on. Skips empty lines, comments and the head where
// it stands again, as where a program that was restarted goes on in its file.
class TableRows {
 public:
  TableRows(TableReader& reader, const TableHead& head) : reader_(reader), head_(head) {}

  // Goes to the next row. Returns false at the end. Throws CaseFileError as fields_of_row() does,
  // and where another head stands among the rows.
  bool next();

  const std::vector<std::string_view>& fields() const { return fields_; }
  // Whether a head or a comment stands between this row and the last one.
  bool follows_head() const { return follows_head_; }

 private:
  TableReader& reader_;
  const TableHead& head_;
  std::vector<std::string_view> fields_;
  bool started_ = false, follows_head_ = false;
};

// Rows over increasing times, which another such part may follow in the same file or the next.
struct TableSegment {
  std::vector<double> time, value;
  std::vector<int> lines;  // of the rows
};

// Which columns the value of a series is in. The units are those of messages.
struct SeriesPlaces {
  std::vector<std::size_t> summands;
  std::string name, time_unit, unit;
};

// Reads the rows. A new segment begins where the times go back behind a head that stands again.
// Throws CaseFileError where they go back otherwise, and where a number is not finite or a mark of
// none.
std::vector<TableSegment> read_segments(TableReader& reader, const TableHead& head,
                                        const SeriesPlaces& places);

// Programs write a missing value as 1e20, 1e30, 1e300 (OpenFOAM) or the largest number of a type.
inline constexpr double least_mark_of_none = 1e20;
// Returns the index of the first value that stands for none: its magnitude is that or more, or it
// is the lowest or the highest, a whole number of 9 or more as -999 or 65535, and no other comes
// within half of it. One that no program is known to write as a mark, as -9000, has to come twice
// and to stand apart from all others by ten times what these do from one another.
std::optional<std::size_t> first_mark_of_none(const std::vector<double>& values);
// What a value must be that first_mark_of_none() does not name.
inline constexpr const char* no_mark_of_none = "a value and not a mark of none";

}  // namespace slosh
