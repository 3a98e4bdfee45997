// Files of HDF5 that lead into other files, made by the library itself: each puts the way to a
// secret at /value, or where another says.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "verification/files/hdf5_handles.hpp"

namespace slosh {

constexpr hsize_t secret_length = 12;
constexpr double secret_number = 41.75;

inline hdf5::Handle secret_shape() {
  return {H5Screate_simple(1, &secret_length, nullptr), H5Sclose, "shape"};
}

inline hdf5::Handle made_with() { return {H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "properties"}; }

inline void add_data_set(hid_t root, const char* name, hid_t properties) {
  const hdf5::Handle data_set(
      H5Dcreate2(root, name, H5T_IEEE_F64LE, secret_shape(), H5P_DEFAULT, properties, H5P_DEFAULT),
      H5Dclose, "create");
}

// The secret as raw numbers in DIRECTORY/secret.bin and as a data set in DIRECTORY/secret.h5.
inline void write_secrets(const std::filesystem::path& directory) {
  const std::vector<double> numbers(secret_length, secret_number);
  std::ofstream(directory / "secret.bin", std::ios::binary)
      .write(reinterpret_cast<const char*>(numbers.data()),
             static_cast<std::streamsize>(numbers.size() * sizeof(double)));
  const hdf5::Handle file(
      H5Fcreate((directory / "secret.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT),
      H5Fclose, "make a file");
  hdf5::write_numbers(file, "value", numbers);
}

struct Hdf5Attack {
  const char *name, *refusal;
  // Plants the way at `name` of the opened root.
  std::function<void(hid_t root, const char* name)> plant;
};

inline void add_link_of_a_program(hid_t root, const char* name) {
  const auto follow = [](const char*, hid_t, const void*, std::size_t, hid_t, hid_t) -> hid_t {
    return -1;
  };
  const H5L_class_t kind{H5L_LINK_CLASS_T_VERS,
                         static_cast<H5L_type_t>(100),
                         "way",
                         nullptr,
                         nullptr,
                         nullptr,
                         follow,
                         nullptr,
                         nullptr};
  hdf5::checked(H5Lregister(&kind), "register");
  hdf5::checked(H5Lcreate_ud(root, name, kind.id, "x", 1, H5P_DEFAULT, H5P_DEFAULT), "link");
  hdf5::checked(H5Lunregister(kind.id), "unregister");
}

inline void add_filtered(hid_t root, const char* name) {
  const auto pass = [](unsigned, std::size_t, const unsigned*, std::size_t count, std::size_t*,
                       void**) { return count; };
  const H5Z_class2_t filter{H5Z_CLASS_T_VERS, 32000, 1, 1, "plugin", nullptr, nullptr, pass};
  hdf5::checked(H5Zregister(&filter), "register");
  {
    const hdf5::Handle properties = made_with();
    hdf5::checked(H5Pset_chunk(properties, 1, &secret_length), "chunk");
    hdf5::checked(H5Pset_filter(properties, filter.id, 0, 0, nullptr), "filter");
    add_data_set(root, name, properties);
  }
  hdf5::checked(H5Fflush(root, H5F_SCOPE_LOCAL), "flush");
  hdf5::checked(H5Zunregister(filter.id), "unregister");
}

inline std::vector<Hdf5Attack> hdf5_attacks(const std::filesystem::path& directory) {
  const std::string raw = directory / "secret.bin", whole = directory / "secret.h5";
  const auto external = [](const std::string& file) {
    return [file](hid_t root, const char* name) {
      const hdf5::Handle properties = made_with();
      hdf5::checked(H5Pset_external(properties, file.c_str(), 0, H5F_UNLIMITED), "name a file");
      add_data_set(root, name, properties);
    };
  };
  const auto is_virtual = [](const std::string& file) {
    return [file](hid_t root, const char* name) {
      const hdf5::Handle properties = made_with(), shape = secret_shape();
      hdf5::checked(H5Pset_virtual(properties, shape, file.c_str(), "value", shape), "map");
      add_data_set(root, name, properties);
    };
  };
  const auto link = [](const std::string& file, const char* object) {
    return [file, object](hid_t root, const char* name) {
      hdf5::checked(H5Lcreate_external(file.c_str(), object, root, name, H5P_DEFAULT, H5P_DEFAULT),
                    "link");
    };
  };
  return {
      {"external storage", "its values lie in ", external(raw)},
      {"external storage of a relative name", "its values lie in ", external("secret.bin")},
      {"external storage in the environment", "its values lie in ", external("/proc/self/environ")},
      {"a virtual data set", "its values lie in other data sets", is_virtual(whole)},
      {"a virtual data set of this file", "its values lie in other data sets", is_virtual(".")},
      {"an external link", "a link to another file", link(whole, "/value")},
      {"an external link that leads nowhere", "a link to another file", link("/none", "/value")},
      {"a soft link through an external one", "a link to another file",
       [=](hid_t root, const char* name) {
         link(whole, "/")(root, "away");
         hdf5::checked(H5Lcreate_soft("/away/value", root, name, H5P_DEFAULT, H5P_DEFAULT), "link");
       }},
      {"an external link in a group beside", "a link to another file",
       [=](hid_t root, const char*) {
         const hdf5::Handle group = hdf5::create_group(root, "beside");
         link(whole, "/value")(group, "way");
       }},
      {"a link of a kind that a program defines", "a link of kind 100", add_link_of_a_program},
      {"a filter that is a plugin", "its values need filter 32000, a plugin", add_filtered},
      {"groups 20,000 deep in one another", "its groups are more than 64 deep",
       [](hid_t root, const char*) {
         std::vector<hdf5::Handle> groups;
         for (int i = 0; i < 20000; ++i) {
           hdf5::Handle inner = hdf5::create_group(i == 0 ? root : hid_t(groups.back()), "g");
           groups.clear();
           groups.push_back(std::move(inner));
         }
       }},
  };
}

}  // namespace slosh
