#include "verification/cli/installation.hpp"

#include <cstdlib>

#include "verification/files/shell_word.hpp"
#include "verification/input/case_file_error.hpp"

namespace slosh {

namespace fs = std::filesystem;

fs::path usual_store(const Installation& installation) {
  const char* named = std::getenv(store_variable);
  return named && *named ? whole(named) : installation.build / "store";
}

fs::path shown_page(const Installation& installation, const std::string& name) {
  const fs::path directory = installation.build / "shown";
  const fs::file_status status = fs::symlink_status(directory);
  if (fs::exists(status) && !fs::is_directory(status))
    throw CaseFileError(directory.string() + ": expected a directory, and there is " +
                        (fs::is_symlink(status) ? "a link" : "a file") +
                        "; remove it, or name another place with --output");
  fs::create_directories(directory);
  return directory / (name + ".html");
}

std::string name_or_path(const fs::path& file, const fs::path& shipped) {
  if (fs::equivalent(fs::absolute(file).parent_path(), shipped)) return file.stem().string();
  return shell_word(fs::absolute(file).lexically_normal().string());
}

fs::path whole(const fs::path& path) {
  if (path.empty()) return path;
  std::error_code circle;
  const fs::path named = fs::absolute(path), real = fs::weakly_canonical(named, circle);
  return circle ? named.lexically_normal() : real;
}

std::string experiments_option(const fs::path& experiments) {
  return experiments.empty() ? "" : " --experiments " + shell_word(experiments.string());
}

}  // namespace slosh
