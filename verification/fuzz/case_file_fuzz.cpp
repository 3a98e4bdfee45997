// Any bytes as a case file and as a campaign file: a definition or a CaseFileError.
#include "verification/case_file/campaign_parser.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/fuzz/memory_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  static slosh::MemoryFile file;
  file.replace(bytes, count);
  try {
    slosh::read_case(file.path(), SLOSH_FUZZ_RECORDS);
  } catch (const slosh::CaseFileError&) {
  }
  try {
    slosh::read_campaign(file.path(), SLOSH_CASES, {{"kernels", {{"normalisation", "1"}}}});
  } catch (const slosh::CaseFileError&) {
  }
  return 0;
}
