// The store of results, by the key of everything that determined them (run_key.hpp, problem_key()):
//   <root>/<question>/<answer>.h5            a run's result; .json: a problem's
//   <root>/<question>/<answer>.work/         other files of its solver
//   <root>/<question>/<answer>.timings.json  costs of repeats (timings.hpp)
//   <root>/<question>/<answer>.failure.json  why it failed when it was last tried (run_failure.hpp)
//   <root>/<question>/<answer>.lock          held by whoever computes it
//   <root>/costs.txt                         costs of runs by their kind
//                                            (runs/expected_cost.hpp)
// Campaigns share the results that they have in common, and one that needs a result which another
// is computing waits for it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "verification/files/file_lock.hpp"

namespace slosh {

struct StoreContents {
  // Sealed results that hold the key, other sealed files, and what a solver has left beside the
  // key's lock.
  std::vector<std::filesystem::path> made;
  std::uintmax_t size = 0;                     // of these [byte]
  std::vector<std::filesystem::path> foreign;  // what has such a name and is none of these
};

class ResultStore {
 public:
  explicit ResultStore(std::filesystem::path root) : root_(std::move(root)) {}

  const std::filesystem::path& root() const { return root_; }

  // Returns the file of the key; `extension` has its dot. The key has the form "question-answer".
  std::filesystem::path file(const std::string& key, const char* extension) const;

  // Returns the same, where none of the key's files nor their directory is a link, through which
  // files outside the store would be written. Throws ResultError otherwise.
  std::filesystem::path file_without_links(const std::string& key, const char* extension) const;

  // Returns the file of the key, or else the newest that answers the same question, or nullopt.
  std::optional<std::filesystem::path> newest_file(const std::string& key,
                                                   const char* extension) const;

  // Returns the keys that have files, sorted. Files that no key names do not belong to the store.
  std::vector<std::string> keys() const;

  // Returns the files of all results.
  std::vector<std::filesystem::path> results() const;

  // Returns the size of all files of the key [byte].
  std::uintmax_t size(const std::string& key) const;

  // Returns what is under the key except its lock. Reads the files.
  StoreContents contents(const std::string& key) const;

  // Removes what the store has made under the key. The lock stays, as a waiting process may already
  // have it open. Returns false, and removes nothing, where a process holds the key.
  bool remove(const std::string& key) const;

 private:
  std::vector<std::filesystem::path> paths(const std::string& key) const;
  bool has_made(const std::string& key, const std::filesystem::path& path) const;

  std::filesystem::path root_;
};

// Throws ResultError unless the key is the one that the file's place in the store names.
void require_key_of_place(const std::string& key, const std::filesystem::path& file);

// Returns the result in a file of the store, which `read` reads. Throws ResultError where it cannot
// be used: a result that was copied there from the place of another key is none.
template <class Read>
auto read_stored(const std::filesystem::path& file, const Read& read) {
  auto result = read(file);
  require_key_of_place(result.key, file);
  return result;
}

// Holds a key of the store for this process alone during its lifetime, and removes the half-written
// files of a process that died there. Waits for another process that holds the key. Throws as
// file_without_links() does, and std::filesystem::filesystem_error.
class StoreLock {
 public:
  StoreLock(const ResultStore& store, const std::string& key,
            const std::function<void()>& waiting = {});

 private:
  FileLock lock_;
};

}  // namespace slosh
