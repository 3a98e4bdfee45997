#include "verification/files/hdf5_handles.hpp"

#include <algorithm>

namespace slosh::hdf5 {
namespace {

herr_t keep_first(unsigned, const H5E_error2_t* error, void* text) {
  auto& first = *static_cast<std::string*>(text);
  if (first.empty() && error->desc) first = error->desc;
  return 0;
}

Handle text_type() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "make the text type");
  checked(H5Tset_size(type, H5T_VARIABLE), "make the text type");
  checked(H5Tset_cset(type, H5T_CSET_UTF8), "make the text type");
  return type;
}

Handle scalar_space() { return {H5Screate(H5S_SCALAR), H5Sclose, "make a scalar space"}; }

Handle create_attribute(hid_t object, const std::string& name, hid_t type) {
  return {H5Acreate2(object, name.c_str(), type, scalar_space(), H5P_DEFAULT, H5P_DEFAULT),
          H5Aclose, "create the attribute " + name};
}

Handle open_attribute(hid_t object, const std::string& name) {
  return {H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, "open the attribute " + name};
}

Handle open_dataset(hid_t parent, const std::string& name) {
  return {H5Dopen2(parent, name.c_str(), H5P_DEFAULT), H5Dclose, "open the data set " + name};
}

// The most values that may be stored in fewer bytes than their number, by compression.
constexpr hsize_t most_compressed = 10'000'000;

bool is_compressed(hid_t dataset) {
  const Handle list(H5Dget_create_plist(dataset), H5Pclose, "get a data set's properties");
  return H5Pget_nfilters(list) > 0;
}

// The number of values. Throws Hdf5Error where the file stores fewer bytes than that and they are
// not compressed, or are too many: it may declare a shape of any size without storing it.
std::size_t point_count(hid_t dataset, const std::string& name) {
  const Handle space(H5Dget_space(dataset), H5Sclose, "get a data set's shape");
  const auto count =
      static_cast<hsize_t>(checked(H5Sget_simple_extent_npoints(space), "get a data set's shape"));
  const hsize_t stored = H5Dget_storage_size(dataset);
  if (count > stored && !(stored > 0 && count <= most_compressed && is_compressed(dataset)))
    throw Hdf5Error("the data set " + name + " has a shape of " + std::to_string(count) +
                    " values, of which " + std::to_string(stored) + " bytes are stored");
  return static_cast<std::size_t>(count);
}

// Throws Hdf5Error unless the attribute has one value: HDF5 would write all of them to the buffer.
void require_scalar(hid_t attribute, const std::string& name) {
  const Handle space(H5Aget_space(attribute), H5Sclose, "get an attribute's shape");
  const hssize_t count = checked(H5Sget_simple_extent_npoints(space), "get an attribute's shape");
  if (count != 1)
    throw Hdf5Error("the attribute " + name + " has " + std::to_string(count) +
                    " values, expected one");
}

// Copies and frees a string that HDF5 allocated; a null pointer gives the empty string.
std::string take(char* text) {
  std::string copy = text ? text : "";
  H5free_memory(text);
  return copy;
}

}  // namespace

hid_t checked(hid_t status, const std::string& action) {
  if (status >= 0) return status;
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &reason);
  throw Hdf5Error("HDF5 cannot " + action + (reason.empty() ? "" : ": " + reason));
}

QuietErrors::QuietErrors() {
  H5Eget_auto2(H5E_DEFAULT, &print_, &print_data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

QuietErrors::~QuietErrors() { H5Eset_auto2(H5E_DEFAULT, print_, print_data_); }

Handle memory_access() {
  constexpr std::size_t increment = 1 << 20;  // [byte], by which HDF5 grows its buffer
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make a file's properties");
  checked(H5Pset_fapl_core(access, increment, /*backing_store=*/false), "keep a file in memory");
  return access;
}

std::string image_of(const std::function<void(hid_t)>& write) {
  const Handle file(H5Fcreate("image", H5F_ACC_TRUNC, H5P_DEFAULT, memory_access()), H5Fclose,
                    "make a file in memory");
  write(file);
  checked(H5Fflush(file, H5F_SCOPE_GLOBAL), "complete a file in memory");
  const ssize_t size = checked(H5Fget_file_image(file, nullptr, 0), "measure a file in memory");
  std::string image(static_cast<std::size_t>(size), '\0');
  checked(H5Fget_file_image(file, image.data(), image.size()), "copy a file in memory");
  return image;
}

Handle create_group(hid_t parent, const std::string& name) {
  const Handle properties(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, "make a group's properties");
  checked(H5Pset_link_creation_order(properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED),
          "keep the order of a group");
  return {H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, properties, H5P_DEFAULT), H5Gclose,
          "create the group " + name};
}

Handle open_group(hid_t parent, const std::string& name) {
  return {H5Gopen2(parent, name.c_str(), H5P_DEFAULT), H5Gclose, "open the group " + name};
}

std::vector<std::string> member_names(hid_t group) {
  H5G_info_t info;
  checked(H5Gget_info(group, &info), "list a group");
  std::vector<std::string> names;
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    const auto name_at = [&](char* buffer, std::size_t size) {
      return checked(H5Lget_name_by_idx(group, ".", H5_INDEX_CRT_ORDER, H5_ITER_INC, i, buffer,
                                        size, H5P_DEFAULT),
                     "list a group");
    };
    std::string name(static_cast<std::size_t>(name_at(nullptr, 0)), '\0');
    name_at(name.data(), name.size() + 1);
    names.push_back(name);
  }
  return names;
}

