// A strict view of a TOML file: typed values, each with a rule that it must keep, and no key that
// nobody asked for. Every refusal reads "file:line: key = value: expected EXPECTATION".
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verification/input/case_file_error.hpp"
#include "verification/input/rules.hpp"

namespace slosh {

// An element of an array of texts.
struct PlacedText {
  std::string text;
  SourceLocation where;
};

// One table of the file. A value that is missing, of another type, not finite or against its rule
// throws CaseFileError. An integer serves where a number is expected; nothing else is converted.
class TomlTable {
 public:
  // Throws CaseFileError with file:line:column for what is not TOML.
  TomlTable(std::string_view text, const std::filesystem::path& file);

  // Refuses every other key of this table, naming the nearest of these. Throws CaseFileErrors
  // (complaints.hpp), a message for each.
  void allow_only(const std::vector<std::string>& keys) const;

  // T: double, int, std::string, bool.
  template <class T>
  T get(std::string_view key, const Rule<T>& rule) const;
  template <class T>
  std::optional<T> find(std::string_view key, const Rule<T>& rule) const;
  bool flag(std::string_view key) const;  // false when absent

  // A text that is one of the known; the refusal, CaseFileErrors, names the nearest.
  std::string choice(std::string_view key, std::string_view expected,
                     const std::vector<std::string>& known) const;
  std::vector<PlacedText> texts(std::string_view key, const Rule<std::string>& each) const;
  std::vector<double> numbers(std::string_view key, const Rule<double>& each) const;
  // Strictly increasing; empty when absent.
  std::vector<double> increasing_numbers(std::string_view key, const Rule<double>& each) const;

  TomlTable table(std::string_view key) const;
  std::vector<TomlTable> tables(std::string_view key) const;  // [[key]]; empty when absent

  // Copies of this table, at its place in the file: without some keys; with a text at a key; and
  // one for every combination of the elements of its arrays of values, the last key's fastest.
  TomlTable without(const std::vector<std::string>& keys) const;
  TomlTable with(std::string_view key, const std::string& text) const;
  std::vector<TomlTable> combinations() const;

  // Reads this table by `read` and throws CaseFileErrors with all its wrong values: a value whose
  // rule has a stand-in is refused only once the rest has been read. Any other refusal ends the
  // reading; beside such values it is not told, as it may follow from them, unless it is itself of
  // the kind CaseFileErrors, which rests on nothing else.
  void read_all(const std::function<void(const TomlTable&)>& read) const;

  bool has(std::string_view key) const;
  std::string written(std::string_view key) const;  // a value's own text; "" when absent
  SourceLocation where() const;
  // Refuses the value at a key, which may be absent, for what else the file says.
  [[noreturn]] void refuse(std::string_view key, std::string_view expected) const;
  // Refuses the table itself; what it holds instead takes the value's place in the message.
  [[noreturn]] void refuse_table(std::string_view holds, std::string_view expected) const;

 private:
  struct Content;
  explicit TomlTable(std::shared_ptr<const Content> content) : content_(std::move(content)) {}
  std::string refusal(std::string_view key, std::string_view expected) const;
  // The rule's stand-in, the refusal being kept; throws it where it cannot be.
  template <class T>
  T refused(std::string_view key, const Rule<T>& rule) const;
  std::shared_ptr<const Content> content_;
};

}  // namespace slosh
