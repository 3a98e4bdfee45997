#include "verification/import/table_head.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "verification/input/nearest_name.hpp"

namespace slosh {
namespace {

constexpr std::string_view blanks = " \t()";

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (;;) {
    const std::size_t begin = line.find_first_not_of(blanks);
    if (begin == line.npos) return words;
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(blanks), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

// The length of the line up to the next separator outside quotes.
std::size_t field_length(std::string_view line, char separator) {
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (line[i] == separator && !quoted) return i;
  }
  return line.size();
}

std::string_view unquoted(std::string_view field) {
  field = trimmed(field);
  if (field.size() < 2 || field.front() != '"' || field.back() != '"') return field;
  return trimmed(field.substr(1, field.size() - 2));
}

}  // namespace

std::vector<std::string_view> fields_of(std::string_view line, char separator) {
  if (separator == ' ') return words_of(line);
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t length = field_length(line, separator);
    fields.push_back(unquoted(line.substr(0, length)));
    if (length == line.size()) break;
    line.remove_prefix(length + 1);
  }
  if (fields.back().empty()) fields.pop_back();
  return fields;
}

std::vector<std::string_view> fields_of_row(const TableReader& reader, const TableHead& head) {
  const auto fields = fields_of(reader.line(), head.separator);
  if (fields.size() != head.columns.size())
    reader.refuse("row", reader.line(), fmt::format("{} values", head.columns.size()));
  if (reader.is_cut())
    reader.refuse("row", reader.line(), "an end of the line: the file may be cut short here");
  return fields;
}

ForeignColumn column_of(std::string_view text) {
  const std::size_t open = text.rfind('[');
  // "Position[0]" is a component, "swlz [m]" a unit.
  if (!text.ends_with(']') || open == text.npos || open == 0 || text[open - 1] != ' ')
    return {std::string(text), ""};
  return {std::string(trimmed(text.substr(0, open))),
          std::string(trimmed(text.substr(open + 1, text.size() - open - 2)))};
}

std::vector<ForeignColumn> columns_of(std::string_view line, char separator) {
  std::vector<ForeignColumn> columns;
  for (const std::string_view field : fields_of(line, separator))
    columns.push_back(column_of(field));
  return columns;
}

std::size_t column_place(const TableReader& reader, const TableHead& head, const std::string& key,
                         const std::string& name) {
  const ForeignColumn wanted = column_of(name);
  std::vector<std::size_t> found;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < head.columns.size(); ++i) {
    const ForeignColumn& column = head.columns[i];
    names.push_back(column.name);
    if (column.name == wanted.name &&
        (wanted.unit.empty() || column.unit.empty() || column.unit == wanted.unit))
      found.push_back(i);
  }
  const auto refuse = [&](const std::string& expected) {
    throw table_error(reader.file(), head.line, key, name, expected);
  };
  constexpr std::size_t suggestions = 3;
  if (found.empty())
    refuse(fmt::format("one of the file's {} columns; nearest: {}", names.size(),
                       fmt::join(nearest_names(wanted.name, names, suggestions), ", ")));
  if (found.size() > 1) refuse(fmt::format("a name that one column has; {} have it", found.size()));
  return found.front();
}

}  // namespace slosh
