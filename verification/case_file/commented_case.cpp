#include <algorithm>
#include <set>
#include <sstream>

#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/groups.hpp"
#include "verification/case_file/key_table.hpp"
#include "verification/input/rules.hpp"
#include "verification/input/toml_reader.hpp"

namespace slosh {
namespace {

// The lines of a file from a table's head to the next one.
struct Block {
  int line;          // of the head; 0: the top level, which has none
  std::string head;  // "[[run]]"
  std::vector<std::string> lines;
  std::vector<int> numbers;  // of the lines in the file
};

// A line of a list that runs over several begins with a bracket too, and goes on with no name.
std::string head_of(const std::string& line) {
  const std::size_t name = line.find_first_not_of('[');
  const bool is_head = name > 0 && name != line.npos && line[name] >= 'a' && line[name] <= 'z';
  return is_head ? line.substr(0, line.rfind(']', line.find('#')) + 1) : "";
}

std::vector<Block> blocks_of(const std::string& text) {
  std::vector<Block> blocks{{0, "", {}, {}}};
  std::istringstream stream(text);
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (const std::string head = head_of(line); !head.empty())
      blocks.push_back({number, head, {}, {}});
    else if (!line.empty()) {
      blocks.back().lines.push_back(line);
      blocks.back().numbers.push_back(number);
    }
  }
  return blocks;
}

// Returns the key of a line "key = value", or an empty text.
std::string key_of(const std::string& line) {
  const std::size_t end = line.find(" = ");
  return line.starts_with('#') || end == std::string::npos ? "" : line.substr(0, end);
}

// Breaks a text into comment lines of at most 100 columns.
std::string comment(const std::string& text) {
  constexpr std::size_t columns = 100;
  std::istringstream stream(text);
  std::string lines, line = "#";
  for (std::string word; stream >> word;) {
    if (line.size() + 1 + word.size() > columns) {
      lines += line + "\n";
      line = "#";
    }
    line += " " + word;
  }
  return lines + line + "\n";
}

const RunDefinition& kept_simulation(const CaseDefinition& like) {
  const RunDefinition* kept = nullptr;
  bool is_judged = false;
  for (const RunDefinition& run : like.runs) {
    if (!solver_kind(run).has_particles || !run.ensemble.empty() || run.at_input) continue;
    const bool judged = std::any_of(like.gate.begin(), like.gate.end(), [&](const GateRow& row) {
      return row.candidate == run.name && row.limit;
    });
    if (kept &&
        (is_judged > judged || (is_judged == judged && resolution(*kept) <= resolution(run))))
      continue;
    kept = &run;
    is_judged = judged;
  }
  if (!kept)
    throw CaseFileError(
        like.file.string() +
        ": run: expected an SPH run that is no ensemble, to be kept in the new case");
  return *kept;
}

bool is_shipped_record(const RunDefinition& run) {
  const auto* record = std::get_if<RecordRun>(&run.solver);
  return record && record->supplied && !record->earlier_run;
}

// What stays of the case's runs and gate rows.
struct Kept {
  std::string candidate;
  std::set<std::string> runs;
  std::set<int> lines;  // of their tables, or of their limits in a group of rows, in the file
  std::set<int> with_reference;  // of these, the lines of the rows that have a reference
};

Kept kept_parts(const CaseDefinition& like) {
  Kept kept;
  const std::string& candidate = kept.candidate = kept_simulation(like).name;
  for (const RunDefinition& run : like.runs) {
    if (!is_theory(run) && !is_shipped_record(run) && run.name != candidate) continue;
    kept.runs.insert(run.name);
    kept.lines.insert(run.where.line);
  }
  for (const GateRow& row : like.gate) {
    const bool has_runs = (row.reference.empty() || kept.runs.contains(row.reference)) &&
                          (!row.improves_on || kept.runs.contains(*row.improves_on));
    if (row.candidate != candidate || !has_runs || is_cost(row.metric)) continue;
    kept.lines.insert(row.where.line);
    if (!row.reference.empty()) kept.with_reference.insert(row.where.line);
  }
  return kept;
}

// Returns the metric of "limits.METRIC = " or "limits.METRIC.KEY = ", or an empty text.
std::string limited_metric(const std::string& line) {
  const std::string key = key_of(line), table = "limits.";
  if (!key.starts_with(table)) return "";
  return key.substr(table.size(), key.find('.', table.size()) - table.size());
}

bool stays(const Block& block, const Kept& kept) {
  const std::set<std::string> left_out{"[[refinement]]", "[[input]]", "[animation]"};
  if (left_out.contains(block.head)) return false;
  const bool is_chosen = block.head == "[[run]]" || block.head == "[[gate]]";
  return !is_chosen || kept.lines.contains(block.line) ||
         std::any_of(block.numbers.begin(), block.numbers.end(),
                     [&](int line) { return kept.lines.contains(line); });
}

// Returns the group of rows with the kept run as its only candidate and with the limits that judge
// that run.
Block narrowed_rows(const Block& block, const Kept& kept) {
  const auto is_referenced = [&](int line) { return kept.with_reference.contains(line); };
  const bool has_reference = is_referenced(block.line) ||
                             std::any_of(block.numbers.begin(), block.numbers.end(), is_referenced);
  std::set<std::string> metrics;
  for (std::size_t i = 0; i < block.lines.size(); ++i)
    if (kept.lines.contains(block.numbers[i])) metrics.insert(limited_metric(block.lines[i]));
  Block narrow{block.line, block.head, {}, {}};
  for (std::size_t i = 0; i < block.lines.size(); ++i) {
    const std::string metric = limited_metric(block.lines[i]);
    if (!metric.empty() && !metrics.contains(metric)) continue;
    if (key_of(block.lines[i]) == "reference" && !has_reference) continue;
    narrow.lines.push_back(key_of(block.lines[i]) == "candidates"
                               ? "candidate = \"" + kept.candidate + "\""
                               : block.lines[i]);
  }
  return narrow;
}

// Returns a table of several runs with the values of the run that is kept.
Block narrowed_run(const Block& block, const TomlTable& group, const Kept& kept) {
  for (const TomlTable& run : runs_of_group(group)) {
    if (!kept.runs.contains(run.written("name"))) continue;
    Block narrow{block.line, block.head, {}, {}};
    const std::vector<std::string> lists = list_keys_of_runs();
    for (const std::string& line : block.lines) {
      const std::string key = key_of(line),
                        value = key.empty() ? "" : line.substr(line.find(" = ") + 3);
      const bool is_own = std::find(lists.begin(), lists.end(), key) != lists.end();
      if (value.starts_with('[') && value.find(']') == value.npos) return block;  // several lines
      const bool is_pattern = key == "name" && value.find('{') != value.npos;
      if (key.empty() || is_own || !(is_pattern || value.starts_with('['))) {
        narrow.lines.push_back(line);
        continue;
      }
      const bool is_text = key != "quick" && value.find('"') != value.npos;
      narrow.lines.push_back(key + " = " + (is_text ? "\"" : "") + run.written(key) +
                             (is_text ? "\"" : ""));
    }
    return narrow;
  }
  return block;
}

// The tables of keys that explain a block: its own and, in a run, that of its solver.
std::vector<const KeyTable*> tables_of(const Block& block) {
  std::string solver;
  for (const std::string& line : block.lines)
    if (key_of(line) == "solver") {
      const std::size_t quote = line.find('"');
      solver = line.substr(quote + 1, line.find('"', quote + 1) - quote - 1);
    }
  std::vector<const KeyTable*> tables;
  for (const KeyTable& table : case_key_tables()) {
    const bool is_own = block.head.empty() ? table.id == "case" : table.heading == block.head;
    const bool is_solvers =
        std::find(table.solvers.begin(), table.solvers.end(), solver) != table.solvers.end();
    if (is_own || is_solvers) tables.push_back(&table);
    if (is_solvers) solver.clear();  // a record's first form is the shipped one
  }
  return tables;
}

bool has_key(const Block& block, const std::string& key) {
  return std::any_of(block.lines.begin(), block.lines.end(),
                     [&](const std::string& line) { return key_of(line) == key; });
}

std::string explanation_of(const KeyEntry& key) {
  return key.name + ": " + key.value.words() + "." + (key.meaning.empty() ? "" : " " + key.meaning);
}

// A line of the block, for a file that lies elsewhere and a case of another name.
std::string moved(const std::string& line, const Block& block, const CaseDefinition& like,
                  const std::string& name) {
  if (block.head.empty() && key_of(line) == "name") return "name = \"" + name + "\"";
  if (key_of(line) != "file") return line;
  const std::size_t begin = line.find('"') + 1, end = line.find('"', begin);
  const std::filesystem::path directory = std::filesystem::absolute(like.file).parent_path();
  return line.substr(0, begin) +
         (directory / line.substr(begin, end - begin)).lexically_normal().string() +
         line.substr(end);
}

// A key is explained where it stands for the first time in the file.
std::string commented(const Block& block, const CaseDefinition& like, const std::string& name,
                      std::set<std::string>& explained) {
  std::string text, rest;
  for (const KeyTable* table : tables_of(block)) {
    if (!block.head.empty() && !table->meaning.empty() && explained.insert(table->id).second)
      text += comment(table->meaning);
    for (const KeyEntry& key : table->keys)
      if (!key.value.is_table() && !has_key(block, key.name) &&
          explained.insert(table->id + "." + key.name).second)
        rest += comment("Not here: " + explanation_of(key));
  }
  if (!block.head.empty()) text += block.head + "\n";
  for (const std::string& line : block.lines) {
    for (const KeyTable* table : tables_of(block))
      for (const KeyEntry& key : table->keys)
        if (key.name == key_of(line) && explained.insert(table->id + "." + key.name).second)
          text += comment(explanation_of(key));
    text += moved(line, block, like, name) + "\n";
  }
  return text + rest;
}

}  // namespace

std::string commented_case(const CaseDefinition& like, const std::string& name) {
  const Rule<std::string> rule = file_safe_name();
  if (!rule.holds(name)) throw CaseFileError("name = \"" + name + "\": expected " + rule.expected);
  const Kept kept = kept_parts(like);
  std::string text = comment("A case like " + like.name +
                             ": change its numbers, then try ./slosh explain. A key that may stand "
                             "here and does not is explained as \"Not here\".");
  bool parent_stays = true;
  const std::vector<TomlTable> groups = TomlTable(like.text, like.file).tables("run");
  std::size_t group = 0;
  std::set<std::string> explained;
  for (Block block : blocks_of(like.text)) {
    const bool is_run = block.head == "[[run]]";
    if (is_run) ++group;
    const bool is_child =
        block.head.find("[run.") != text.npos || block.head.find("[gate.") != text.npos;
    if (!is_child) parent_stays = stays(block, kept);
    if (!parent_stays) continue;
    if (is_run) block = narrowed_run(block, groups.at(group - 1), kept);
    if (block.head == "[[gate]]") block = narrowed_rows(block, kept);
    text += "\n" + commented(block, like, name, explained);
  }
  return text;
}

}  // namespace slosh
