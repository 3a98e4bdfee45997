// Any bytes as a case file and as a campaign file: a definition or a CaseFileError.
#include "verification/case_file/campaign_parser.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/fuzz/memory_file.hpp"

namespace {

// The kept cases name these tables by "../cwd/": beside a file in memory nothing else can be.
bool go_to(const std::filesystem::path& directory) {
  std::filesystem::current_path(directory);
  return true;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  static slosh::MemoryFile file;
  [[maybe_unused]] static const bool among_records = go_to(SLOSH_FUZZ_RECORDS);
  file.replace(bytes, count);
  try {
    slosh::read_case(file.path(), SLOSH_FUZZ_RECORDS);
  } catch (const slosh::CaseFileError&) {
  }
  try {
    slosh::read_campaign(file.path(), SLOSH_CASES, {{"rigid_rotation", {{"velocity", "1"}}}});
  } catch (const slosh::CaseFileError&) {
  }
  return 0;
}
