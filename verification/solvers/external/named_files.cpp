#include "verification/solvers/external/named_files.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <set>
#include <string>
#include <string_view>

#include "verification/input/input_files.hpp"
#include "verification/solvers/external/shared_libraries.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

bool is_of_word(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) ||
         std::string_view("_./-+").find(letter) != std::string_view::npos;
}

// Each word once, without comments; a word without a letter is a number.
std::set<std::string> words_of(const std::string& text) {
  constexpr std::string_view blanks = " \t\n";
  std::set<std::string> words;
  for (auto at = text.begin(); at != text.end();) {
    if (*at == '#' && (at == text.begin() || blanks.find(at[-1]) != blanks.npos))
      at = std::find(at, text.end(), '\n');
    const auto end = std::find_if_not(at, text.end(), is_of_word);
    const std::string word(at, end);
    if (std::any_of(word.begin(), word.end(), [](unsigned char c) { return std::isalpha(c); }))
      words.insert(word);
    at = end == text.end() ? end : end + 1;
  }
  return words;
}

// Empty for a file that is no text.
std::string text_of(const fs::path& file) {
  constexpr std::size_t most = 1'000'000;
  std::string text(most, ' ');
  std::ifstream stream(file, std::ios::binary);
  stream.read(text.data(), most);
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text.find('\0') == text.npos ? text : "";
}

// The regular files of these paths in each directory, without the system's.
void add_files(const std::vector<fs::path>& paths, const std::vector<fs::path>& directories,
               std::vector<fs::path>& files) {
  for (const fs::path& directory : directories)
    for (const fs::path& path : paths) {
      std::error_code lost;  // as where a name is too long
      const fs::path file = (directory / path).lexically_normal();
      if (fs::is_regular_file(file, lost) && !is_of_system(file)) files.push_back(file);
    }
}

// The suffix of the modules that a script loads by their bare names; empty for other files.
std::string module_suffix(const fs::path& text) {
  static constexpr std::array<std::string_view, 6> suffixes{".py",  ".m",  ".rb",
                                                            ".lua", ".js", ".pl"};
  const std::string own = text.extension().string();
  return std::ranges::count(suffixes, own) > 0 ? own : "";
}

std::vector<fs::path> meanings(const std::string& word, const std::string& suffix) {
  std::vector<fs::path> paths{word};
  if (const std::size_t slash = word.find('/'); slash != word.npos)
    paths.push_back(word.substr(slash + 1));
  const std::size_t begin = word.find_first_not_of("./");
  if (suffix.empty() || begin == word.npos) return paths;
  std::string module = word.substr(begin);
  std::replace(module.begin(), module.end(), '.', '/');
  for (fs::path part = module; !part.empty(); part = part.parent_path())
    for (const char* inside : {"", "/__init__"}) paths.push_back(part.string() + inside + suffix);
  return paths;
}

}  // namespace

std::vector<fs::path> files_named_in(const fs::path& text,
                                     const std::vector<fs::path>& directories) {
  std::vector<fs::path> files;
  const std::string suffix = module_suffix(text);
  for (const std::string& word : words_of(text_of(text)))
    add_files(meanings(word, suffix), directories, files);
  return files;
}

std::vector<fs::path> files_meant_by(const std::string& argument,
                                     const std::vector<fs::path>& directories) {
  std::vector<fs::path> files;
  for (const std::string& word : words_of(argument)) {
    std::vector<fs::path> paths{word};
    if (word.size() > 2 && word[0] == '-' && word[1] != '-') paths.push_back(word.substr(2));
    add_files(paths, directories, files);
    for (const fs::path& directory : directories)
      for (const fs::path& path : paths) {
        std::error_code lost;
        if (path.has_extension() || fs::exists(directory / path, lost)) continue;
        for (const InputFile& file : input_files((directory / path).string() + ".*"))
          files.push_back(file.file.lexically_normal());
      }
  }
  return files;
}

}  // namespace slosh
