// The seals of stored results, taken before programs of the user's run. Such a program runs as the
// same user and can write to the store; a result that it has changed or sealed anew is found by its
// seal, for no result changes once it is made.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace slosh {

class ResultSeals {
 public:
  // Reads the end of each file, which holds the seal (sealed_file.hpp, sealed_json.hpp). Files that
  // cannot be read are left out.
  explicit ResultSeals(const std::vector<std::filesystem::path>& files);

  // Removes the files whose seal is another now, so that no later start takes them, and throws
  // ResultError where there are any. A file that is no longer there is none of them.
  void require_unchanged() const;

 private:
  std::map<std::filesystem::path, std::string> seals_;
};

}  // namespace slosh
