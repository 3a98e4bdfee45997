#include "verification/import/import_series.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "verification/case/quantities.hpp"
#include "verification/files/result_error.hpp"
#include "verification/import/file_formats.hpp"
#include "verification/input/nearest_name.hpp"
#include "verification/input/tables/series_files.hpp"
#include "verification/input/tables/table_head.hpp"
#include "verification/input/tables/table_rows.hpp"
#include "verification/input/units.hpp"

namespace slosh {
namespace {

// Joins the parts of a series that a program wrote in several runs. Private to
// verification/import/.

// Values over increasing times, and where they begin in a file ("force.dat:4").
struct SeriesPart {
  std::vector<double> time, value;
  std::string place;
  std::string at = {};  // the coordinates of the gauge; empty where the file does not give them
};

// One series of several parts. A later part takes the place of all values of the earlier ones from
// its first time on, as the run from which it comes took the place of theirs.
class StitchedSeries {
 public:
  // Throws CaseFileError where the part begins before the first one, as the parts are not in order,
  // and where it is of a gauge at another place.
  void append(const SeriesPart& part);

  std::vector<double> time, value;
  std::vector<std::string> seams;  // one sentence for each part after the first

 private:
  std::string first_place_, at_;  // of the first part
};

constexpr double rounding = 1e-5;  // of coordinates, which OpenFOAM writes with six digits

bool is_same_place(const std::string& one, const std::string& other) {
  if (one == other) return true;
  const auto a = fields_of(one, ' '), b = fields_of(other, ' ');
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](auto first, auto second) {
    const auto x = number_in(first), y = number_in(second);
    return x && y && std::abs(*x - *y) <= rounding * std::max(std::abs(*x), std::abs(*y));
  });
}

void StitchedSeries::append(const SeriesPart& part) {
  if (part.time.empty()) return;
  const double begin = part.time.front();
  if (!time.empty()) {
    if (begin < time.front())
      throw CaseFileError(fmt::format(
          "{}: time = {}: expected a part that begins at {} or later, in s, as the one before it",
          part.place, begin, time.front()));
    if (!is_same_place(part.at, at_))
      throw CaseFileError(fmt::format("{}: place of the gauge = {}: expected {}, as in {}",
                                      part.place, part.at, at_, first_place_));
    const auto kept = std::lower_bound(time.begin(), time.end(), begin) - time.begin();
    const std::size_t replaced = time.size() - static_cast<std::size_t>(kept);
    seams.push_back(
        replaced == 0
            ? fmt::format("{}: goes on at {:.6g} s after {:.6g} s", part.place, begin, time.back())
            : fmt::format("{}: takes over at {:.6g} s; the {} values up to {:.6g} s before it are "
                          "left out",
                          part.place, begin, replaced, time.back()));
    time.erase(time.begin() + kept, time.end());
    value.erase(value.begin() + kept, value.end());
  } else {
    first_place_ = part.place;
    at_ = part.at;
  }
  time.insert(time.end(), part.time.begin(), part.time.end());
  value.insert(value.end(), part.value.begin(), part.value.end());
}

constexpr std::size_t least_rows = 4;  // the least for a comparison

[[noreturn]] void refuse(std::string_view place, std::string_view key, std::string_view value,
                         std::string_view expected) {
  throw CaseFileError(fmt::format("{}{}{} = {}: expected {}", place, place.empty() ? "" : ": ", key,
                                  value.empty() ? "(not given)" : value, expected));
}

struct Units {
  std::string time, value;
};

Units agreed_units(const SeriesSource& source, const TableColumn& time, const TableColumn& value) {
  return {
      agreed_unit(source.file, {"time_unit", source.time_unit, "time", "s", source.time_column},
                  time),
      agreed_unit(source.file,
                  {"unit", source.unit, source.quantity, unit_of(source.quantity), source.column},
                  value)};
}

