// Reads a text file of values line by line, so that every mistake is reported with its line. All
// tables go through it: the project's own, those of laboratories and those of other programs.
#pragma once

#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include "verification/input/case_file_error.hpp"

namespace slosh {

class TableReader {
 public:
  // Starts at the first line, which is empty if the file is empty or cannot be read. Throws
  // CaseFileError for a text in UTF-16 and for what read_bytes() (files/content_hash.hpp) refuses.
  explicit TableReader(const std::filesystem::path& file);

  // Goes to the next line. Returns false at the end, where the line is empty.
  bool next();

  // Without its end, be that "\n" or "\r\n", and without a byte-order mark at its beginning.
  const std::string& line() const { return line_; }
  // Whether the line has no end, as after a program that was stopped while writing.
  bool is_cut() const { return stream_.eof() && !line_.empty(); }
  int line_number() const { return line_number_; }
  const std::filesystem::path& file() const { return file_; }

  // Returns a finite number. Throws CaseFileError.
  double number(std::string_view column, std::string_view text, std::string_view unit) const;

  // Throws CaseFileError, "file:line: key = value: expected EXPECTED", for the current line.
  [[noreturn]] void refuse(std::string_view key, std::string_view value,
                           std::string_view expected) const;

 private:
  std::filesystem::path file_;
  std::istringstream stream_;
  std::string line_;
  int line_number_ = 0;
};

// Returns the number that is the whole text; it may have a plus sign ("+1.0E+00") and a Fortran
// exponent ("1.0D-02"). It may be infinite or NaN.
std::optional<double> number_in(std::string_view text);

// Whether the text is a number but for a decimal comma, "0,5".
bool has_decimal_comma(std::string_view text);

// Returns the text without blanks and tabs at its ends.
std::string_view trimmed(std::string_view text);

// Returns the error for a mistake on a line of a table. Characters that cannot be seen or that look
// like a blank or a minus sign stand in it by their code points, "<U+00A0>".
CaseFileError table_error(const std::filesystem::path& file, int line, std::string_view key,
                          std::string_view value, std::string_view expected);

}  // namespace slosh
