#include "verification/input/input_files.hpp"

#include <glob.h>

#include <algorithm>
#include <set>

namespace slosh {
namespace {

namespace fs = std::filesystem;

bool is_left_out(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.starts_with('.') || name == "__pycache__";
}

std::vector<InputFile> files_below(const fs::path& directory) {
  std::vector<InputFile> files;
  std::set<fs::path> entered{fs::canonical(directory)};
  using Walk = fs::recursive_directory_iterator;
  for (Walk at(directory, fs::directory_options::follow_directory_symlink), end; at != end; ++at) {
    const bool is_new = !at->is_directory() || entered.insert(fs::canonical(at->path())).second;
    if (is_left_out(at->path()) || !is_new)
      at.disable_recursion_pending();
    else if (at->is_regular_file())
      files.push_back({at->path().lexically_relative(directory).generic_string(), at->path()});
  }
  std::sort(files.begin(), files.end(),
            [](const InputFile& a, const InputFile& b) { return a.name < b.name; });
  return files;
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

}  // namespace

std::vector<InputFile> input_files(const fs::path& path) {
  if (fs::is_regular_file(path)) return {{path.filename().string(), path}};
  if (fs::is_directory(path)) return files_below(path.lexically_normal());
  std::vector<InputFile> files;
  for (const fs::path& match : matches(path))
    if (fs::exists(match)) std::ranges::move(input_files(match), std::back_inserter(files));
  return files;
}

}  // namespace slosh
