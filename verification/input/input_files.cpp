#include "verification/input/input_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glob.h>

#include <algorithm>
#include <set>
#include <system_error>
#include <vector>

#include "verification/files/content_hash.hpp"
#include "verification/files/protected_inputs.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/input/nearest_name.hpp"
#include "verification/input/tables/series_files.hpp"

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

bool is_left_out(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.starts_with('.') || name == "__pycache__";
}

std::vector<InputFile> files_below(const fs::path& directory) {
  std::vector<InputFile> files;
  std::set<fs::path> entered{fs::canonical(directory)};
  using Walk = fs::recursive_directory_iterator;
  std::error_code failed;  // as where names are too long
  for (Walk at(directory, fs::directory_options::follow_directory_symlink, failed), end; at != end;
       at.increment(failed)) {
    std::error_code lost;  // as where links lead in a circle
    const bool is_new =
        !at->is_directory(lost) || entered.insert(fs::canonical(at->path(), failed)).second;
    if (failed) break;
    if (is_left_out(at->path()) || !is_new)
      at.disable_recursion_pending();
    else if (at->is_regular_file(lost))
      files.push_back({at->path().lexically_relative(directory).generic_string(), at->path()});
  }
  if (failed) throw fs::filesystem_error("cannot list all files below", directory, failed);
  std::sort(files.begin(), files.end(),
            [](const InputFile& a, const InputFile& b) { return a.name < b.name; });
  return files;
}

// Those of a file or a directory; a pipe, a socket or a device has none.
std::vector<InputFile> files_of(const fs::path& path) {
  std::error_code lost;
  if (fs::is_regular_file(path, lost)) return {{path.filename().string(), path}};
  if (fs::is_directory(path, lost)) return files_below(path.lexically_normal());
  return {};
}

std::vector<fs::path> matches(const fs::path& pattern) {
  glob_t found{};
  const bool any = ::glob(pattern.c_str(), GLOB_NOSORT, nullptr, &found) == 0;
  std::vector<fs::path> paths;
  if (any) paths.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  ::globfree(&found);
  std::sort(paths.begin(), paths.end());
  return paths;
}

// The directories below which the data of a case lie: the repository; without one, the case's own
// directory and the current one. Never the whole file system.
std::vector<fs::path> roots_of(const fs::path& case_file) {
  std::error_code lost;  // of a file that has no name any more
  const fs::path real = fs::weakly_canonical(fs::absolute(case_file), lost);
  const fs::path home = (lost ? fs::absolute(case_file) : real).parent_path();
  for (fs::path at = home; at.has_relative_path(); at = at.parent_path())
    if (std::error_code none; fs::exists(at / ".git", none)) return {at};
  const fs::path current = fs::current_path();
  if (lies_below(home, current) && current.has_relative_path()) return {current};
  return {home};
}

bool is_hidden(const fs::path& path) {
  return std::any_of(path.begin(), path.end(), [](const fs::path& part) {
    return part.string().starts_with(".") && part != "." && part != "..";
  });
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
    throw CaseFileError(
        fmt::format("{} = \"{}\": expected a file; {}", kind, name_or_path, no_file_at(file)));
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

bool is_data_of(const fs::path& case_file, const fs::path& file) {
  std::error_code lost;
  const fs::path real = fs::canonical(file, lost);
  std::vector<fs::path> roots = roots_of(case_file);
  roots.push_back(fs::weakly_canonical(SLOSH_SHIPPED_CASES));
  for (const fs::path& root : roots)
    if (!lost && lies_below(real, root) && !is_hidden(real.lexically_relative(root))) return true;
  return false;
}

void require_data_file(const TomlTable& table, const char* key, const fs::path& file,
                       const fs::path& case_file) {
  const std::vector<fs::path> parts = series_files(file);
  if (parts.empty()) table.refuse(key, "a file relative to the case file; " + no_file_at(file));
  for (const fs::path& part : parts)
    if (!is_data_of(case_file, part))
      table.refuse(key, fmt::format("a file below {}, links followed, and not a hidden one",
                                    roots_of(case_file).front().string()));
}

bool is_record_in(const fs::path& directory, const TomlTable& table, const char* key,
                  const fs::path& file) {
  std::error_code lost;
  const fs::path real = fs::canonical(file, lost);
  if (lost || !fs::is_regular_file(real)) return false;
  if (!lies_below(real, fs::canonical(directory)))
    table.refuse(key, fmt::format("a file below {}, links followed", directory.string()));
  return true;
}

std::vector<InputFile> input_files(const fs::path& path) {
  std::vector<InputFile> files = files_of(path);
  if (std::error_code lost; files.empty() && !fs::exists(path, lost))
    for (const fs::path& match : matches(path))
      std::ranges::move(files_of(match), std::back_inserter(files));
  return files;
}

}  // namespace slosh
