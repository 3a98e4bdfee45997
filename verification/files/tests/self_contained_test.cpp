// A file of HDF5 that leads into another file is refused before a value is read; one that only uses
// what HDF5 offers within a file is not.
#include "verification/files/foreign/self_contained.hpp"

#include <gtest/gtest.h>

#include "verification/tests/hdf5_attacks.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::self_contained_test {
namespace {

namespace fs = std::filesystem;

class SelfContained : public ::testing::Test {
 protected:
  SelfContained() { write_secrets(directory_.path()); }

  // What is said of a file that `write` filled.
  std::string refusal(const std::function<void(hid_t)>& write) const {
    const hdf5::QuietErrors quiet;
    const fs::path file = directory_.path() / "a.h5";
    {
      const hdf5::Handle root(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT),
                              H5Fclose, "make a file");
      write(root);
    }
    const hdf5::Handle root(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "open");
    return message_of<hdf5::Hdf5Error>([&] { hdf5::require_self_contained(root); });
  }

  const TemporaryDirectory directory_;
};

TEST_F(SelfContained, RefusesEveryWayIntoAnotherFile) {
  for (const Hdf5Attack& attack : hdf5_attacks(directory_.path()))
    EXPECT_TRUE(holds(refusal([&](hid_t root) { attack.plant(root, "value"); }), attack.refusal))
        << attack.name;
}

TEST_F(SelfContained, TakesLinksLoopsAndFiltersWithinTheFile) {
  EXPECT_EQ(
      refusal([](hid_t root) {
        const hdf5::Handle group = hdf5::create_group(root, "group");
        hdf5::write_numbers(group, "value", {1, 2, 3});
        hdf5::checked(H5Lcreate_hard(root, "/", group, "up", H5P_DEFAULT, H5P_DEFAULT), "");
        hdf5::checked(H5Lcreate_hard(group, "value", root, "also", H5P_DEFAULT, H5P_DEFAULT), "");
        hdf5::checked(H5Lcreate_soft("/group", root, "soft", H5P_DEFAULT, H5P_DEFAULT), "");
        hdf5::checked(H5Lcreate_soft("/none", root, "dangling", H5P_DEFAULT, H5P_DEFAULT), "");
        const hdf5::Handle properties = made_with();
        hdf5::checked(H5Pset_chunk(properties, 1, &secret_length), "");
        hdf5::checked(H5Pset_shuffle(properties), "");
        hdf5::checked(H5Pset_deflate(properties, 5), "");
        add_data_set(root, "packed", properties);
      }),
      "");
}

}  // namespace
}  // namespace slosh::self_contained_test
