// What gnuplot drew for earlier reports of a campaign, so that a report after a small change draws
// only what that changes. A drawing is kept under its script, which holds the data, and under the
// gnuplot that drew it.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <string>

namespace slosh {

class KnownDrawings {
 public:
  // Keeps them in this directory, which need not be there yet.
  explicit KnownDrawings(std::filesystem::path directory);

  // A reports::Gnuplot: what was kept, else what gnuplot draws now. A kept file that was cut short
  // or changed is drawn anew.
  std::string draw(const std::string& script, const std::string& figure_id,
                   const std::filesystem::path& scratch_directory);

  // Keeps the drawings that were asked for and removes all others; files that are no drawings stay.
  // It is called once the report is complete: a drawing that breaks off must not be kept. Throws
  // std::filesystem::filesystem_error where the directory cannot be written.
  void write() const;

 private:
  std::filesystem::path directory_;
  std::string gnuplot_;                       // path, size and time of the program
  std::mutex mutex_;                          // of the two below
  std::set<std::string> taken_;               // names of kept files that were asked for
  std::map<std::string, std::string> drawn_;  // by the name that the file will have
};

}  // namespace slosh