void write_attribute(hid_t object, const std::string& name, const std::string& text) {
  const Handle type = text_type();
  const Handle attribute = create_attribute(object, name, type);
  const char* pointer = text.c_str();
  checked(H5Awrite(attribute, type, &pointer), "write the attribute " + name);
}

void write_attribute(hid_t object, const std::string& name, double value) {
  const Handle attribute = create_attribute(object, name, H5T_IEEE_F64LE);
  checked(H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value), "write the attribute " + name);
}

std::string read_text_attribute(hid_t object, const std::string& name) {
  const Handle attribute = open_attribute(object, name);
  require_scalar(attribute, name);
  char* text = nullptr;
  checked(H5Aread(attribute, text_type(), &text), "read the attribute " + name);
  return take(text);
}

double read_number_attribute(hid_t object, const std::string& name) {
  const Handle attribute = open_attribute(object, name);
  require_scalar(attribute, name);
  double value;
  checked(H5Aread(attribute, H5T_NATIVE_DOUBLE, &value), "read the attribute " + name);
  return value;
}

std::vector<std::string> attribute_names(hid_t object) {
  std::vector<std::string> names;
  const auto append = [](hid_t, const char* name, const H5A_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  checked(H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, append, &names),
          "list the attributes");
  return names;
}

Handle write_numbers(hid_t parent, const std::string& name, const std::vector<double>& values,
                     int columns) {
  const int rank = columns > 1 ? 2 : 1;
  const hsize_t shape[] = {values.size() / columns, static_cast<hsize_t>(columns)};
  // Filters need chunks, and an empty data set may have a chunk only if it is extensible.
  const hsize_t chunk[] = {std::max<hsize_t>(shape[0], 1), shape[1]};
  const hsize_t largest[] = {H5S_UNLIMITED, shape[1]};
  const Handle space(H5Screate_simple(rank, shape, largest), H5Sclose,
                     "shape the data set " + name);
  const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "make a data set's properties");
  checked(H5Pset_chunk(properties, rank, chunk), "chunk the data set " + name);
  checked(H5Pset_fletcher32(properties), "guard the data set " + name);
  Handle dataset(
      H5Dcreate2(parent, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, properties, H5P_DEFAULT),
      H5Dclose, "create the data set " + name);
  checked(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
          "write the data set " + name);
  return dataset;
}

std::vector<double> read_numbers(hid_t parent, const std::string& name) {
  const Handle dataset = open_dataset(parent, name);
  std::vector<double> values(point_count(dataset, name));
  checked(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
          "read the data set " + name);
  return values;
}

void write_texts(hid_t parent, const std::string& name, const std::vector<std::string>& texts) {
  const hsize_t count = texts.size();
  const Handle type = text_type();
  const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose, "shape the data set " + name);
  const Handle dataset(
      H5Dcreate2(parent, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Dclose, "create the data set " + name);
  std::vector<const char*> pointers;
  for (const std::string& text : texts) pointers.push_back(text.c_str());
  checked(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()),
          "write the data set " + name);
}

std::vector<std::string> read_texts(hid_t parent, const std::string& name) {
  const Handle dataset = open_dataset(parent, name);
  std::vector<char*> pointers(point_count(dataset, name));
  checked(H5Dread(dataset, text_type(), H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()),
          "read the data set " + name);
  std::vector<std::string> texts;
  for (char* pointer : pointers) texts.push_back(take(pointer));
  return texts;
}

}  // namespace slosh::hdf5
