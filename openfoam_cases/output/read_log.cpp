#include "openfoam_cases/output/read_log.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>

#include "openfoam_cases/errors.hpp"

namespace slosh::openfoam {
namespace {

constexpr std::size_t last_lines = 12;  // of a log that gives no reason
// An error message has its place, its reason, and often a list of all valid words.
constexpr std::size_t failure_lines = 100;

constexpr const char* warning = "a warning";

// Returns the number if all of `text` is one.
std::optional<double> whole_number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<double> number_after(std::string_view line, std::string_view label) {
  const auto at = line.find(label);
  if (at == std::string_view::npos) return std::nullopt;
  line.remove_prefix(at + label.size());
  return whole_number(line.substr(0, line.find_first_of(" ,")));
}

bool is_blank(std::string_view line) {
  return line.find_first_not_of(" \t\r") == std::string_view::npos;
}

}  // namespace

void LogReader::read_line(std::string_view line) {
  if (is_blank(line)) return;
  last_lines_.emplace_back(line);
  if (last_lines_.size() > last_lines) last_lines_.pop_front();
  read_failure(line);
  read_numbers(line);
  if (line == "End") ended_ = true;
}

void LogReader::read_failure(std::string_view line) {
  const bool fatal = line.find("FOAM FATAL") != line.npos;
  if (fatal && failure_ == warning) {  // an error counts more than the warning before it
    failure_.clear();
    failure_lines_.clear();
  }
  // A warning's second line says which function warns.
  if (failure_ == warning && failure_lines_.size() == 1 &&
      line.find("isoCutFace::cutPoints") != line.npos) {
    ++faces_in_interface_;
    failure_.clear();
    failure_lines_.clear();
    return;
  }
  if (!failure_.empty()) {
    if (failure_lines_.size() < failure_lines) failure_lines_.emplace_back(line);
    return;
  }
  if (line.find("Foam::sigFpe") != line.npos) {  // the banner does not contain this word
    failure_ = "a floating-point exception: the solution diverged";
    failure_lines_ = last_lines_;  // the steps before it say more than the stack trace after it
  } else if (fatal) {
    failure_ = "a fatal error";
  } else if (line.find("FOAM Warning") != line.npos) {
    failure_ = warning;
  }
  if (!failure_.empty() && failure_lines_.empty()) failure_lines_.emplace_back(line);
}

void LogReader::read_numbers(std::string_view line) {
  if (line.starts_with("Time = ")) {
    // The acceleration's line begins in the same way but continues after the number.
    if (const auto time = whole_number(line.substr(7))) {
      time_ = *time;
      if (++steps_ == 3) third_step_time_ = time_;
    }
  } else if (line.starts_with("Courant Number")) {
    max_courant_number_ =
        std::max(max_courant_number_, number_after(line, "max: ").value_or(max_courant_number_));
  } else if (line.find("Solving for p_rgh") != line.npos) {
    pressure_iterations_ += number_after(line, "No Iterations ").value_or(0);
  } else if (const auto build = line.find("OPENFOAM="); build != line.npos && version_.empty()) {
    version_ = line.substr(build + 9, line.find(' ', build) - build - 9);
  }
}

double LogReader::mean_pressure_iterations() const {
  return steps_ > 0 ? pressure_iterations_ / steps_ : 0;
}

std::string LogReader::failure() const {
  if (!failure_.empty()) return failure_;
  return ended_ ? "" : "no line \"End\": it stopped before it had finished";
}

std::string LogReader::meaningful_lines() const {
  return fmt::format("{}", fmt::join(failure_lines_.empty() ? last_lines_ : failure_lines_, "\n"));
}

LogReader read_log(const std::filesystem::path& log) {
  std::ifstream file(log);
  if (!file) throw RunError(fmt::format("{}: the log cannot be read", log.string()));
  LogReader reader;
  for (std::string line; std::getline(file, line);) reader.read_line(line);
  return reader;
}

}  // namespace slosh::openfoam
