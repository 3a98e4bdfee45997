// A file of ours is an HDF5 image followed by one line of fixed length, the seal:
//   "slosh KIND <version> <hash (128-bit XXH3) of every byte before it>\n"
// HDF5 readers pay bytes past the image's end no heed. The seal is checked before HDF5 sees the
// image, so that a damaged file meets a message and not the parser of a foreign format. Written
// under a temporary name and renamed when complete.
#pragma once

#include <hdf5.h>

#include <filesystem>
#include <functional>

namespace slosh {

struct SealedKind {
  const char* name;  // "result", "state"
  int version;       // below 1000
};

// `write` fills the root group. Throws ResultError (result_file.hpp) with the file's name.
void write_sealed(const SealedKind& kind, const std::filesystem::path& file,
                  const std::function<void(hid_t)>& write);

// Throws ResultError with the file's name where it is absent, truncated, altered, or of another
// kind or version, and where `read` throws std::runtime_error.
void read_sealed(const SealedKind& kind, const std::filesystem::path& file,
                 const std::function<void(hid_t)>& read);

}  // namespace slosh
