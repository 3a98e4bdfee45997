// Results and saved states that were truncated, altered, appended to or confused with one another.
#include "verification/files/sealed_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <string>

#include "verification/files/content_hash.hpp"
#include "verification/files/sealed_json.hpp"
#include "verification/fuzz/memory_file.hpp"
#include "verification/results/result_file.hpp"
#include "verification/solvers/particles/state_file.hpp"
#include "verification/tests/hdf5_attacks.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::sealed_file_test {
namespace {

namespace fs = std::filesystem;

struct Kind {
  const char* name;
  const char *seal, *next_seal;
  std::function<void(const fs::path&)> write, read;
};

void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }

void write_small_result(const fs::path& file) {
  RunResult result{};
  result.case_name = "a case";
  result.series = {{"elevation@left", "m", {0, 1}, {2, 3}}};
  write_result(result, file);
}

void write_small_state(const fs::path& file) {
  sph::SavedState state;
  state.fields = {{"x", {0.1, 0.2}}};
  write_state(state, "key", file);
}

const Kind kinds[] = {{"result", "slosh result 002 ", "slosh result 003 ", write_small_result,
                       [](const fs::path& file) { read_result(file); }},
                      {"state", "slosh state 001 ", "slosh state 002 ", write_small_state,
                       [](const fs::path& file) { read_state("key", file); }}};

class SealedFile : public ::testing::TestWithParam<Kind> {
 protected:
  SealedFile() : bytes(written_by(GetParam())) {}

  static std::string written_by(const Kind& kind) {
    const TemporaryDirectory directory;
    kind.write(directory.path() / "a file.h5");
    return read_bytes(directory.path() / "a file.h5");
  }

  // The error message of reading these bytes; empty where they are accepted.
  std::string refusal(const std::string& content) {
    memory.replace(content);
    return message_of<ResultError>([&] { GetParam().read(memory.path()); });
  }

  // The content under a seal that fits, as one who means harm would make it.
  std::string resealed(const std::string& image) const {
    return image + "\n" + GetParam().seal + content_hash(image) + "\n";
  }
  std::string image() const { return bytes.substr(0, bytes.rfind("\nslosh ")); }

  // Every `step`th of 50 files of which a byte is changed, though their checksums fit.
  void expect_no_crash(std::size_t step) {
    int refused = 0;
    for (std::size_t i = 0; i < 50; i += step) {
      std::string altered = image();
      const std::size_t at = 293 * i % std::min<std::size_t>(altered.size(), 8192);
      altered[at] = static_cast<char>(altered[at] ^ (i % 3 == 0 ? 0xff : 1 << (i % 8)));
      const std::string words = refusal(resealed(altered));
      refused += !words.empty();
      if (!words.empty()) {
        EXPECT_TRUE(holds(words, name));
      }
    }
    EXPECT_GT(refused, 0);
  }

  MemoryFile memory;  // tens of thousands of writes
  const std::string name = memory.path().string();
  const std::string bytes;
};

TEST_P(SealedFile, IsTakenAsItWasWritten) { EXPECT_EQ(refusal(bytes), ""); }

TEST_P(SealedFile, IsRefusedByNameWhereverItIsCut) {
  const std::size_t seal_begin = bytes.size() - 100;
  for (std::size_t length = 0; length < bytes.size(); length += length < seal_begin ? 19 : 1) {
    const std::string words = refusal(bytes.substr(0, length));
    ASSERT_TRUE(holds(words, name)) << length << " bytes: " << words;
    ASSERT_TRUE(holds(words, "not a whole")) << length << " bytes: " << words;
  }
}

TEST_P(SealedFile, IsRefusedByNameWhicheverBitIsFlipped) {
  const std::size_t seal_begin = bytes.size() - 100;
  for (std::size_t i = 0; i < bytes.size(); i += i < seal_begin ? 29 : 1) {
    for (int bit = i < seal_begin ? static_cast<int>(i % 8) : 0; bit < 8; ++bit) {
      std::string altered = bytes;
      altered[i] = static_cast<char>(altered[i] ^ (1 << bit));
      const std::string words = refusal(altered);
      ASSERT_TRUE(holds(words, name)) << "byte " << i << ", bit " << bit;
      if (i < seal_begin) break;
    }
  }
}

TEST_P(SealedFile, IsRefusedWithAnythingAfterItsEnd) {
  for (const std::string& more :
       {std::string("\n"), std::string(1, '\0'), std::string(5000, 'x'), bytes})
    EXPECT_TRUE(holds(refusal(bytes + more), name)) << more.size() << " bytes";
}

TEST_P(SealedFile, IsRefusedWhereAPartOfItIsMissing) {
  std::string shorter = bytes;
  shorter.erase(bytes.size() / 2, 512);
  EXPECT_TRUE(holds(refusal(shorter), "altered"));
}

TEST_P(SealedFile, IsRefusedInAnotherVersionThoughItsChecksumFits) {
  std::string later = bytes;
  const std::string seal = GetParam().seal;
  later.replace(later.rfind(seal), seal.size(), GetParam().next_seal);
  EXPECT_TRUE(holds(refusal(later), "format version 00"));
}

TEST_P(SealedFile, IsRefusedForAnyOtherKind) {
  for (const Kind& other : kinds) {
    if (other.name == GetParam().name) continue;
    EXPECT_TRUE(holds(refusal(written_by(other)), "foreign")) << other.name;
  }
}

TEST_P(SealedFile, IsRefusedWhereItLeadsIntoAnotherFileThoughItsChecksumFits) {
  const hdf5::QuietErrors quiet;
  const TemporaryDirectory directory;
  write_secrets(directory.path());
  const fs::path file = directory.path() / "a.h5";
  for (const Hdf5Attack& attack : hdf5_attacks(directory.path())) {
    std::ofstream(file, std::ios::binary) << image();
    {
      const hdf5::Handle root(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose, "open");
      attack.plant(root, "way");
    }
    EXPECT_TRUE(holds(refusal(resealed(read_bytes(file))), attack.refusal)) << attack.name;
  }
}

TEST_P(SealedFile, CrashesNoReaderOfTenFilesOfWhichAByteIsChanged) { expect_no_crash(5); }
TEST_P(SealedFile, CrashesNoReaderWhereAByteIsChangedThoughItsChecksumFits) { expect_no_crash(1); }

TEST(SealedJson, IsNoneThatIsNestedTooDeep) {
  const std::size_t levels = 200'000;
  EXPECT_FALSE(is_sealed_json("{\"body\":" + std::string(levels, '[') + std::string(levels, ']') +
                              ",\"hash\":\"x\"}"));
}

INSTANTIATE_TEST_SUITE_P(EachKind, SealedFile, ::testing::ValuesIn(kinds),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace slosh::sealed_file_test
