#include "verification/files/foreign/self_contained.hpp"

#include <fmt/format.h>

#include <set>
#include <string>
#include <vector>

#include "verification/files/hdf5_handles.hpp"

namespace slosh::hdf5 {
namespace {

constexpr int deepest = 64;

struct Link {
  std::string name;
  H5L_type_t type;
};

// No exception may pass through HDF5's iteration, so the links are looked at afterwards.
std::vector<Link> links_in(hid_t group) {
  std::vector<Link> links;
  const auto append = [](hid_t, const char* name, const H5L_info_t* info, void* list) -> herr_t {
    static_cast<std::vector<Link>*>(list)->push_back({name, info->type});
    return 0;
  };
  checked(H5Literate(group, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, append, &links),
          "list a group");
  return links;
}

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
  throw Hdf5Error(fmt::format("{}: {}: expected a file that holds all its data", path, what));
}

// The name of a file that HDF5 keeps for a data set; `ask` is given a place and its size.
template <class Ask>
std::string name_from(const Ask& ask) {
  char name[256] = "";
  ask(name, sizeof name - 1);
  return name;
}

void require_own_values(hid_t data_set, const std::string& path) {
  const Handle made(H5Dget_create_plist(data_set), H5Pclose, "ask where the values lie");
  if (checked(H5Pget_layout(made), "ask where the values lie") == H5D_VIRTUAL)
    refuse(path, "its values lie in other data sets, such as those of " +
                     name_from([&](char* name, std::size_t size) {
                       H5Pget_virtual_filename(made, 0, name, size);
                     }));
  if (checked(H5Pget_external_count(made), "ask where the values lie") > 0)
    refuse(path, "its values lie in " + name_from([&](char* name, std::size_t size) {
                   off_t offset;
                   hsize_t length;
                   H5Pget_external(made, 0, size, name, &offset, &length);
                 }));
  for (int i = 0; i < H5Pget_nfilters(made); ++i) {
    std::size_t values = 0;
    const H5Z_filter_t filter = H5Pget_filter2(made, static_cast<unsigned>(i), nullptr, &values,
                                               nullptr, 0, nullptr, nullptr);
    if (filter < 0 || filter > H5Z_FILTER_SCALEOFFSET)
      refuse(path, fmt::format("its values need filter {}, a plugin", filter));
  }
}

class Walk {
 public:
  void group(hid_t group, const std::string& path, int depth) {
    if (depth > deepest)
      throw Hdf5Error(fmt::format("its groups are more than {} deep in one another", deepest));
    for (const auto& [name, type] : links_in(group)) {
      const std::string place = path + "/" + name;
      if (type == H5L_TYPE_EXTERNAL) refuse(place, "a link to another file");
      if (type != H5L_TYPE_HARD && type != H5L_TYPE_SOFT)
        refuse(place, fmt::format("a link of kind {}", static_cast<int>(type)));
      // A soft link is a path in this file, whose every link is looked at.
      if (type == H5L_TYPE_HARD) object(group, name, place, depth);
    }
  }

 private:
  void object(hid_t group, const std::string& name, const std::string& place, int depth) {
    const Handle found(H5Oopen(group, name.c_str(), H5P_DEFAULT), H5Oclose, "open " + place);
    H5O_info_t info;
    checked(H5Oget_info(found, &info), "look at " + place);
    if (!seen_.insert(info.addr).second) return;
    if (info.type == H5O_TYPE_GROUP) this->group(found, place, depth + 1);
    if (info.type == H5O_TYPE_DATASET) require_own_values(found, place);
  }

  std::set<haddr_t> seen_;
};

}  // namespace

void require_self_contained(hid_t file) {
  checked(H5PLset_loading_state(0), "do without plugins");
  const Handle root(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose, "open the root group");
  Walk().group(root, "", 0);
}

}  // namespace slosh::hdf5
