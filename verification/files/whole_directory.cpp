#include "verification/files/whole_directory.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <system_error>

namespace slosh {
namespace {

namespace fs = std::filesystem;

void require_free(const fs::path& directory) {
  if (!fs::exists(fs::symlink_status(directory))) return;
  if (!fs::is_directory(directory) || !fs::is_empty(directory))
    throw fs::filesystem_error("expected a directory that is not there yet, or an empty one",
                               directory, std::make_error_code(std::errc::file_exists));
}

}  // namespace

void make_whole_directory(const fs::path& directory,
                          const std::function<void(const fs::path&)>& fill) {
  const fs::path named = fs::weakly_canonical(fs::absolute(directory));
  const fs::path place = named.has_filename() ? named : named.parent_path();  // without a last "/"
  require_free(place);
  fs::create_directories(place.parent_path());
  const fs::path temporary =
      place.parent_path() / fmt::format(".{}.{}.partial", place.filename().string(), ::getpid());
  fs::remove_all(temporary);  // of a process of this number that was killed
  try {
    fs::create_directory(temporary);
    fill(temporary);
    fs::rename(temporary, place);  // an empty directory of this name gives way
  } catch (...) {
    std::error_code ignored;
    fs::remove_all(temporary, ignored);
    throw;
  }
}

}  // namespace slosh
