// What Slosh has made, and may therefore replace or remove without being asked. Each directory has
// a list of it, the file ".slosh", with a line "IDENTITY NAME" for each file and link: the hash of
// the content, or of where the link leads, or the size and the time of a file that a program has
// left. What is not there as the list says is a user's: somebody has edited it, a program was
// interrupted, or the list was lost. A directory is Slosh's where all that lies in it is.
//
// What is a user's is never replaced or removed. Where Slosh names the place itself, it is set
// aside: NAME becomes NAME.kept-1, or the next number that is free. A link or a device stays, and
// so does a file whose place the user has named: Slosh refuses to write there.
//
// Slosh names most outputs itself, below a directory that the user names. None of these lies behind
// a link below it: whoever takes a path from the user resolves its links once (whole() of
// cli/command_tree.hpp).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slosh {

// Returns what Slosh has not made: what lies there or, at any depth, in it. An empty directory is
// nobody's.
std::optional<std::filesystem::path> foreign_at(const std::filesystem::path& path);

// Throws std::filesystem::filesystem_error where the path leads through a link or where something
// foreign lies there, and OutputError (protected_inputs.hpp) where an input of this process does.
void require_own(const std::filesystem::path& path);

// Throws in the same way, but not where a file or a directory lies there, which can be set aside.
void require_room(const std::filesystem::path& path);

// Sets aside what is foreign there. Throws as require_room().
void make_room(const std::filesystem::path& path);

// Makes an empty directory for a program and returns it: the first of NAME, NAME-2, NAME-3, ...
// that is free, or in which all is as Slosh has listed it, and so are the files NAME + ending
// beside it, which are removed. Throws std::filesystem::filesystem_error where it cannot be made.
std::filesystem::path make_own_directory(const std::filesystem::path& named,
                                         const std::vector<std::string>& beside = {});

// What this process has set aside or left where it was, a sentence each.
std::vector<std::string> told_of_set_aside();

// Replaces a file that Slosh names, or sets it aside. Throws as require_room() and replace_file().
void replace_own(const std::filesystem::path& file, std::string_view content);

// Makes or replaces a link in the same way.
void link_own(const std::filesystem::path& target, const std::filesystem::path& link);

// Files and directories that programs and other functions write while this object lives. Its
// destructor lists what they have left.
class OpenOutputs {
 public:
  // Of those that Slosh names. Makes room for each.
  explicit OpenOutputs(std::vector<std::filesystem::path> paths);
  // Of a file that the user names for the output of a command. Its links are followed; devices and
  // pipes are not listed; what another command has left is foreign. Throws as require_own().
  OpenOutputs(const std::filesystem::path& file, std::string command);
  OpenOutputs(const OpenOutputs&) = delete;
  OpenOutputs& operator=(const OpenOutputs&) = delete;
  ~OpenOutputs();

  // Sets aside what a user has laid there since.
  void make_room() const;

 private:
  std::vector<std::filesystem::path> paths_;
  std::string command_;
};

// Replaces such a file by this content.
void replace_named(const std::filesystem::path& file, std::string_view content,
                   const char* command);

}  // namespace slosh
