// Gives every input of a fuzz target's kept corpus to the target: a test each, named after its
// file.
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count);

namespace {

class KeptInput : public testing::Test {
 public:
  explicit KeptInput(std::filesystem::path file) : file_(std::move(file)) {}
  void TestBody() override {
    std::ifstream in(file_, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    ASSERT_FALSE(bytes.empty());
    EXPECT_EQ(
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()),
        0);
  }

 private:
  std::filesystem::path file_;
};

}  // namespace

int main(int count, char** arguments) {
  testing::InitGoogleTest(&count, arguments);
  for (const auto& entry : std::filesystem::directory_iterator(SLOSH_CORPUS))
    testing::RegisterTest(
        "KeptCorpusOf_" SLOSH_FUZZ_TARGET, entry.path().filename().c_str(), nullptr, nullptr,
        __FILE__, __LINE__,
        [file = entry.path()]() -> testing::Test* { return new KeptInput(file); });
  return RUN_ALL_TESTS();
}
