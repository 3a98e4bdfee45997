#include "verification/input/definition_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <system_error>
#include <vector>

#include "verification/files/content_hash.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/input/nearest_name.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_in(const fs::path& directory) {
  std::vector<std::string> names;
  std::error_code none;  // an absent directory has no names
  for (const fs::directory_entry& entry : fs::directory_iterator(directory, none)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

fs::path plain_path(const fs::path& path) {
  const fs::path plain = path.lexically_normal();
  std::error_code missing;
  return !fs::exists(path, missing) || fs::equivalent(path, plain, missing) ? plain : path;
}

fs::path find_definition_file(std::string_view kind, const std::string& name_or_path,
                              const fs::path& directory, const fs::path& base) {
  const bool is_path =
      name_or_path.find('/') != std::string::npos || name_or_path.ends_with(".toml");
  fs::path file = !is_path       ? directory / (name_or_path + ".toml")
                  : base.empty() ? fs::path(name_or_path)
                                 : plain_path(base / name_or_path);
  if (std::error_code lost; fs::is_regular_file(file, lost)) return file;
  if (is_path)
    throw CaseFileError(fmt::format("{} = \"{}\": expected a file; there is no {}", kind,
                                    name_or_path, file.string()));
  constexpr std::size_t suggestions = 3;  // enough to choose from, few enough to read
  throw CaseFileError(
      fmt::format("{} = \"{}\": expected a path or a name in {}; nearest: {}", kind, name_or_path,
                  directory.string(),
                  fmt::join(nearest_names(name_or_path, names_in(directory), suggestions), ", ")));
}

std::string read_definition_text(std::string_view kind, const fs::path& file) try {
  return read_input(file);
} catch (const fs::filesystem_error& error) {
  throw CaseFileError(fmt::format("{}: expected a {} file with text that can be read: {}",
                                  file.string(), kind, error.code().message()));
}

}  // namespace slosh
