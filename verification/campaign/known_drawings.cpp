#include "verification/campaign/known_drawings.hpp"

#include <fmt/format.h>

#include <optional>
#include <system_error>

#include "reports/drawing/run_gnuplot.hpp"
#include "verification/files/atomic_file.hpp"
#include "verification/files/content_hash.hpp"

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

// A cached file has the hash of the drawing, then the drawing.
std::string guarded(const std::string& drawing) { return content_hash(drawing) + drawing; }

std::optional<std::string> drawing_in(const fs::path& file) try {
  const std::string content = read_bytes(file);
  const std::size_t digits = content_hash("").size();
  if (content.size() < digits) return std::nullopt;
  std::string drawing = content.substr(digits);
  return guarded(drawing) == content ? std::optional(std::move(drawing)) : std::nullopt;
} catch (const fs::filesystem_error&) {
  return std::nullopt;
}

}  // namespace

KnownDrawings::KnownDrawings(fs::path directory)
    : directory_(std::move(directory)), gnuplot_(identity_of(reports::gnuplot_program())) {}

std::string KnownDrawings::draw(const std::string& script, const std::string& figure_id,
                                const fs::path& scratch_directory) {
  const std::string name = content_hash(gnuplot_ + script);
  if (std::optional<std::string> drawing = drawing_in(directory_ / name)) {
    const std::lock_guard lock(mutex_);
    taken_.insert(name);
    return std::move(*drawing);
  }
  std::string drawing = reports::run_gnuplot(script, figure_id, scratch_directory);
  const std::lock_guard lock(mutex_);
  return drawn_[name] = std::move(drawing);
}

void KnownDrawings::write() const {
  fs::create_directories(directory_);
  for (const auto& entry : fs::directory_iterator(directory_)) {
    const std::string name = entry.path().filename().string();
    // The directory may hold files of the user.
    if (!taken_.contains(name) && drawing_in(entry.path())) fs::remove(entry.path());
  }
  for (const auto& [name, drawing] : drawn_)
    replace_file(directory_ / name, guarded(drawing), Durability::process_crash);
}

}  // namespace slosh
