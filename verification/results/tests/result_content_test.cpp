// Results whose seal fits and whose HDF5 content is not what a result holds, as another program may
// write them.
#include <gtest/gtest.h>

#include <fstream>
#include <functional>

#include "verification/files/content_hash.hpp"
#include "verification/files/hdf5_handles.hpp"
#include "verification/results/result_file.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::result_content_test {
namespace {

using hdf5::Handle;

class ResultContent : public ::testing::Test {
 protected:
  // Changes the content of a sound result and seals it afresh; what reading it then says.
  std::string refusal(const std::function<void(hid_t)>& edit) {
    RunResult result{};
    result.series = {{"elevation", "m", {0, 1, 2}, {0, 1, 2}}};
    result.snapshots = {{1, 1, 1, {1}, {1}, {1}, {1}, {1}}};
    write_result(result, file_);
    {
      const hdf5::QuietErrors quiet;
      const Handle root(H5Fopen(file_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose, "open");
      edit(root);
    }
    const std::string image = read_bytes(file_);
    std::ofstream(file_, std::ios::binary | std::ios::app)
        << "\nslosh result 002 " << content_hash(image) << "\n";
    try {
      read_result(file_);
    } catch (const ResultError& error) {
      return error.what();
    }
    return "";
  }

  static void expect_in(const std::string& words, const std::string& part) {
    EXPECT_TRUE(holds(words, part));
  }

  TemporaryDirectory directory_;
  const std::filesystem::path file_ = directory_.path() / "a.h5";
};

Handle data_set(hid_t parent, const char* name, hid_t type, std::vector<hsize_t> shape) {
  const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                     H5Sclose, "shape");
  return {H5Dcreate2(parent, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose,
          "create"};
}

void remove(hid_t parent, const char* name) {
  hdf5::checked(H5Ldelete(parent, name, H5P_DEFAULT), "remove");
}

TEST_F(ResultContent, IsTakenAsItWasWritten) {
  EXPECT_EQ(refusal([](hid_t) {}), "");
}

TEST_F(ResultContent, IsRefusedWhereSomethingIsMissing) {
  for (const char* name :
       {"case_text", "active_terms", "cost", "series/elevation/time", "snapshots/00000/velocity_z"})
    expect_in(refusal([&](hid_t root) { remove(root, name); }), "HDF5 cannot open");
}

TEST_F(ResultContent, IsRefusedWithAnAttributeOfSeveralValues) {
  for (const char* name : {"wall_time_s", "steps"})
    expect_in(refusal([&](hid_t root) {
                const Handle cost = hdf5::open_group(root, "cost");
                hdf5::checked(H5Adelete(cost, name), "remove");
                const hsize_t many = 1000;
                const Handle space(H5Screate_simple(1, &many, nullptr), H5Sclose, "shape");
                const Handle attribute(
                    H5Acreate2(cost, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT),
                    H5Aclose, "create");
              }),
              std::string("the attribute ") + name + " has 1000 values, expected one");
}

TEST_F(ResultContent, IsRefusedWithADataSetOfWhichNothingIsStored) {
  const std::string words = refusal([](hid_t root) {
    remove(root, "series/elevation/time");
    data_set(root, "series/elevation/time", H5T_IEEE_F64LE, {hsize_t{1} << 60});
  });
  expect_in(words, "the data set time has a shape of 1152921504606846976 values, of which 0 bytes");
}

TEST_F(ResultContent, IsRefusedWithoutExactlyOneCaseText) {
  expect_in(refusal([](hid_t root) {
              remove(root, "case_text");
              hdf5::write_texts(root, "case_text", {});
            }),
            "case_text holds 0 texts, expected one");
}

TEST_F(ResultContent, IsRefusedWithASeriesOfUnequalLengths) {
  expect_in(refusal([](hid_t root) {
              remove(root, "series/elevation/time");
              hdf5::write_numbers(root, "series/elevation/time", {0, 1});
            }),
            "series elevation has 2 times and 3 values");
}

TEST_F(ResultContent, IsRefusedWithASnapshotOfUnequalLengths) {
  expect_in(refusal([](hid_t root) {
              remove(root, "snapshots/00000/pressure");
              hdf5::write_numbers(root, "snapshots/00000/pressure", {0, 1});
            }),
            "snapshot 00000 has 1 places and 2 values of pressure");
}

TEST_F(ResultContent, IsRefusedWithTextsForNumbers) {
  expect_in(refusal([](hid_t root) {
              remove(root, "series/elevation/value");
              hdf5::write_texts(root, "series/elevation/value", {"0", "1", "2"});
            }),
            "HDF5 cannot");
}

}  // namespace
}  // namespace slosh::result_content_test
