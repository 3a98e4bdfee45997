// A result file is an HDF5 image followed by one line of fixed length, the seal:
//   "slosh result <version> <hash of every byte before it>\n"
// HDF5 readers pay bytes past the image's end no heed. The seal is checked before HDF5 sees the
// image, so that a damaged file meets a message and not the parser of a foreign format.
#include "verification/runs/result_file.hpp"

#include <fmt/format.h>

#include <string_view>
#include <tuple>
#include <utility>

#include "verification/runs/atomic_file.hpp"
#include "verification/runs/content_hash.hpp"
#include "verification/runs/hdf5_handles.hpp"

namespace slosh {
namespace {

using hdf5::checked;
using hdf5::Handle;

constexpr int format_version = 2;
constexpr std::string_view seal_begin = "\nslosh result ";
constexpr std::size_t hash_length = 32;
constexpr std::size_t seal_length = seal_begin.size() + 3 + 1 + hash_length + 1;

std::string seal(std::string_view image) {
  return fmt::format("{}{:03d} {}\n", seal_begin, format_version, content_hash(image));
}

// The bytes of the image; throws ResultError unless the seal fits them.
std::string_view unsealed(std::string_view bytes) {
  if (bytes.size() < seal_length) throw ResultError("not a whole result file");
  const std::string_view image = bytes.substr(0, bytes.size() - seal_length);
  const std::string_view found = bytes.substr(image.size());
  if (!found.starts_with(seal_begin)) {
    throw ResultError(
        "not a whole result file (it does not end with its checksum): truncated or foreign");
  }
  const std::string expected = seal(image);
  const auto version = [](std::string_view text) { return text.substr(seal_begin.size(), 3); };
  if (version(found) != version(expected)) {
    throw ResultError(
        fmt::format("format version {}, expected {}", version(found), version(expected)));
  }
  if (found != expected)
    throw ResultError("its content does not fit its checksum: it has been altered");
  return image;
}

// A '/' parts groups in HDF5, so a link's name has "%2F" for it; the attribute "name" has the name
// itself.
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

// The same for the texts of the root; the series and the maps have loops of their own.
constexpr std::pair<const char*, std::string RunResult::*> root_fields[] = {
    {"case_name", &RunResult::case_name},
    {"run_name", &RunResult::run_name},
    {"solver", &RunResult::solver},
    {"key", &RunResult::key}};

void write_series(hid_t parent, const TimeSeries& series) {
  if (series.name.empty()) throw ResultError("a series without a name");
  if (series.time.size() != series.value.size()) {
    throw ResultError(fmt::format("series {} has {} times and {} values, expected as many of both",
                                  series.name, series.time.size(), series.value.size()));
  }
  const Handle group = hdf5::create_group(parent, link_name(series.name));
  hdf5::write_attribute(group, "name", series.name);
  hdf5::write_attribute(hdf5::write_numbers(group, "time", series.time), "unit", "s");
  hdf5::write_attribute(hdf5::write_numbers(group, "value", series.value), "unit", series.unit);
}

TimeSeries read_series(hid_t parent, const std::string& link) {
  const Handle group = hdf5::open_group(parent, link);
  const Handle value(H5Dopen2(group, "value", H5P_DEFAULT), H5Dclose, "open the data set value");
  return {.name = hdf5::read_text_attribute(group, "name"),
          .unit = hdf5::read_text_attribute(value, "unit"),
          .time = hdf5::read_numbers(group, "time"),
          .value = hdf5::read_numbers(group, "value")};
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

void write_snapshot(hid_t parent, const std::string& name, const FieldSnapshot& snapshot) {
  const Handle group = hdf5::create_group(parent, name);
  for (const auto& [number, field] : snapshot_numbers)
    hdf5::write_attribute(group, number, snapshot.*field);
  for (const auto& [field, unit, values] : snapshot_fields) {
    if ((snapshot.*values).size() != snapshot.x.size())
      throw ResultError(fmt::format("snapshot {} has {} places and {} values of {}", name,
                                    snapshot.x.size(), (snapshot.*values).size(), field));
    hdf5::write_attribute(hdf5::write_numbers(group, field, snapshot.*values), "unit", unit);
  }
}

FieldSnapshot read_snapshot(hid_t parent, const std::string& name) {
  const Handle group = hdf5::open_group(parent, name);
  FieldSnapshot snapshot{};
  for (const auto& [number, field] : snapshot_numbers)
    snapshot.*field = hdf5::read_number_attribute(group, number);
  for (const auto& [field, unit, values] : snapshot_fields)
    snapshot.*values = hdf5::read_numbers(group, field);
  return snapshot;
}

void write_content(const RunResult& result, hid_t file) {
  hdf5::write_attribute(file, "format", "slosh result");
  hdf5::write_attribute(file, "format_version", format_version);
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
  result.case_text = hdf5::read_texts(file, "case_text").at(0);
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

// Files in memory: what is hashed is what is parsed, and the paths and locks stay the system's
// affair.
Handle memory_access() {
  constexpr std::size_t increment = 1 << 20;  // [byte], by which HDF5 grows its buffer
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make a file's properties");
  checked(H5Pset_fapl_core(access, increment, /*backing_store=*/false), "keep a file in memory");
  return access;
}

std::string image_of(const RunResult& result) {
  const Handle file(H5Fcreate("result", H5F_ACC_TRUNC, H5P_DEFAULT, memory_access()), H5Fclose,
                    "make a file in memory");
  write_content(result, file);
  checked(H5Fflush(file, H5F_SCOPE_GLOBAL), "complete a file in memory");
  const ssize_t size = checked(H5Fget_file_image(file, nullptr, 0), "measure a file in memory");
  std::string image(static_cast<std::size_t>(size), '\0');
  checked(H5Fget_file_image(file, image.data(), image.size()), "copy a file in memory");
  return image;
}

RunResult result_of(std::string_view image) {
  const Handle access = memory_access();
  checked(
      H5Pset_file_image(access, const_cast<char*>(image.data()), image.size()),  // HDF5 copies it
      "take an image");
  const Handle file(H5Fopen("result", H5F_ACC_RDONLY, access), H5Fclose, "open the image");
  return read_content(file);
}

}  // namespace

const TimeSeries& RunResult::at(const std::string& series_name) const {
  for (const TimeSeries& one : series) {
    if (one.name == series_name) return one;
  }
  throw ResultError(fmt::format("the result of run {} of case {} has no series {}", run_name,
                                case_name, series_name));
}

void write_result(const RunResult& result, const std::filesystem::path& file) try {
  const hdf5::QuietErrors quiet;
  std::string bytes = image_of(result);
  bytes += seal(bytes);
  replace_file(file, bytes, Durability::power_loss);
} catch (const std::runtime_error& error) {
  throw ResultError(
      fmt::format("cannot write the result file {}: {}", file.string(), error.what()));
}

RunResult read_result(const std::filesystem::path& file) try {
  const hdf5::QuietErrors quiet;
  const std::string bytes = read_bytes(file);
  return result_of(unsealed(bytes));
} catch (const std::runtime_error& error) {
  throw ResultError(fmt::format("cannot use the result file {}: {}", file.string(), error.what()));
}

}  // namespace slosh