// The checks that a text table gets row by row.
void check_numbers(const SeriesSource& source, const RawSeries& series) {
  const std::string file = source.file.string();
  const auto& [time, value, time_unit, unit] = series;
  if (time.size() != value.size())
    refuse(file, source.column, std::to_string(value.size()),
           fmt::format("as many values as times, {}", time.size()));
  for (std::size_t i = 0; i < time.size(); ++i)
    if (!std::isfinite(time[i]) || (i > 0 && !(time[i] > time[i - 1])))
      refuse(file, fmt::format("time {}", i), std::to_string(time[i]), "a time above the last one");
  if (const auto mark = first_mark_of_none(value))
    refuse(file, fmt::format("{}, value {}", source.column, *mark), fmt::format("{}", value[*mark]),
           no_mark_of_none);
}

// In SI units.
void append_part(const SeriesSource& source, const Units& units, SeriesPart part,
                 StitchedSeries& all) {
  const double time_scale = si_value(units.time, "s"),
               scale = si_value(units.value, unit_of(source.quantity));
  for (double& time : part.time) time *= time_scale;
  for (double& value : part.value) value *= scale;
  all.append(part);
}

// Turns a CaseFileError about the numbers into a ResultError: they are no mistake in the case file.
template <class Read>
void read_numbers(Read read) try {
  read();
} catch (const CaseFileError& error) {
  throw ResultError(error.what());
}

void append_other(const FileFormat& format, const SeriesSource& source, StitchedSeries& all) {
  const RawSeries raw = format.read_series(source);
  const Units units =
      agreed_units(source, {source.time_column, raw.time_unit}, {source.column, raw.unit});
  read_numbers([&] {
    check_numbers(source, raw);
    append_part(source, units, {raw.time, raw.value, source.file.string()}, all);
  });
}

void append_table(const FileFormat& format, const SeriesSource& source, StitchedSeries& all) {
  TableReader reader(source.file);
  const TableHead head = format.read_head(reader, source);
  const std::vector<std::size_t> summands = column_places(reader, head, "column", source.column);
  const TableColumn& column = head.columns[summands.front()];
  const Units units = agreed_units(source, head.columns[head.time], column);
  read_numbers([&] {
    for (TableSegment& part :
         read_segments(reader, head,
                       {.summands = summands,
                       .name = summands.size() == 1 ? column.name : source.column,
                       .time_unit = units.time,
                       .unit = units.value}))
      if (!part.time.empty())
        append_part(source, units,
                    {std::move(part.time), std::move(part.value),
                     fmt::format("{}:{}", source.file.string(), part.lines.front()), column.at},
                    all);
  });
}

void require_rows(const SeriesSource& source, const StitchedSeries& series) {
  if (series.time.size() < least_rows)
    throw ResultError(fmt::format("{}: rows = {}: expected at least {}", source.file.string(),
                                  series.time.size(), least_rows));
}

TimeSeries in_own_unit(const SeriesSource& source, StitchedSeries raw) {
  const double scale = source.scale;
  const double offset = source.first_is_zero ? -scale * raw.value.front() : source.offset;
  for (double& time : raw.time) time += source.time_offset;
  for (double& value : raw.value) value = scale * value + offset;
  for (const double value : raw.value)
    if (!(std::abs(value) < least_mark_of_none))
      refuse(source.file.string(), source.column,
             fmt::format("its values times {} plus {}", source.scale, offset),
             fmt::format("a scale and an offset that leave values below {}", least_mark_of_none));
  return {source.quantity, unit_of(source.quantity), std::move(raw.time), std::move(raw.value)};
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

ImportedSeries import_series(const SeriesSource& source,
                             const std::vector<std::filesystem::path>& files) {
  require_known_form(source);
  const FileFormat& format = format_of(source);
  StitchedSeries all;
  SeriesSource part = source;
  for (const std::filesystem::path& file : files) {
    part.file = file;
    format.read_head ? append_table(format, part, all) : append_other(format, part, all);
  }
  require_rows(part, all);
  std::vector<std::string> seams = std::move(all.seams);
  return {in_own_unit(part, std::move(all)), std::move(seams)};
}

ImportedSeries import_with_seams(const SeriesSource& source) {
  require_known_form(source);
  const std::vector<std::filesystem::path> files = series_files(source.file);
  if (files.empty()) refuse("", "file", source.file.string(), "a file; " + no_file_at(source.file));
  return import_series(source, files);
}

TimeSeries import_series(const SeriesSource& source) { return import_with_seams(source).series; }

}  // namespace slosh
