// Tables of any program: names in the first line, which may begin with a '#', then rows of numbers
// with a decimal point.
#include "verification/import/table_head.hpp"

namespace slosh {
namespace {

char separator_in(std::string_view line) {
  for (const char separator : {';', ',', '\t'})
    if (line.find(separator) != line.npos) return separator;
  return ' ';
}

}  // namespace

TableHead read_csv_head(TableReader& reader, const SeriesSource& source) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  const std::string line = reader.line();
  std::string_view names = line;
  if (names.starts_with(byte_order_mark)) names.remove_prefix(byte_order_mark.size());
  if (names.starts_with('#')) names.remove_prefix(1);
  TableHead head;
  head.separator = separator_in(names);
  head.columns = columns_of(names, head.separator);
  if (head.columns.empty()) reader.refuse("head", line, "a first line with the columns' names");
  head.time = column_place(reader, head, "time_column", source.time_column);
  // The user's name for the column of times may contain its unit.
  if (head.columns[head.time].unit.empty())
    head.columns[head.time].unit = column_of(source.time_column).unit;
  reader.next();
  return head;
}

}  // namespace slosh
