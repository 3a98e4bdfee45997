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

#include <filesystem>
#include <optional>
#include <string>

#include "verification/engine/file_lock.hpp"

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

 private:
  std::filesystem::path root_;
};

// Holds a key of the store for this process alone until it goes, and clears away what a process
// that died there has half written. Waits for whoever holds it. Throws
// std::filesystem::filesystem_error.
class StoreLock {
 public:
  StoreLock(const ResultStore& store, const std::string& key);

 private:
  FileLock lock_;
};

}  // namespace slosh
