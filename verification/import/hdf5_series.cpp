// Series in HDF5 files: data sets of one row or column, named by their paths, with the unit in an
// attribute "unit" or "units"; or a group with the data sets "time" and "value", as in a result
// file of this project.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "verification/files/content_hash.hpp"
#include "verification/files/foreign/guarded_reading.hpp"
#include "verification/files/foreign/plain_file.hpp"
#include "verification/files/foreign/self_contained.hpp"
#include "verification/files/hdf5_handles.hpp"
#include "verification/import/file_formats.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/input/nearest_name.hpp"
#include "verification/input/tables/table_reader.hpp"
#include "verification/input/units.hpp"

namespace slosh {
namespace {

using hdf5::Handle;

std::vector<std::string> data_sets_in(hid_t file) {
  std::vector<std::string> names;
  const auto append = [](hid_t, const char* name, const H5O_info_t* info, void* list) -> herr_t {
    if (info->type == H5O_TYPE_DATASET)
      static_cast<std::vector<std::string>*>(list)->push_back(std::string("/") + name);
    return 0;
  };
  hdf5::checked(H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_NATIVE, append, &names, H5O_INFO_BASIC),
                "list the data sets");
  return names;
}

// Without the name of the file, which read_hdf5_series() puts before it.
[[noreturn]] void refuse(std::string_view key, std::string_view value,
                         const std::string& expected) {
  throw std::runtime_error(fmt::format("{} = {}: expected {}", key, value, expected));
}

// In the file's own type: HDF5 turns no ASCII of variable length into UTF-8. A text of fixed length
// fills its length with blanks or null characters.
std::string read_text(hid_t attribute, hid_t type) {
  std::string text(H5Tget_size(type), '\0');
  if (H5Tis_variable_str(type) > 0) {
    char* of_any_length = nullptr;
    hdf5::checked(H5Aread(attribute, type, &of_any_length), "read a unit");
    if (of_any_length) text = of_any_length;
    H5free_memory(of_any_length);
  } else {
    hdf5::checked(H5Aread(attribute, type, text.data()), "read a unit");
  }
  return std::string(trimmed(text.substr(0, text.find('\0'))));
}

std::string unit_of_data_set(hid_t data_set, std::string_view path) {
  for (const char* name : {"unit", "units"}) {
    if (H5Aexists(data_set, name) <= 0) continue;
    const Handle attribute(H5Aopen(data_set, name, H5P_DEFAULT), H5Aclose, "open a unit");
    const Handle type(H5Aget_type(attribute), H5Tclose, "get the type of a unit");
    const Handle space(H5Aget_space(attribute), H5Sclose, "get the shape of a unit");
    if (H5Tget_class(type) != H5T_STRING || H5Sget_simple_extent_npoints(space) != 1)
      refuse(fmt::format("{}, attribute {}", path, name), "no single text", "a unit");
    return read_text(attribute, type);
  }
  return "";
}

// Whether one dimension at most has more than one value.
bool is_row_or_column(hid_t data_set, std::string& shape) {
  const Handle space(H5Dget_space(data_set), H5Sclose, "get a data set's shape");
  std::vector<hsize_t> sizes(static_cast<std::size_t>(
      hdf5::checked(H5Sget_simple_extent_ndims(space), "get a data set's shape")));
  H5Sget_simple_extent_dims(space, sizes.data(), nullptr);
  shape = fmt::format("{}", fmt::join(sizes, " x "));
  return !sizes.empty() &&
         std::count_if(sizes.begin(), sizes.end(), [](hsize_t size) { return size != 1; }) <= 1;
}

// Reads the numbers and the unit of a data set of one row or column.
void read_data_set(hid_t file, std::string_view key, const std::string& path,
                   std::vector<double>& values, std::string& unit) {
  const hid_t found = H5Dopen2(file, path.c_str(), H5P_DEFAULT);
  if (found < 0)
    refuse(key, path,
           fmt::format("a data set of the file; nearest: {}",
                       fmt::join(nearest_names(path, data_sets_in(file), 3), ", ")));
  const Handle data_set(found, H5Dclose, "open a data set");
  std::string shape;
  if (!is_row_or_column(data_set, shape))
    refuse(key, path,
           fmt::format("a data set of one row or column, not of {}",
                       shape.empty() ? "one value" : shape));
  values = hdf5::read_numbers(file, path);
  unit = unit_spelt(unit_of_data_set(data_set, path));
}

RawSeries read_series(const SeriesSource& source) {
  const hid_t opened = H5Fopen(source.file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (opened < 0) refuse("format", "hdf5", "a whole HDF5 file");
  const Handle file(opened, H5Fclose, "open the file");
  hdf5::require_self_contained(file);
  const bool is_group = source.time_column.empty();
  RawSeries series;
  read_data_set(file, is_group ? "column" : "time_column",
                is_group ? source.column + "/time" : source.time_column, series.time,
                series.time_unit);
  read_data_set(file, "column", is_group ? source.column + "/value" : source.column, series.value,
                series.unit);
  return series;
}

}  // namespace

RawSeries read_hdf5_series(const SeriesSource& source) try {
  const hdf5::QuietErrors quiet;
  if (!is_plain_file(source.file)) refuse("file", "no file of a disk", "one");
  RawSeries series;
  read_guarded(stored_bytes(source.file), [&] { series = read_series(source); });
  return series;
} catch (const std::runtime_error& error) {
  throw CaseFileError(source.file.string() + ": " + error.what());
}

}  // namespace slosh
