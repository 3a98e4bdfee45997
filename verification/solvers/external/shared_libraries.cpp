#include "verification/solvers/external/shared_libraries.hpp"

#include <elf.h>

#include <algorithm>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/split.hpp>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include "verification/files/content_hash.hpp"
#include "verification/solvers/external_command.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> parts_of(const std::string& list, const char* separators) {
  std::vector<std::string> parts;
  return boost::split(parts, list, boost::is_any_of(separators));
}

bool is_regular(const fs::path& file) {
  std::error_code lost;  // as where a name is too long
  return fs::is_regular_file(file, lost);
}

bool is_elf(const fs::path& file) {
  char head[SELFMAG] = {};
  return std::ifstream(file, std::ios::binary).read(head, SELFMAG) &&
         std::memcmp(head, ELFMAG, SELFMAG) == 0;
}

// A file may say anything: what is outside of it is not read.
template <class Part>
std::optional<Part> part_at(std::string_view bytes, std::uint64_t offset) {
  if (offset > bytes.size() || bytes.size() - offset < sizeof(Part)) return std::nullopt;
  Part part;
  std::memcpy(&part, bytes.data() + offset, sizeof part);
  return part;
}

std::string text_at(std::string_view bytes, std::uint64_t offset) {
  if (offset >= bytes.size()) return "";
  const std::string_view rest = bytes.substr(offset);
  return std::string(rest.substr(0, rest.find('\0')));
}

struct Needs {
  std::vector<std::string> libraries, directories;
};

// Of a program of 64 bits; no other one runs here.
Needs needs_of(std::string_view bytes) {
  const auto head = part_at<Elf64_Ehdr>(bytes, 0);
  if (!head || head->e_ident[EI_CLASS] != ELFCLASS64) return {};
  std::vector<Elf64_Phdr> loaded;
  std::uint64_t at = bytes.size(), strings = 0;
  for (std::uint64_t i = 0; i < head->e_phnum; ++i) {
    const auto segment = part_at<Elf64_Phdr>(bytes, head->e_phoff + i * sizeof(Elf64_Phdr));
    if (segment && segment->p_type == PT_LOAD) loaded.push_back(*segment);
    if (segment && segment->p_type == PT_DYNAMIC) at = segment->p_offset;
  }
  std::vector<std::uint64_t> libraries, directories;
  for (auto entry = part_at<Elf64_Dyn>(bytes, at); entry && entry->d_tag != DT_NULL;
       entry = part_at<Elf64_Dyn>(bytes, at += sizeof(Elf64_Dyn))) {
    if (entry->d_tag == DT_NEEDED) libraries.push_back(entry->d_un.d_val);
    if (entry->d_tag == DT_RPATH || entry->d_tag == DT_RUNPATH)
      directories.push_back(entry->d_un.d_val);
    if (entry->d_tag == DT_STRTAB) strings = entry->d_un.d_ptr;
  }
  for (const Elf64_Phdr& segment : loaded)
    if (strings >= segment.p_vaddr && strings - segment.p_vaddr < segment.p_filesz) {
      strings = strings - segment.p_vaddr + segment.p_offset;
      break;
    }
  Needs needs;
  for (const std::uint64_t name : libraries)
    needs.libraries.push_back(text_at(bytes, strings + name));
  for (const std::uint64_t list : directories)
    for (std::string& one : parts_of(text_at(bytes, strings + list), ":"))
      needs.directories.push_back(std::move(one));
  return needs;
}

class LibrarySearch {
 public:
  explicit LibrarySearch(const fs::path& start) : start_(start) {}

  // `inherited` are the directories of the files that load this one.
  void add_needs_of(const fs::path& file, Needs inherited) {
    if (!is_elf(file)) return;
    Needs needs = needs_of(read_bytes(file));
    std::error_code lost;
    for (const fs::path& real : {file, fs::canonical(file, lost)})  // either is its $ORIGIN
      for (std::string directory : needs.directories) {
        for (const char* origin : {"$ORIGIN", "${ORIGIN}"})
          boost::replace_all(directory, origin, real.parent_path().string());
        inherited.directories.push_back(directory);
      }
    std::ranges::move(inherited.libraries, std::back_inserter(needs.libraries));
    inherited.libraries.clear();
    for (const std::string& library : needs.libraries)
      for (const fs::path& found : files_of(library, inherited.directories)) {
        if (std::find(found_.begin(), found_.end(), found) != found_.end()) continue;
        found_.push_back(found);
        add_needs_of(found, inherited);
      }
  }
  const std::vector<fs::path>& found() const { return found_; }

 private:
  // A name with a slash is a path.
  std::vector<fs::path> files_of(const std::string& library,
                                 const std::vector<std::string>& directories) const {
    std::vector<fs::path> paths;
    if (library.find('/') != library.npos)
      paths = {library};
    else
      for (const fs::path directory : directories) paths.push_back(directory / library);
    std::vector<fs::path> files;
    for (const fs::path& path : paths)
      if (const fs::path file = (start_ / path).lexically_normal();
          !library.empty() && is_regular(file) && !is_of_system(file))
        files.push_back(file);
    return files;
  }

  fs::path start_;  // to which relative paths belong
  std::vector<fs::path> found_;
};

// The libraries and the directories that the environment and the system add to all programs.
Needs needs_of_all() {
  Needs needs;
  if (const char* preloaded = std::getenv("LD_PRELOAD"))
    needs.libraries = parts_of(preloaded, ": ");
  if (const char* path = std::getenv("LD_LIBRARY_PATH")) needs.directories = parts_of(path, ":;");
  for (const InputFile& list : input_files("/etc/ld.so.conf.d/*.conf")) {
    std::ifstream stream(list.file);
    for (std::string line; std::getline(stream, line);)
      if (line.starts_with('/')) needs.directories.push_back(line);
  }
  return needs;
}

}  // namespace

bool is_of_system(const fs::path& file) {
  const fs::path below = fs::absolute(file).lexically_normal().relative_path();
  const std::string first = below.begin()->string();
  if (first == "usr") return !below.string().starts_with("usr/local/");
  return first.starts_with("lib") ||
         std::ranges::count(std::vector<std::string>{"bin", "sbin", "etc", "dev", "proc", "sys"},
                            first) > 0;
}

std::vector<fs::path> own_libraries(const ExternalRun& external, const CaseDefinition& definition) {
  // Nothing lies in the fresh directory in which a program starts: /dev/null has nothing either.
  LibrarySearch search(external.directory.empty() ? "/dev/null" : external.directory);
  const Needs of_all = needs_of_all();
  std::vector<fs::path> programs{external_program(external, definition)};
  for (InputFile& input : external_inputs(external, definition)) programs.push_back(input.file);
  for (const fs::path& program : programs) search.add_needs_of(program, of_all);
  return search.found();
}

}  // namespace slosh
