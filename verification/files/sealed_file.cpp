#include "verification/files/sealed_file.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "verification/files/atomic_file.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/foreign/guarded_reading.hpp"
#include "verification/files/foreign/self_contained.hpp"
#include "verification/files/hdf5_handles.hpp"
#include "verification/files/result_error.hpp"

namespace slosh {
namespace {

using hdf5::checked;
using hdf5::Handle;

constexpr std::size_t hash_length = 32;

std::string seal_begin(const SealedKind& kind) { return fmt::format("\nslosh {} ", kind.name); }

std::string seal(const SealedKind& kind, std::string_view image) {
  return fmt::format("{}{:03d} {}\n", seal_begin(kind), kind.version, content_hash(image));
}

// The bytes of the image. Throws ResultError unless the seal matches them.
std::string_view unsealed(const SealedKind& kind, std::string_view bytes) {
  const std::string begin = seal_begin(kind);
  const std::size_t seal_length = begin.size() + 3 + 1 + hash_length + 1;
  if (bytes.size() < seal_length) throw ResultError(fmt::format("not a whole {} file", kind.name));
  const std::string_view image = bytes.substr(0, bytes.size() - seal_length);
  const std::string_view found = bytes.substr(image.size());
  if (!found.starts_with(begin)) {
    throw ResultError(
        fmt::format("not a whole {} file (it does not end with its checksum): truncated or foreign",
                    kind.name));
  }
  const std::string expected = seal(kind, image);
  const auto version = [&](std::string_view text) { return text.substr(begin.size(), 3); };
  if (version(found) != version(expected)) {
    throw ResultError(
        fmt::format("format version {}, expected {}", version(found), version(expected)));
  }
  if (found != expected)
    throw ResultError("its content does not match its checksum: it has been altered");
  return image;
}

// Parses the very bytes that were hashed; HDF5 opens and locks no file.
void read_image(std::string_view image, const std::function<void(hid_t)>& read) {
  const Handle access = hdf5::memory_access();
  checked(
      H5Pset_file_image(access, const_cast<char*>(image.data()), image.size()),  // HDF5 copies it
      "take an image");
  const Handle file(H5Fopen("image", H5F_ACC_RDONLY, access), H5Fclose, "open the image");
  hdf5::require_self_contained(file);
  read(file);
}

}  // namespace

bool is_sealed(std::string_view bytes) {
  const std::size_t end = bytes.rfind("\nslosh ");
  return end != bytes.npos &&
         bytes.substr(end).ends_with(" " + content_hash(bytes.substr(0, end)) + "\n");
}

void write_sealed(const SealedKind& kind, const std::filesystem::path& file,
                  const std::function<void(hid_t)>& write) try {
  const hdf5::QuietErrors quiet;
  std::string bytes = hdf5::image_of(write);
  bytes += seal(kind, bytes);
  replace_file(file, bytes, Durability::power_loss);
} catch (const std::runtime_error& error) {
  throw ResultError(
      fmt::format("cannot write the {} file {}: {}", kind.name, file.string(), error.what()));
}

void read_sealed(const SealedKind& kind, const std::filesystem::path& file,
                 const std::function<void(hid_t)>& read) try {
  const hdf5::QuietErrors quiet;
  const std::string bytes = read_bytes(file);
  const std::string_view image = unsealed(kind, bytes);
  read_guarded(stored_bytes(file), [&] { read_image(image, read); });
} catch (const std::runtime_error& error) {
  throw ResultError(
      fmt::format("cannot use the {} file {}: {}", kind.name, file.string(), error.what()));
}

}  // namespace slosh
