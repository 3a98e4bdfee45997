// Mistakes in case files as a table, each a line that reads as the parser's own message.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "verification/case_file/case_parser.hpp"

namespace slosh {

// A case file's text and the files beside it, which are those of its experiments too.
struct Trial {
  Trial(std::string text, std::map<std::string, std::string> files = {},
        std::map<std::string, std::string> tables = {})
      : text(std::move(text)), files(std::move(files)), tables(std::move(tables)) {}

  std::string text;
  std::map<std::string, std::string> files;
  std::map<std::string, std::string> tables;  // which rows may add to the text, by their names
  // What the reader says of the file, without its directory; by default, what that of cases says.
  std::function<std::string(const std::filesystem::path&)> complaint = {};
};

// Returns the text with keys that are set or taken out: "gate.limit = 1 & gate.unit is missing". A
// key is of the last table of that name, or of the one whose name stands in brackets,
// "run(mesh).cells_x = 1"; a new key ends its table.
std::string with_keys(std::string text, const std::string& changes);

// Reads the case with its files.
CaseDefinition read_trial(const Trial& trial);

// Expects the parser to say of each row's changes, in one line, what the row says. A row is
//   CHANGES [-> SUBJECT]: expected WORDS ... FURTHER WORDS
// and the message begins "trial.toml:LINE: SUBJECT: expected WORDS", with the line of the subject's
// key or table and, unless the row says otherwise, the last change for the subject. A row that ends
// ": accepted" is read without a complaint. An indented line goes on with the row above. The rows
// below "+ NAME + CHANGES" are of the text with this table and these changes.
void expect_refusals(const Trial& trial, const std::string& rows);

// The same of a file beside the case, whose lines stand in place of the changes: "HEAD | 0,1 | 1,2
// -> 3: rows = 2: ...", where 3 is the line of that file that the message names.
void expect_refusals_of(const std::string& file, const Trial& trial, const std::string& rows);

}  // namespace slosh
