#include "verification/input/tables/table_head.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "verification/input/nearest_name.hpp"
#include "verification/input/units.hpp"

namespace slosh {
namespace {

constexpr std::string_view blank_or_tab = " \t", comment_marks = "#%", separators = ";\t, ";

std::vector<std::string_view> words_of(std::string_view line, std::string_view blanks) {
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

// The places of the separators outside quotes and, in a head, outside brackets.
std::vector<std::size_t> partings(std::string_view line, char separator, bool brackets_join) {
  std::vector<std::size_t> places;
  bool quoted = false;
  int depth = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (brackets_join && (c == '[' || c == '(')) ++depth;
    if (brackets_join && (c == ']' || c == ')')) --depth;
    if (depth == 0 && (c == separator || (separator == ' ' && c == '\t'))) places.push_back(i);
  }
  return depth == 0 ? places : partings(line, separator, false);
}

std::string_view unquoted(std::string_view field) {
  field = trimmed(field);
  if (field.size() < 2 || field.front() != '"' || field.back() != '"') return field;
  return trimmed(field.substr(1, field.size() - 2));
}

std::vector<std::string_view> parts_at(std::string_view line, const std::vector<std::size_t>& at) {
  std::vector<std::string_view> parts;
  std::size_t begin = 0;
  for (const std::size_t end : at) {
    parts.push_back(unquoted(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  parts.push_back(unquoted(line.substr(begin)));
  if (parts.back().empty()) parts.pop_back();
  return parts;
}

// Each run of blanks as one, and none just inside of brackets.
std::string in_one_spelling(std::string_view text) {
  std::string spelt = fmt::format("{}", fmt::join(words_of(text, blank_or_tab), " "));
  for (const auto& [blank, tight] : {std::pair{"[ ", "["}, {" ]", "]"}, {"( ", "("}, {" )", ")"}})
    for (std::size_t at; (at = spelt.find(blank)) != spelt.npos;) spelt.replace(at, 2, tight);
  return spelt;
}

// "0.5 0.1 0", "0.5, 0.1", "3": numbers alone.
bool is_place(std::string_view text) {
  const auto words = words_of(text, " ,;");
  return std::all_of(words.begin(), words.end(),
                     [](std::string_view word) { return number_in(word).has_value(); });
}

bool is_asked_for(const TableColumn& column, const TableColumn& wanted) {
  return column.name == wanted.name &&
         (wanted.unit.empty() || column.unit.empty() || column.unit == wanted.unit);
}

bool has_columns(const TableHead& head, const std::vector<std::string>& names) {
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    return std::any_of(
        head.columns.begin(), head.columns.end(),
        [wanted = column_of(name)](const TableColumn& one) { return is_asked_for(one, wanted); });
  });
}

// A row of numbers alone, some of which may be NaN or have a decimal comma.
bool is_row_of_numbers(std::string_view line) {
  return std::any_of(separators.begin(), separators.end(), [&](char separator) {
    const auto fields = fields_of(line, separator);
    return fields.size() > 1 &&
           std::all_of(fields.begin(), fields.end(), [](std::string_view field) {
             return number_in(field) || has_decimal_comma(field);
           });
  });
}

// The head with the first separator that parts it.
TableHead parted_head(const TableReader& reader) {
  for (const char separator : separators)
    if (TableHead head = head_of_line(reader, separator); head.columns.size() > 1) return head;
  return head_of_line(reader, separators.back());
}

std::optional<TableHead> accepted_head(const TableReader& reader,
                                       const std::function<bool(const TableHead&)>& is_head) {
  for (const char separator : separators)
    if (TableHead head = head_of_line(reader, separator); is_head(head)) return head;
  return std::nullopt;
}

}  // namespace

std::vector<std::string_view> fields_of(std::string_view line, char separator) {
  return separator == ' ' ? words_of(line, " \t()")
                          : parts_at(line, partings(line, separator, false));
}

std::vector<std::string_view> fields_of_row(const TableReader& reader, const TableHead& head) {
  auto fields = fields_of(reader.line(), head.separator);
  const std::size_t columns = head.columns.size();
  if (fields.size() != columns) {
    // Decimal commas part each number in two.
    const bool is_of_halves = head.separator == ',' && fields.size() > columns &&
                              reader.line().find('.') == std::string::npos;
    reader.refuse("row", reader.line(),
                  fmt::format("{} values{}", columns,
                              is_of_halves ? ", with decimal points and no decimal commas" : ""));
  }
  if (reader.is_cut())
    reader.refuse("row", reader.line(), "an end of the line: the file may be cut short here");
  return fields;
}

bool is_comment(std::string_view line) {
  return comment_marks.find(trimmed(line).substr(0, 1)) != comment_marks.npos &&
         !trimmed(line).empty();
}

std::string_view without_comment_mark(std::string_view line) {
  line = trimmed(line);
  return trimmed(line.substr(std::min(line.find_first_not_of(comment_marks), line.size())));
}

TableColumn column_of(std::string_view text) {
  const std::string spelt = in_one_spelling(text);
  const std::size_t open = spelt.ends_with(']')   ? spelt.rfind('[')
                           : spelt.ends_with(')') ? spelt.rfind('(')
                                                  : spelt.npos;
  if (open == spelt.npos || open == 0) return {spelt, ""};
  const std::string unit = unit_spelt(spelt.substr(open + 1, spelt.size() - open - 2));
  const bool is_apart = spelt[open] == '[' && spelt[open - 1] == ' ' && !is_place(unit);
  if (!is_apart && !is_unit(unit)) return {spelt, ""};
  return {std::string(trimmed(std::string_view(spelt).substr(0, open))), unit};
}

std::vector<TableColumn> columns_of(std::string_view line, char separator) {
  std::vector<std::string> names;
  for (const std::string_view part : parts_at(line, partings(line, separator, true))) {
    if (separator != ' ')
      names.emplace_back(part);
    else if (!names.empty() && (part.starts_with('[') || part.starts_with('(')))
      names.back() += " " + std::string(part);
    else if (!part.empty())
      names.emplace_back(part);
  }
  std::vector<TableColumn> columns;
  for (const std::string& name : names) columns.push_back(column_of(name));
  return columns;
}

TableHead head_of_line(const TableReader& reader, char separator) {
  return {.columns = columns_of(without_comment_mark(reader.line()), separator),
          .line = reader.line_number(),
          .text = reader.line(),
          .separator = separator};
}

TableHead find_head(TableReader& reader, const std::function<bool(const TableHead&)>& is_head) {
  std::optional<TableHead> found, first, last;
  do {
    if (trimmed(reader.line()).empty()) continue;
    if (auto head = accepted_head(reader, is_head)) {
      found = std::move(head);
    } else if (found) {
      if (!is_comment(reader.line())) return *found;
    } else if (last && is_row_of_numbers(reader.line())) {
      return *last;
    } else if (is_row_of_numbers(reader.line())) {
      break;
    } else {
      last = parted_head(reader);
      if (!first) first = last;
    }
  } while (reader.next());
  if (found || first) return found ? *found : *first;
  reader.refuse("head", reader.line().empty() ? "(nothing)" : reader.line(),
                "a line with the columns' names above the numbers");
}

TableHead find_head(TableReader& reader, const std::vector<std::string>& columns) {
  return find_head(reader, [&](const TableHead& head) { return has_columns(head, columns); });
}

std::size_t column_place(const TableReader& reader, const TableHead& head, const std::string& key,
                         const std::string& name) {
  const TableColumn wanted = column_of(name);
  std::vector<std::size_t> found;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < head.columns.size(); ++i) {
    names.push_back(head.columns[i].name);
    if (is_asked_for(head.columns[i], wanted)) found.push_back(i);
  }
  for (const ColumnSum& sum : head.sums) names.push_back(sum.name);
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

std::vector<std::size_t> column_places(const TableReader& reader, const TableHead& head,
                                       const std::string& key, const std::string& name) {
  for (const ColumnSum& sum : head.sums)
    if (sum.name == name) return sum.columns;
  return {column_place(reader, head, key, name)};
}

std::string agreed_unit(const std::filesystem::path& file, const ToldUnit& told,
                        const TableColumn& column) {
  const std::vector<std::string> known = unit_names(told.si_unit);
  const auto is_known = [&](const std::string& unit) {
    return std::find(known.begin(), known.end(), unit) != known.end();
  };
  const auto refuse = [&](const std::string& unit, const std::string& expected) {
    throw CaseFileError(fmt::format("{}: {} = {}: expected {}", file.string(), told.key,
                                    unit.empty() ? "(not given)" : unit, expected));
  };
  const std::string in_name = column_of(told.column).unit;
  const std::string in_file =
      column.unit.empty() ? unit_at_end(column.name, told.si_unit) : column.unit;
  const std::string said = told.unit.empty() ? in_name : unit_spelt(told.unit);
  const std::string unit = said.empty() ? in_file : said;
  if (!is_known(unit))
    refuse(unit, fmt::format("a unit of {}, {}{}", told.of, known.size() == 1 ? "" : "one of ",
                             fmt::join(known, ", ")));
  const auto contradicts = [&](const std::string& other) {
    return !other.empty() && other != unit && !is_known(other + "/m");
  };
  const auto hold_against = [&](const std::string& other, const char* speaker) {
    if (!contradicts(other)) return;
    // In "eta [WG3]" it is no unit, and none of the key would agree with it.
    refuse(unit, is_known(other) ? fmt::format("{}, as {} says", other, speaker)
                                 : fmt::format("one of {} in the file's head too, in place of {}",
                                               fmt::join(known, ", "), other));
  };
  hold_against(in_name, "the column's name");
  hold_against(in_file, "the file");
  return unit;
}

}  // namespace slosh
