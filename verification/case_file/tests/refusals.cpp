#include "verification/case_file/tests/refusals.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <vector>

#include "verification/tests/trial_case.hpp"

namespace slosh {
namespace {

std::vector<std::string> split(const std::string& text, const std::string& at) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end; (end = text.find(at, begin)) != text.npos; begin = end + at.size())
    parts.push_back(text.substr(begin, end - begin));
  parts.push_back(text.substr(begin));
  return parts;
}

// The rows of a table, with the lines that go on with a row joined to it.
std::vector<std::string> rows_of(const std::string& table) {
  std::vector<std::string> rows;
  for (const std::string& line : split(table, "\n")) {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == line.npos) continue;
    if (begin == 0)
      rows.push_back(line);
    else
      rows.at(rows.size() - 1) += " " + line.substr(begin);
  }
  return rows;
}

// Where a key stands, or would stand, in a file's lines, which count from 0.
struct Place {
  std::string key;
  std::size_t head = 0;           // of its table; of the first line for a key of no table
  std::size_t line = 0, end = 0;  // the key's own line, `end` of the table where it has none
};

// "[[run]]" -> "run"; "" of any other line.
std::string opened_table(const std::string& line) {
  if (!line.starts_with('[')) return "";
  const std::size_t begin = line.find_first_not_of('['), end = line.find(']');
  return line.substr(begin, end - begin);
}

Place place_in_table(const std::vector<std::string>& lines, const std::string& key,
                     std::size_t head, std::size_t first) {
  Place place{key, head, 0, first};
  while (place.end < lines.size() && opened_table(lines[place.end]).empty() &&
         !(lines[place.end].empty() && place.end + 1 == lines.size()))
    ++place.end;
  place.line = first;
  while (place.line < place.end && !lines[place.line].starts_with(key + " = ")) ++place.line;
  return place;
}

Place place_of(const std::vector<std::string>& lines, const std::string& path) {
  for (std::size_t dot = path.rfind('.'); dot != path.npos && dot > 0;
       dot = path.rfind('.', dot - 1)) {
    std::string table = path.substr(0, dot), name;
    if (const std::size_t bracket = table.find('('); bracket != table.npos) {
      name = "name = \"" + table.substr(bracket + 1, table.size() - bracket - 2) + "\"";
      table.erase(bracket);
    }
    for (std::size_t head = lines.size(); head-- > 0;)
      if (opened_table(lines[head]) == table && (name.empty() || lines.at(head + 1) == name))
        return place_in_table(lines, path.substr(dot + 1), head, head + 1);
  }
  return place_in_table(lines, path, 0, 0);
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) text += (i ? "\n" : "") + lines[i];
  return text;
}

void change(std::vector<std::string>& lines, const std::string& path, const std::string& value) {
  const Place place = place_of(lines, path);
  const auto at = lines.begin() + static_cast<std::ptrdiff_t>(place.line);
  const bool is_there = place.line < place.end;
  if (value.empty() && !is_there) throw std::logic_error("no such key: " + path);
  const std::string line = place.key + " = " + value;
  if (value.empty())
    lines.erase(at);
  else if (is_there)
    *at = line;
  else
    lines.insert(at, line);
}

// "run(mesh).cells_x" -> "run.cells_x".
std::string without_name(std::string path) {
  const std::size_t begin = path.find('('), end = path.find(").");
  return end == path.npos ? path : path.erase(begin, end + 1 - begin);
}

// The subject as the message gives it, behind the line on which the parser says that it stands.
std::string with_line(const std::string& text, const std::string& subject) {
  const std::vector<std::string> lines = split(text, "\n");
  const std::string path = subject.substr(0, subject.find(' '));
  std::size_t line = 0;
  for (std::size_t head = lines.size(); head-- > 0 && !line;)
    if (opened_table(lines[head]) == path) line = head + 1;
  for (std::size_t end = path.size(); !line && end != path.npos; end = path.rfind('.', end - 1)) {
    const Place place = place_of(lines, path.substr(0, end));
    if (place.line < place.end) line = place.line + 1;
  }
  if (!line) line = place_of(lines, path).head + 1;
  return "trial.toml:" + std::to_string(line) + ": " + without_name(path) +
         subject.substr(path.size());
}

std::filesystem::path written(const Workspace& workspace, const Trial& trial,
                              const std::string& text) {
  for (const auto& [name, content] : trial.files) workspace.write(name, content);
  return workspace.write("trial.toml", text);
}

std::string complaint_of(const Trial& trial, const std::string& text) {
  const Workspace workspace;
  const std::filesystem::path file = written(workspace, trial, text);
  return trial.complaint ? trial.complaint(file) : complaint(file, workspace.path());
}

// The message begins with `wanted`, whose parts between " ... " follow each other in it.
void expect_message(const std::string& message, const std::string& wanted) {
  const std::vector<std::string> parts = split(wanted, " ... ");
  std::size_t at = message.starts_with(parts[0]) ? 0 : message.npos;
  for (const std::string& part : parts)
    if (at != message.npos) at = message.find(part, at);
  EXPECT_NE(at, message.npos) << "got:    " << message << "\nwanted: " << wanted;
  EXPECT_EQ(message.find('\n'), message.npos) << "one mistake is told of once: " << message;
}

}  // namespace

std::string with_keys(std::string text, const std::string& changes) {
  if (changes.empty()) return text;
  std::vector<std::string> lines = split(text, "\n");
  for (const std::string& one : split(changes, " & ")) {
    const std::size_t missing = one.find(" is missing"), equals = one.find(" = ");
    if (missing == one.npos && equals == one.npos) throw std::logic_error("no change: " + one);
    if (missing == one.npos)
      change(lines, one.substr(0, equals), one.substr(equals + 3));
    else
      change(lines, one.substr(0, missing), "");
  }
  return joined(lines);
}

CaseDefinition read_trial(const Trial& trial) {
  const Workspace workspace;
  return read_case(written(workspace, trial, trial.text), workspace.path());
}

void expect_refusals(const Trial& trial, const std::string& rows) {
  std::string base = trial.text;
  for (const std::string& row : rows_of(rows)) {
    SCOPED_TRACE(row);
    if (row.starts_with("+ ")) {
      base = trial.text;
      for (const std::string& one : split(row.substr(2), " + "))
        base = trial.tables.contains(one) ? base + trial.tables.at(one) : with_keys(base, one);
      continue;
    }
    const std::size_t end = std::min(row.find(": expected"), row.find(": accepted"));
    if (end == row.npos) throw std::logic_error("no row: " + row);
    std::vector<std::string> told = split(" " + row.substr(0, end), " -> ");
    const std::string text = with_keys(base, told.front().erase(0, 1));
    if (row.substr(end) == ": accepted")
      EXPECT_EQ(complaint_of(trial, text), "");
    else
      expect_message(complaint_of(trial, text),
                     with_line(text, split(told.back(), " & ").back()) + row.substr(end));
  }
}

void expect_refusals_of(const std::string& file, const Trial& trial, const std::string& rows) {
  for (const std::string& row : rows_of(rows)) {
    SCOPED_TRACE(row);
    const std::size_t arrow = row.find("-> ");
    std::string content;
    for (const std::string& line : split(row.substr(0, arrow), " | "))
      content += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    Trial other = trial;
    other.files[file] = content == "\n" ? "" : content;
    expect_message(complaint_of(other, trial.text), file + ":" + row.substr(arrow + 3));
  }
}

}  // namespace slosh
