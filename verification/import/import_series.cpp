#include "verification/import/import_series.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "verification/case/quantities.hpp"
#include "verification/files/result_error.hpp"
#include "verification/import/file_formats.hpp"
#include "verification/input/nearest_name.hpp"
#include "verification/input/units.hpp"

namespace slosh {
namespace {

constexpr std::size_t least_rows = 4;  // the least for a comparison
// Programs write a missing value as the largest number of a type: 1e300 (OpenFOAM), 3.4e38.
constexpr double largest_value = 1e30;

[[noreturn]] void refuse(std::string_view place, std::string_view key, std::string_view value,
                         std::string_view expected) {
  throw CaseFileError(fmt::format("{}{}{} = {}: expected {}", place, place.empty() ? "" : ": ", key,
                                  value.empty() ? "(not given)" : value, expected));
}

std::string one_of(const std::vector<std::string>& names) {
  return names.size() == 1 ? names.front() : fmt::format("one of {}", fmt::join(names, ", "));
}

bool is_one_of(const std::string& name, const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// The unit that the user or the file gives; if both do, they must agree. A force in N may be
// declared as one per metre of width, which no file can know.
std::string agreed_unit(const SeriesSource& source, const std::string& key, const std::string& told,
                        const std::string& in_file, const std::string& si_unit) {
  const std::vector<std::string> known = unit_names(si_unit);
  std::string unit = told.empty() ? in_file : told;
  const std::string expected =
      fmt::format("a unit of {}, {}", si_unit == "s" ? "time" : source.quantity, one_of(known));
  if (!is_one_of(unit, known)) refuse(source.file.string(), key, unit, expected);
  const bool of_a_width = is_one_of(in_file + "/m", known);
  if (!in_file.empty() && in_file != unit && !of_a_width)
    refuse(source.file.string(), key, unit, fmt::format("{}, as the file says", in_file));
  return unit;
}

struct Units {
  std::string time, value;
};

Units agreed_units(const SeriesSource& source, const std::string& time_in_file,
                   const std::string& value_in_file) {
  return {agreed_unit(source, "time_unit", source.time_unit, time_in_file, "s"),
          agreed_unit(source, "unit", source.unit, value_in_file, unit_of(source.quantity))};
}

double value_of(const TableReader& reader, const std::string& column, std::string_view text,
                const std::string& unit) {
  const double value = reader.number(column, text, unit);
  if (!(std::abs(value) < largest_value))
    reader.refuse(column, text, fmt::format("a value and not a mark of none, in {}", unit));
  return value;
}

RawSeries read_rows(TableReader& reader, const TableHead& head, std::size_t column,
                    const Units& units) {
  RawSeries series;
  const std::string &time_name = head.columns[head.time].name, &name = head.columns[column].name;
  do {
    if (trimmed(reader.line()).empty()) continue;
    const auto fields = fields_of_row(reader, head);
    for (const MarkOfNone& one : head.marks)
      if (one.column == column && fields[column] == fields[one.mark])
        reader.refuse(name, fields[column], one.expected);
    reader.add_time(time_name, fields[head.time], units.time, series.time);
    series.value.push_back(value_of(reader, name, fields[column], units.value));
  } while (reader.next());
  return series;
}

// The checks that a text table gets row by row.
void check_numbers(const SeriesSource& source, const RawSeries& series) {
  const std::string file = source.file.string();
  const auto& [time, value, time_unit, unit] = series;
  if (time.size() != value.size())
    refuse(file, source.column, std::to_string(value.size()),
           fmt::format("as many values as times, {}", time.size()));
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (!std::isfinite(time[i]) || (i > 0 && !(time[i] > time[i - 1])))
      refuse(file, fmt::format("time {}", i), std::to_string(time[i]), "a time above the last one");
    if (!(std::abs(value[i]) < largest_value))
      refuse(file, fmt::format("{}, value {}", source.column, i), std::to_string(value[i]),
             "a finite value");
  }
}

void require_rows(const SeriesSource& source, const RawSeries& series) {
  if (series.time.size() < least_rows)
    refuse(source.file.string(), "rows", std::to_string(series.time.size()),
           fmt::format("at least {}", least_rows));
}

// Turns a CaseFileError about the numbers into a ResultError: they are no mistake in the case file.
template <class Read>
RawSeries usable(const SeriesSource& source, Read read) try {
  RawSeries series = read();
  require_rows(source, series);
  return series;
} catch (const CaseFileError& error) {
  throw ResultError(error.what());
}

TimeSeries in_own_unit(const SeriesSource& source, const Units& units, RawSeries raw) {
  const std::string unit = unit_of(source.quantity);
  const double time_scale = si_value(units.time, "s");
  const double scale = source.scale * si_value(units.value, unit);
  for (double& time : raw.time) time *= time_scale;
  const double offset = source.first_is_zero ? -scale * raw.value.front() : source.offset;
  for (double& value : raw.value) value = scale * value + offset;
  if (std::any_of(raw.value.begin(), raw.value.end(),
                  [](double value) { return !(std::abs(value) < largest_value); }))
    refuse(source.file.string(), source.column,
           fmt::format("its values times {} plus {}", source.scale, offset),
           fmt::format("a scale and an offset that leave values below {}", largest_value));
  return {source.quantity, unit, std::move(raw.time), std::move(raw.value)};
}

TimeSeries import_other(const FileFormat& format, const SeriesSource& source) {
  RawSeries raw = format.read_series(source);
  const Units units = agreed_units(source, raw.time_unit, raw.unit);
  raw = usable(source, [&] {
    check_numbers(source, raw);
    return raw;
  });
  return in_own_unit(source, units, std::move(raw));
}

TimeSeries import_table(const FileFormat& format, const SeriesSource& source) {
  TableReader reader(source.file);
  const TableHead head = format.read_head(reader, source);
  const std::size_t column = column_place(reader, head, "column", source.column);
  std::string told = column_of(source.column).unit;
  SeriesSource asked = source;
  if (asked.unit.empty()) asked.unit = told;
  const Units units = agreed_units(asked, head.columns[head.time].unit, head.columns[column].unit);
  return in_own_unit(source, units,
                     usable(source, [&] { return read_rows(reader, head, column, units); }));
}

const FileFormat& format_of(const SeriesSource& source) {
  for (const FileFormat& format : file_formats())
    if (format.name == source.format) return format;
  refuse("", "format", source.format,
         fmt::format("one of {}; nearest: {}", fmt::join(format_names(), ", "),
                     nearest_names(source.format, format_names(), 1).front()));
}

}  // namespace

void require_known_form(const SeriesSource& source) {
  const TimeColumn time = format_of(source).time_column;
  if (time == TimeColumn::must_be_named && source.time_column.empty())
    refuse("", "time_column", "",
           "the name of the file's column of times (--time, or time_column in a case file)");
  if (time == TimeColumn::known_by_format && !(source.time_column + source.time_unit).empty())
    refuse("", "time_column", source.time_column,
           fmt::format("no time column or unit: a {} file has its own", source.format));
}

TimeSeries import_series(const SeriesSource& source) {
  require_known_form(source);
  if (!std::filesystem::is_regular_file(source.file))
    refuse("", "file", source.file.string(), "a file; there is none");
  const FileFormat& format = format_of(source);
  return format.read_head ? import_table(format, source) : import_other(format, source);
}

}  // namespace slosh
