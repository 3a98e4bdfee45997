#include "verification/campaign/known_drawings.hpp"

#include <fmt/format.h>

#include <system_error>

#include "reports/drawing/gnuplot_script.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/own_files.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

// Identifies the program by its path, size and time: a replaced program differs in one of them.
std::string identity_of(const fs::path& program) {
  std::error_code absent;
  const fs::path file = fs::canonical(program, absent);
  if (absent) return "";
  return fmt::format("{} {} {}\n", file.string(), fs::file_size(file),
                     fs::last_write_time(file).time_since_epoch().count());
}

}  // namespace

KnownDrawings::KnownDrawings(fs::path directory)
    : directory_(std::move(directory)), gnuplot_(identity_of(reports::gnuplot_program())) {}

std::string KnownDrawings::draw(const std::string& script, const std::string& figure_id,
                                const fs::path& scratch_directory) {
  const std::string name = content_hash(gnuplot_ + script) + ".svg";
  const fs::path file = directory_ / name;
  if (std::error_code none; !foreign_at(file) && fs::file_size(file, none) > 0 && !none) {
    const std::lock_guard lock(mutex_);
    taken_.insert(name);
    return read_bytes(file);
  }
  std::string drawing = reports::run_gnuplot(script, figure_id, scratch_directory);
  const std::lock_guard lock(mutex_);
  return drawn_[name] = std::move(drawing);
}

void KnownDrawings::write() const {
  for (const auto& [name, drawing] : drawn_)
    if (!foreign_at(directory_ / name)) replace_own(directory_ / name, drawing);
  if (!fs::exists(directory_)) return;
  for (const auto& entry : fs::directory_iterator(directory_))
    if (entry.path().extension() == ".svg" && !drawn_.contains(entry.path().filename().string()) &&
        !taken_.contains(entry.path().filename().string()) && !foreign_at(entry.path()))
      fs::remove(entry.path());
}

}  // namespace slosh
