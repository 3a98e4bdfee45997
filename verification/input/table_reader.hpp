// A text file of values over time, read line by line, so that whatever is wrong is told with its
// line: what the readers of the project's own tables and of other programs' share.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "verification/input/case_file_error.hpp"

namespace slosh {

class TableReader {
 public:
  // Stands on the first line; on an empty one of a file that is empty or cannot be read.
  explicit TableReader(const std::filesystem::path& file);

  // Goes to the next line; false at the end, where the line is empty.
  bool next();

  const std::string& line() const { return line_; }  // without its end, be that "\n" or "\r\n"
  // Whether nothing ends the line, as where a program was stopped while it wrote.
  bool is_cut() const { return stream_.eof() && !line_.empty(); }
  int line_number() const { return line_number_; }
  const std::filesystem::path& file() const { return file_; }

  // A finite number. Throws CaseFileError.
  double number(std::string_view column, std::string_view text, std::string_view unit) const;

  // Adds a time that must lie above the last one. Throws CaseFileError.
  void add_time(std::string_view column, std::string_view text, std::string_view unit,
                std::vector<double>& times) const;

  // Throws CaseFileError, "file:line: key = value: expected EXPECTED", of the present line.
  [[noreturn]] void refuse(std::string_view key, std::string_view value,
                           std::string_view expected) const;

 private:
  std::filesystem::path file_;
  std::ifstream stream_;
  std::string line_;
  int line_number_ = 0;
};

// The text without blanks at its ends.
std::string_view trimmed(std::string_view text);

// What is wrong on a line of a table.
CaseFileError table_error(const std::filesystem::path& file, int line, std::string_view key,
                          std::string_view value, std::string_view expected);

}  // namespace slosh
