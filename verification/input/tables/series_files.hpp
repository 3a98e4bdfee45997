// The files of one series that a program wrote in several runs, each of which goes on from the
// last.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace slosh {

// Returns the files in the order of their times: the file itself; or, as OpenFOAM leaves them,
// those in the time folders of a directory. Such a directory is named alone,
// "postProcessing/height", where its time folders hold files of one name, or with that name,
// "postProcessing/forces/force.dat" for .../forces/0/force.dat and .../forces/5/force.dat.
// "force_5.dat" beside "force.dat" is a later part of it. Returns none where there is no such file.
// Throws CaseFileError where a directory is named whose time folders hold files of several names.
std::vector<std::filesystem::path> series_files(const std::filesystem::path& file);

// Returns what lies at a path where a file is expected: "PATH is a directory" or "there is no
// PATH".
std::string no_file_at(const std::filesystem::path& path);

}  // namespace slosh
