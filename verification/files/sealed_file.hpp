// A sealed file of this project is an HDF5 image followed by one line of fixed length, the seal:
//   "slosh KIND <version> <hash (128-bit XXH3) of every byte before it>\n"
// HDF5 readers ignore bytes past the image's end. The seal is checked before HDF5 parses the image,
// so that a damaged file gives a clear message and never reaches the parser. A file whose seal is
// forged is read under guard (guarded_reading.hpp) and may not lead into other files
// (self_contained.hpp). The file is written under a temporary name and renamed when complete.
#pragma once

#include <hdf5.h>

#include <filesystem>
#include <functional>
#include <string_view>

namespace slosh {

struct SealedKind {
  const char* name;  // "result", "state"
  int version;       // below 1000
};

// Whether the bytes are a whole sealed file, of any kind and version.
bool is_sealed(std::string_view bytes);

// `write` fills the root group. Throws ResultError (result_error.hpp) with the file's name.
void write_sealed(const SealedKind& kind, const std::filesystem::path& file,
                  const std::function<void(hid_t)>& write);

// Passes the opened file to `read`. Throws ResultError with the file's name where the file is
// missing, truncated, altered, or of another kind or version, and where `read` throws
// std::runtime_error.
void read_sealed(const SealedKind& kind, const std::filesystem::path& file,
                 const std::function<void(hid_t)>& read);

}  // namespace slosh
