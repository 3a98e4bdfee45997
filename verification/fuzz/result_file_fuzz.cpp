// A sound result or saved state whose HDF5 content is edited as the bytes say, under a seal that
// fits: what it holds or a ResultError. The bytes of the image itself are not mutated: HDF5 1.10
// hangs, leaks or asks for any memory within seconds of that, and the seal is what keeps damaged
// bytes from it.
#include <array>
#include <cstdlib>

#include "verification/files/content_hash.hpp"
#include "verification/files/hdf5_handles.hpp"
#include "verification/fuzz/hdf5_edits.hpp"
#include "verification/fuzz/memory_file.hpp"
#include "verification/results/result_file.hpp"
#include "verification/solvers/particles/state_file.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace {

using namespace slosh;

struct Sealed {
  std::string image, seal_begin;
};

// The seal: a line's end, some words, a hash of 32 digits and a line's end.
Sealed taken_apart(const std::filesystem::path& file) {
  const std::string bytes = read_bytes(file);
  const std::size_t end = bytes.rfind("\nslosh ");
  if (end == bytes.npos || bytes.size() < end + 33) std::abort();
  return {bytes.substr(0, end), bytes.substr(end, bytes.size() - 33 - end)};
}

Sealed sample_result(const std::filesystem::path& file) {
  const RunResult result{.case_name = "c",
                         .run_name = "r",
                         .solver = "sph",
                         .case_text = "t",
                         .key = "k",
                         .provenance = {{"a", "b"}},
                         .active_terms = {"x", "y"},
                         .diagnostics = {{"d", 1}},
                         .cost = {1, 2, 3, 4, 5, 6},
                         .series = {{"e@r", "m", {0, 1, 2}, {1, 2, 3}}},
                         .snapshots = {{1, 1, 1, {1}, {1}, {1}, {1}, {1}}}};
  write_result(result, file);
  return taken_apart(file);
}

Sealed sample_state(const std::filesystem::path& file) {
  sph::SavedState state;
  state.terms = {"x"};
  state.setting = {{"a", 1}};
  state.numbers = {{"t", 1}};
  state.fields = {{"x", {1, 2}}};
  state.output.elevation["left"] = {{0, 1}, {1, 2}};
  state.output.energy = {{"wall_work", "J/m", {{0}, {1}}}};
  write_state(state, "key", file);
  return taken_apart(file);
}

std::array<Sealed, 2> samples_of_both() {
  const TemporaryDirectory directory;
  return {sample_result(directory.path() / "result"), sample_state(directory.path() / "state")};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  static const hdf5::QuietErrors quiet;
  static MemoryFile file;
  static const std::array<Sealed, 2> samples = samples_of_both();
  ByteChoices choices(bytes, count);
  const Sealed& sample = samples[choices.flag()];
  const std::string image = edited(sample.image, choices);
  file.replace(image + sample.seal_begin + content_hash(image) + "\n");
  try {
    if (&sample == &samples[0])
      read_result(file.path());
    else
      read_state("key", file.path());
  } catch (const ResultError&) {
  }
  return 0;
}
