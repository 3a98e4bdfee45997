// Reads a text file of values over time line by line, so that every mistake is reported with its
// line. The readers of the project's own tables and of other programs' files share it.
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
  // Starts at the first line, which is empty if the file is empty or cannot be read.
  explicit TableReader(const std::filesystem::path& file);

  // Goes to the next line. Returns false at the end, where the line is empty.
  bool next();

  const std::string& line() const { return line_; }  // without its end, be that "\n" or "\r\n"
  // Whether the line has no end, as after a program that was stopped while writing.
  bool is_cut() const { return stream_.eof() && !line_.empty(); }
  int line_number() const { return line_number_; }
  const std::filesystem::path& file() const { return file_; }

  // Returns a finite number. Throws CaseFileError.
  double number(std::string_view column, std::string_view text, std::string_view unit) const;

  // Appends a time. Throws CaseFileError unless it is greater than the last one.
  void add_time(std::string_view column, std::string_view text, std::string_view unit,
                std::vector<double>& times) const;

  // Throws CaseFileError, "file:line: key = value: expected EXPECTED", for the current line.
  [[noreturn]] void refuse(std::string_view key, std::string_view value,
                           std::string_view expected) const;

 private:
  std::filesystem::path file_;
  std::ifstream stream_;
  std::string line_;
  int line_number_ = 0;
};

// Returns the text without blanks at its ends.
std::string_view trimmed(std::string_view text);

// Returns the error for a mistake on a line of a table.
CaseFileError table_error(const std::filesystem::path& file, int line, std::string_view key,
                          std::string_view value, std::string_view expected);

}  // namespace slosh
