#include "verification/fuzz/hdf5_edits.hpp"

#include <array>
#include <cstdint>
#include <vector>

#include "verification/files/hdf5_handles.hpp"

namespace slosh {
namespace {

using hdf5::Handle;

std::vector<std::string> paths_in(hid_t file) {
  std::vector<std::string> paths;
  const auto append = [](hid_t, const char* path, const H5O_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(path);
    return 0;
  };
  hdf5::checked(H5Ovisit(file, H5_INDEX_NAME, H5_ITER_INC, append, &paths), "visit");
  return paths;
}

Handle any_type(ByteChoices& choices) {
  const auto copy = [](hid_t type) { return Handle(H5Tcopy(type), H5Tclose, "copy a type"); };
  switch (choices.number(7)) {
    case 0:
      return copy(H5T_IEEE_F64LE);
    case 1:
      return copy(H5T_IEEE_F32BE);
    case 2:
      return copy(H5T_STD_I64BE);
    case 3:
      return copy(H5T_STD_U8LE);
    case 4:
      return copy(H5T_STD_REF_OBJ);
    case 5: {  // text of a fixed length, without an end
      Handle text = copy(H5T_C_S1);
      H5Tset_size(text, 3);
      H5Tset_strpad(text, H5T_STR_SPACEPAD);
      return text;
    }
    case 6:
      return Handle(H5Tvlen_create(H5T_IEEE_F64LE), H5Tclose, "make a type");
    default: {  // texts of any length; where nothing is written, null ones
      Handle text = copy(H5T_C_S1);
      H5Tset_size(text, H5T_VARIABLE);
      return text;
    }
  }
}

Handle any_space(ByteChoices& choices) {
  if (choices.flag()) {
    const bool null = choices.flag();
    return {H5Screate(null ? H5S_NULL : H5S_SCALAR), H5Sclose, "make a space"};
  }
  const int rank = 1 + static_cast<int>(choices.number(2));
  std::array<hsize_t, 3> shape{};
  for (hsize_t& extent : shape) extent = choices.number(5);
  if (choices.flag()) shape[0] <<= choices.number(58);
  return {H5Screate_simple(rank, shape.data(), nullptr), H5Sclose, "make a space"};
}

// Written with the bytes at hand where these are plain and not many; else left as HDF5 makes it.
template <class Write>
void fill(hid_t type, hid_t space, ByteChoices& choices, Write write) {
  constexpr hssize_t most = 200;
  const hssize_t count = H5Sget_simple_extent_npoints(space);
  const bool plain = H5Tget_class(type) != H5T_VLEN && !H5Tis_variable_str(type);
  if (!plain || count <= 0 || count > most || choices.flag()) return;
  auto bytes = choices.bytes(static_cast<std::size_t>(count) * H5Tget_size(type));
  bytes.resize(static_cast<std::size_t>(count) * H5Tget_size(type));
  write(bytes.data());
}

void put_data_set(hid_t file, const std::string& path, ByteChoices& choices) {
  const Handle type = any_type(choices), space = any_space(choices);
  const Handle data_set(
      H5Dcreate2(file, path.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose,
      "make a data set");
  fill(type, space, choices,
       [&](const void* bytes) { H5Dwrite(data_set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes); });
}

void put_attribute(hid_t object, const std::string& name, ByteChoices& choices) {
  const Handle type = any_type(choices), space = any_space(choices);
  const Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose, "make an attribute");
  fill(type, space, choices, [&](const void* bytes) { H5Awrite(attribute, type, bytes); });
}

void edit_attribute(hid_t file, const std::string& path, ByteChoices& choices) {
  const Handle object(H5Oopen(file, path.c_str(), H5P_DEFAULT), H5Oclose, "open an object");
  std::vector<std::string> names = hdf5::attribute_names(object);
  names.push_back(choices.text(8));
  const std::string name = names[choices.number(names.size() - 1)];
  H5Adelete(object, name.c_str());
  if (choices.flag()) put_attribute(object, name, choices);
}

void edit_link(hid_t file, std::string path, const std::string& other, ByteChoices& choices) {
  if (choices.flag())
    path += "/" + choices.text(8);
  else
    H5Ldelete(file, path.c_str(), H5P_DEFAULT);
  switch (choices.number(4)) {
    case 0:
      put_data_set(file, path, choices);
      break;
    case 1:
      hdf5::create_group(file, path);
      break;
    case 2:
      H5Lcreate_soft(other.c_str(), file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      break;
    case 3:
      H5Lcreate_hard(file, other.c_str(), file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      break;
    default:
      break;
  }
}

void edit(hid_t file, ByteChoices& choices) try {
  const std::vector<std::string> paths = paths_in(file);
  const auto any_path = [&] { return paths[choices.number(paths.size() - 1)]; };
  const std::string path = any_path();
  if (choices.flag())
    edit_attribute(file, path, choices);
  else
    edit_link(file, path, any_path(), choices);
} catch (const hdf5::Hdf5Error&) {  // an edit that HDF5 refuses is none
}

}  // namespace

std::string edited(const std::string& image, ByteChoices& choices) {
  constexpr int most_edits = 20;
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make a file's properties");
  hdf5::checked(H5Pset_fapl_core(access, 1 << 16, false), "keep a file in memory");
  hdf5::checked(H5Pset_file_image(access, const_cast<char*>(image.data()), image.size()),
                "take an image");
  const Handle file(H5Fopen("image", H5F_ACC_RDWR, access), H5Fclose, "open the image");
  for (int i = 0; i < most_edits && choices.remaining() > 0; ++i) edit(file, choices);
  hdf5::checked(H5Fflush(file, H5F_SCOPE_GLOBAL), "complete a file in memory");
  std::string bytes(
      static_cast<std::size_t>(hdf5::checked(H5Fget_file_image(file, nullptr, 0), "measure")),
      '\0');
  hdf5::checked(H5Fget_file_image(file, bytes.data(), bytes.size()), "copy");
  return bytes;
}

}  // namespace slosh
