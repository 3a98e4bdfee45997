// Where results lie, by the key of all that determined them (run_key.hpp, problem_key()):
//   <root>/<question>/<answer>.h5            a run's result; .json: a problem's
//   <root>/<question>/<answer>.work/         what its solver leaves beside it
//   <root>/<question>/<answer>.timings.json  what repeats took (timings.hpp)
//   <root>/<question>/<answer>.failure.json  why it failed when it was last tried (run_failure.hpp)
//   <root>/<question>/<answer>.lock          held by whoever computes it
//   <root>/costs.txt                         what runs took of what was estimated
//                                            (campaign/cost_records.hpp)
// so that campaigns share what they have in common, and one that asks for what another computes
// waits for that.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "verification/files/file_lock.hpp"

namespace slosh {

class ResultStore {
 public:
  explicit ResultStore(std::filesystem::path root) : root_(std::move(root)) {}

  const std::filesystem::path& root() const { return root_; }

  // `extension` with its dot. The key has the form "question-answer".
  std::filesystem::path file(const std::string& key, const char* extension) const;

  // That of the key, or else the newest that answers the same question; nothing where none is.
  std::optional<std::filesystem::path> newest_file(const std::string& key,
                                                   const char* extension) const;

  // The keys under which something lies, sorted. Files that no key names are none of the store's.
  std::vector<std::string> keys() const;

  // Of all that lies under the key [byte].
  std::uintmax_t size(const std::string& key) const;

  // Removes all that lies under the key but its lock, which whoever waits for the key may have open
  // already. False, and nothing is removed, where a process holds the key.
  bool remove(const std::string& key) const;

 private:
  std::vector<std::filesystem::path> contents(const std::string& key) const;

  std::filesystem::path root_;
};

// Holds a key of the store for this process alone until it goes, and clears away what a process
// that died there has half written. Waits for whoever holds it. Throws
// std::filesystem::filesystem_error.
class StoreLock {
 public:
  StoreLock(const ResultStore& store, const std::string& key,
            const std::function<void()>& waiting = {});

 private:
  FileLock lock_;
};

}  // namespace slosh
