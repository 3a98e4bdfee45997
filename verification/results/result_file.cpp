#include "verification/results/result_file.hpp"

#include <fmt/format.h>

#include <string_view>
#include <tuple>
#include <utility>

#include "verification/files/hdf5_handles.hpp"
#include "verification/files/sealed_file.hpp"

namespace slosh {
namespace {

using hdf5::Handle;

constexpr SealedKind kind{"result", 2};

// HDF5 separates groups by '/', so a link's name has "%2F" instead; the attribute "name" has the
// unchanged name.
std::string link_name(const std::string& series_name) {
  std::string link;
  for (const char c : series_name) link += c == '/' ? "%2F" : c == '%' ? "%25" : std::string(1, c);
  return link;
}

// The cost's fields and their names, units included, in the file: one list for the writer and the
// reader.
constexpr std::pair<const char*, double RunCost::*> cost_fields[] = {
    {"wall_time_s", &RunCost::wall_time},
    {"user_time_s", &RunCost::user_time},
    {"system_time_s", &RunCost::system_time},
    {"peak_memory_byte", &RunCost::peak_memory},
    {"steps", &RunCost::steps},
    {"elements", &RunCost::elements}};

// The texts of the root; the series and the maps have loops of their own.
constexpr std::pair<const char*, std::string RunResult::*> root_fields[] = {
    {"case_name", &RunResult::case_name},
    {"run_name", &RunResult::run_name},
    {"solver", &RunResult::solver},
    {"key", &RunResult::key}};

void require_sound(const TimeSeries& series) {
  if (series.name.empty()) throw ResultError("a series without a name");
  if (series.time.size() != series.value.size()) {
    throw ResultError(fmt::format("series {} has {} times and {} values, expected as many of both",
                                  series.name, series.time.size(), series.value.size()));
  }
}

void write_series(hid_t parent, const TimeSeries& series) {
  require_sound(series);
  const Handle group = hdf5::create_group(parent, link_name(series.name));
  hdf5::write_attribute(group, "name", series.name);
  hdf5::write_attribute(hdf5::write_numbers(group, "time", series.time), "unit", "s");
  hdf5::write_attribute(hdf5::write_numbers(group, "value", series.value), "unit", series.unit);
}

TimeSeries read_series(hid_t parent, const std::string& link) {
  const Handle group = hdf5::open_group(parent, link);
  const Handle value(H5Dopen2(group, "value", H5P_DEFAULT), H5Dclose, "open the data set value");
  TimeSeries series{.name = hdf5::read_text_attribute(group, "name"),
                    .unit = hdf5::read_text_attribute(value, "unit"),
                    .time = hdf5::read_numbers(group, "time"),
                    .value = hdf5::read_numbers(group, "value")};
  require_sound(series);
  return series;
}

constexpr std::tuple<const char*, const char*, std::vector<double> FieldSnapshot::*>
    snapshot_fields[] = {{"x", "m", &FieldSnapshot::x},
                         {"z", "m", &FieldSnapshot::z},
                         {"velocity_x", "m/s", &FieldSnapshot::velocity_x},
                         {"velocity_z", "m/s", &FieldSnapshot::velocity_z},
                         {"pressure", "Pa", &FieldSnapshot::pressure}};

constexpr std::pair<const char*, double FieldSnapshot::*> snapshot_numbers[] = {
    {"time_s", &FieldSnapshot::time},
    {"width_m", &FieldSnapshot::width},
    {"height_m", &FieldSnapshot::height}};

void require_sound(const FieldSnapshot& snapshot, const std::string& name) {
  for (const auto& [field, unit, values] : snapshot_fields) {
    if ((snapshot.*values).size() != snapshot.x.size())
      throw ResultError(fmt::format("snapshot {} has {} places and {} values of {}", name,
                                    snapshot.x.size(), (snapshot.*values).size(), field));
  }
}

void write_snapshot(hid_t parent, const std::string& name, const FieldSnapshot& snapshot) {
  require_sound(snapshot, name);
  const Handle group = hdf5::create_group(parent, name);
  for (const auto& [number, field] : snapshot_numbers)
    hdf5::write_attribute(group, number, snapshot.*field);
  for (const auto& [field, unit, values] : snapshot_fields)
    hdf5::write_attribute(hdf5::write_numbers(group, field, snapshot.*values), "unit", unit);
}

FieldSnapshot read_snapshot(hid_t parent, const std::string& name) {
  const Handle group = hdf5::open_group(parent, name);
  FieldSnapshot snapshot{};
  for (const auto& [number, field] : snapshot_numbers)
    snapshot.*field = hdf5::read_number_attribute(group, number);
  for (const auto& [field, unit, values] : snapshot_fields)
    snapshot.*values = hdf5::read_numbers(group, field);
  require_sound(snapshot, name);
  return snapshot;
}

void write_content(const RunResult& result, hid_t file) {
  hdf5::write_attribute(file, "format", "slosh result");
  hdf5::write_attribute(file, "format_version", kind.version);
  for (const auto& [name, field] : root_fields) hdf5::write_attribute(file, name, result.*field);
  hdf5::write_texts(file, "case_text", {result.case_text});
  hdf5::write_texts(file, "active_terms", result.active_terms);
  const Handle cost = hdf5::create_group(file, "cost");
  for (const auto& [name, field] : cost_fields)
    hdf5::write_attribute(cost, name, result.cost.*field);
  const Handle provenance = hdf5::create_group(file, "provenance");
  for (const auto& [name, text] : result.provenance) hdf5::write_attribute(provenance, name, text);
  const Handle diagnostics = hdf5::create_group(file, "diagnostics");
  for (const auto& [name, value] : result.diagnostics)
    hdf5::write_attribute(diagnostics, name, value);
  const Handle series = hdf5::create_group(file, "series");
  for (const TimeSeries& one : result.series) write_series(series, one);
  const Handle snapshots = hdf5::create_group(file, "snapshots");
  for (std::size_t i = 0; i < result.snapshots.size(); ++i)
    write_snapshot(snapshots, fmt::format("{:05d}", i), result.snapshots[i]);
}

RunResult read_content(hid_t file) {
  RunResult result;
  for (const auto& [name, field] : root_fields)
    result.*field = hdf5::read_text_attribute(file, name);
  const std::vector<std::string> case_text = hdf5::read_texts(file, "case_text");
  if (case_text.size() != 1)
    throw ResultError(fmt::format("case_text holds {} texts, expected one", case_text.size()));
  result.case_text = case_text.front();
  result.active_terms = hdf5::read_texts(file, "active_terms");
  const Handle cost = hdf5::open_group(file, "cost");
  for (const auto& [name, field] : cost_fields) {
    result.cost.*field = hdf5::read_number_attribute(cost, name);
  }
  const Handle provenance = hdf5::open_group(file, "provenance");
  for (const std::string& name : hdf5::attribute_names(provenance)) {
    result.provenance[name] = hdf5::read_text_attribute(provenance, name);
  }
  const Handle diagnostics = hdf5::open_group(file, "diagnostics");
  for (const std::string& name : hdf5::attribute_names(diagnostics)) {
    result.diagnostics[name] = hdf5::read_number_attribute(diagnostics, name);
  }
  const Handle series = hdf5::open_group(file, "series");
  for (const std::string& link : hdf5::member_names(series)) {
    result.series.push_back(read_series(series, link));
  }
  const Handle snapshots = hdf5::open_group(file, "snapshots");
  for (const std::string& name : hdf5::member_names(snapshots))
    result.snapshots.push_back(read_snapshot(snapshots, name));
  return result;
}

}  // namespace

const TimeSeries& RunResult::at(const std::string& series_name) const {
  for (const TimeSeries& one : series) {
    if (one.name == series_name) return one;
  }
  throw ResultError(fmt::format("the result of run {} of case {} has no series {}", run_name,
                                case_name, series_name));
}

void write_result(const RunResult& result, const std::filesystem::path& file) {
  write_sealed(kind, file, [&](hid_t root) { write_content(result, root); });
}

RunResult read_result(const std::filesystem::path& file) {
  RunResult result;
  read_sealed(kind, file, [&](hid_t root) { result = read_content(root); });
  return result;
}

}  // namespace slosh
