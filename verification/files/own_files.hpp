// What Slosh has made, and may therefore replace or remove without being asked. Each directory has
// a list of it, the file ".slosh", with a line "IDENTITY NAME" for each file and link: the hash of
// the content, or of where the link leads. What is not there as the list says is a user's: it was
// edited, or another file, or it came with a list that names another content. While a file or a
// directory is open to a program, "*" and the list's own inode stand for the identity, so that no
// list that was copied opens anything. A directory is Slosh's where all that lies in it is.
//
// Slosh names most outputs itself, below a directory that the user names. None of these lies behind
// a link below it: whoever takes a path from the user resolves its links once (whole() of
// cli/installation.hpp).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace slosh {

// Returns what Slosh has not made: what lies there or, at any depth, in it. An empty file or
// directory is nobody's.
std::optional<std::filesystem::path> foreign_at(const std::filesystem::path& path);

// Throws std::filesystem::filesystem_error where the path leads through a link or where something
// foreign lies there, and OutputError (protected_inputs.hpp) where an input of this process does.
void require_own(const std::filesystem::path& path);

// Replaces a file that Slosh names. Throws as require_own() and replace_file() do.
void replace_own(const std::filesystem::path& file, std::string_view content);

// Makes or replaces a link in the same way.
void link_own(const std::filesystem::path& target, const std::filesystem::path& link);

// Puts all that lies in a directory that Slosh has just made on the lists.
void list_all_in(const std::filesystem::path& directory);

// Files and directories that programs and other functions may write, replace and remove while this
// object lives. Its destructor lists what they have left.
class OpenOutputs {
 public:
  // Of those that Slosh names. Throws as require_own() does.
  explicit OpenOutputs(std::vector<std::filesystem::path> paths)
      : OpenOutputs(std::move(paths), std::string()) {}
  // Of a file that the user names for the output of a command. Its links are followed; devices and
  // pipes are not listed; what another command has left is foreign.
  OpenOutputs(const std::filesystem::path& file, const char* command);
  OpenOutputs(const OpenOutputs&) = delete;
  OpenOutputs& operator=(const OpenOutputs&) = delete;
  ~OpenOutputs();

 private:
  OpenOutputs(std::vector<std::filesystem::path> paths, std::string command);

  std::vector<std::filesystem::path> paths_;
  std::vector<std::filesystem::path> new_lists_;  // of directories that had none
  std::string command_;
};

// Replaces such a file by this content.
void replace_named(const std::filesystem::path& file, std::string_view content,
                   const char* command);

}  // namespace slosh
