// The codes for which a case can be written, one row each. A new code needs a row in peer_codes.cpp
// and a file NAME_case.cpp, or a folder of this name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/peers/written_files.hpp"

namespace slosh {

struct PeerCode {
  const char* name;   // as in `--for`
  const char* title;  // of the code
  // Writes all files into an empty directory. Throws CaseFileError for a case that the code cannot
  // say, with the place of the key.
  void (*write)(const HandedCase& handed, const std::filesystem::path& directory);
  bool takes_outline = false;  // whether it can say a tank that is no rectangle
};

const std::vector<PeerCode>& peer_codes();
std::vector<std::string> peer_code_names();

// Writes the case into the directory `handed.place`, which is made whole or not at all, and must be
// absent or empty. Throws CaseFileError as PeerCode::write does, and
// std::filesystem::filesystem_error.
void write_for_code(const std::string& name, const HandedCase& handed);

}  // namespace slosh
