#include "verification/solvers/external/external_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <set>
#include <string>
#include <string_view>

#include "verification/input/input_files.hpp"
#include "verification/solvers/external/shared_libraries.hpp"
#include "verification/solvers/external_command.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

// Names, and what versions follow: python3.11.
bool is_interpreter(const std::string& word) {
  static constexpr std::array<std::string_view, 17> names{
      "python", "pypy", "bash", "sh",  "dash",  "zsh",    "ksh",     "perl",  "ruby",
      "julia",  "node", "java", "lua", "tclsh", "octave", "Rscript", "matlab"};
  std::string name = fs::path(word).filename().string();
  name.erase(std::find_if(name.begin(), name.end(),
                          [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-'; }),
             name.end());
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool begins_as_script(const fs::path& file) {
  std::error_code none;
  if (!fs::is_regular_file(file, none)) return false;
  char head[2] = {};
  return std::ifstream(file, std::ios::binary).read(head, 2) && head[0] == '#' && head[1] == '!';
}

// Whether `inputs` names a file below this directory.
bool has_input(const ExternalRun& external, const fs::path& directory) {
  const fs::path whole = fs::weakly_canonical(directory);
  const auto is_below = [&](const InputFile& input) {
    const fs::path file = fs::weakly_canonical(input.file);
    return std::mismatch(whole.begin(), whole.end(), file.begin(), file.end()).first == whole.end();
  };
  return std::any_of(external.inputs.begin(), external.inputs.end(), [&](const fs::path& input) {
    const std::vector<InputFile> files = input_files(input);
    return std::any_of(files.begin(), files.end(), is_below);
  });
}

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

// Returns the regular files that the words of a text name, relative to one of these directories or
// whole; behind a variable that stands for a directory too ("$HERE/solve"). A word of a script also
// names a module: mine.py, mine/__init__.py or mine/fast.py of a script in Python that says `mine`
// or `mine.fast`. What stands behind a # is a comment. Only the first 1e6 bytes are read, and of a
// file that is no text nothing. Files of the system are left out (shared_libraries.hpp).
std::vector<fs::path> files_named_in(const fs::path& text,
                                     const std::vector<fs::path>& directories) {
  std::vector<fs::path> files;
  const std::string suffix = module_suffix(text);
  for (const std::string& word : words_of(text_of(text)))
    add_files(meanings(word, suffix), directories, files);
  return files;
}

// Returns those that the words of an argument name, also one that is glued to a letter
// ("-pcase.txt"), and for a word without a suffix those that have one: Case.xml for "Case".
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

// The files whose content is part of the run's key.
std::vector<fs::path> known_files(const ExternalRun& external, const CaseDefinition& definition) {
  std::vector<fs::path> files{external_program(external, definition)};
  for (InputFile& input : external_inputs(external, definition)) files.push_back(input.file);
  return files;
}

// Those that are named each by itself, not by the directory that holds them. The case file, which
// names what other runs read, is none, nor is an installed program (pyenv's python3 is a script).
std::vector<fs::path> single_files(const ExternalRun& external, const CaseDefinition& definition) {
  std::vector<fs::path> files;
  const std::string& program = external.command.front();
  if (program.find('/') != program.npos && !is_interpreter(program))
    files.push_back(external_program(external, definition));
  std::error_code lost;
  for (const fs::path& path : argument_paths(external, definition))
    if (fs::is_regular_file(path, lost)) files.push_back(path.lexically_normal());
  for (const fs::path& input : external.inputs)
    if (!fs::is_directory(input, lost))
      for (InputFile& file : input_files(input)) files.push_back(file.file.lexically_normal());
  std::erase(files, fs::absolute(definition.file).lexically_normal());
  return files;
}

// The files that the arguments and the texts of the run name.
std::vector<fs::path> files_seen(const ExternalRun& external, const CaseDefinition& definition) {
  std::vector<fs::path> seen, places{fs::absolute(definition.file).parent_path()};
  if (!external.directory.empty()) places.push_back(external.directory);
  const std::vector<std::string> command = external_command(external, definition, "/dev/null");
  for (auto argument = command.begin() + 1; argument != command.end(); ++argument)
    std::ranges::move(files_meant_by(*argument, places), std::back_inserter(seen));
  for (const fs::path& text : single_files(external, definition)) {
    std::vector<fs::path> beside = places;
    beside.push_back(text.parent_path());
    std::ranges::move(files_named_in(text, beside), std::back_inserter(seen));
  }
  return seen;
}

}  // namespace

std::string unlisted_script(const ExternalRun& external, const CaseDefinition& definition) {
  if (external.command.front().starts_with("{peers_directory}")) return "";
  std::vector<fs::path> known = known_files(external, definition);
  if (external.inputs.empty()) {
    for (const std::string& word : external.command)
      if (is_interpreter(word)) return word;
    for (const fs::path& file : known)
      if (begins_as_script(file)) return file.filename().string();
  }
  std::vector<fs::path> directories = argument_paths(external, definition);
  if (!external.directory.empty()) directories.insert(directories.begin(), external.directory);
  for (const fs::path& directory : directories)
    if (std::error_code none; fs::is_directory(directory, none) && !has_input(external, directory))
      return directory.lexically_normal().string();
  known.push_back(definition.file);
  const auto is_known = [&](const fs::path& file) {
    return std::ranges::any_of(known, [&](const fs::path& one) {
      std::error_code lost;
      return fs::equivalent(one, file, lost);
    });
  };
  for (const fs::path& file : files_seen(external, definition))
    if (!is_known(file) && !is_interpreter(file.string()))
      return file.lexically_proximate(fs::absolute(definition.file).parent_path()).string();
  return "";
}

std::string script_doubt(const RunDefinition& run, const CaseDefinition& definition) {
  const auto* external = std::get_if<ExternalRun>(&run.solver);
  const bool has_place = external && !definition.file.empty();  // from which its files are found
  const std::string script = has_place ? unlisted_script(*external, definition) : "";
  if (script.empty()) return "";
  return fmt::format(
      "run {}: what {} loads or holds is no part of its key: its result is kept when that changes; "
      "`inputs` would name it",
      run.name, script);
}

}  // namespace slosh
