// A cache of gnuplot's drawings for the reports of a campaign, so that a report after a small
// change draws only the figures that have changed. The key of a drawing is its script, which holds
// the data, and the gnuplot program.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <string>

namespace slosh {

class KnownDrawings {
 public:
  // Keeps the drawings in this directory, which need not exist yet.
  explicit KnownDrawings(std::filesystem::path directory);

  // Returns the cached drawing, or else draws it now; a reports::Gnuplot. A cached file that was
  // cut short or changed (files/own_files.hpp) is drawn again and stays.
  std::string draw(const std::string& script, const std::string& figure_id,
                   const std::filesystem::path& scratch_directory);

  // Writes the drawings that were asked for and removes all others; files of other kinds stay. It
  // is called once the report is complete, so that no half-finished drawing is kept. Throws
  // std::filesystem::filesystem_error where the directory cannot be written.
  void write() const;

 private:
  std::filesystem::path directory_;
  std::string gnuplot_;                       // path, size and time of the program
  std::mutex mutex_;                          // guards the two below
  std::set<std::string> taken_;               // names of cached files that were asked for
  std::map<std::string, std::string> drawn_;  // by the name that the file will have
};

}  // namespace slosh
