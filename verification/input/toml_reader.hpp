// A strict view of a TOML file: typed values, each with a rule that it must satisfy, and no unknown
// keys. Every refusal reads "file:line: key = value: expected EXPECTATION".
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
#include "verification/input/enum_names.hpp"
#include "verification/input/rules.hpp"

namespace slosh {

// An element of an array of texts.
struct PlacedText {
  std::string text;
  SourceLocation where;
};

// One table of the file. Throws CaseFileError for a value that is missing, has another type, is not
// finite or breaks its rule. An integer is accepted as a number; there is no other conversion.
class TomlTable {
 public:
  // Throws CaseFileError with file:line:column if the text is not TOML.
  TomlTable(std::string_view text, const std::filesystem::path& file);

  // Throws CaseFileErrors with a message for each key of this table that is not among these, and
  // the nearest of these.
  void allow_only(const std::vector<std::string>& keys) const;

  // T: double, int, std::string, bool.
  template <class T>
  T get(std::string_view key, const Rule<T>& rule) const;
  template <class T>
  std::optional<T> find(std::string_view key, const Rule<T>& rule) const;
  bool flag(std::string_view key) const;  // false when absent
  // The number at a key; nothing where there is none, which is no mistake.
  std::optional<double> number(std::string_view key) const;

  // Returns a text that is one of the known ones. Throws CaseFileErrors with the nearest.
  std::string choice(std::string_view key, std::string_view expected,
                     const std::vector<std::string>& known) const;
  // Returns the value of an enumeration whose name stands at the key.
  template <class Enum, std::size_t n>
  Enum choice(std::string_view key, std::string_view expected,
              const EnumName<Enum> (&table)[n]) const {
    return value_of(choice(key, expected, all_names(table)), table);
  }
  std::vector<PlacedText> texts(std::string_view key, const Rule<std::string>& each) const;
  std::vector<double> numbers(std::string_view key, const Rule<double>& each) const;
  // An array of arrays of two finite numbers. `each` says what such a pair is.
  std::vector<std::pair<double, double>> pairs(std::string_view key, std::string_view each) const;
  // Strictly increasing; empty when absent.
  std::vector<double> increasing_numbers(std::string_view key, const Rule<double>& each) const;

  TomlTable table(std::string_view key) const;
  std::vector<TomlTable> tables(std::string_view key) const;  // [[key]]; empty when absent

  // Return copies of this table, with the same place in the file: without some keys, with a text or
  // a flag at a key, and one copy for every combination of the elements of its arrays of values but
  // for those at some keys, where the last key varies fastest.
  TomlTable without(const std::vector<std::string>& keys) const;
  TomlTable with(std::string_view key, const std::string& text) const;
  TomlTable with_flag(std::string_view key, bool value) const;
  std::vector<TomlTable> combinations(const std::vector<std::string>& but_for = {}) const;
  // Returns a copy with the value that stands at `from` in another table of the file. A refusal of
  // it tells where it stands there.
  TomlTable with(std::string_view key, const TomlTable& other, std::string_view from) const;
  // Returns a copy whose place in the file is that of a value of another table.
  TomlTable placed_at(const TomlTable& other, std::string_view key) const;

  // Reads this table by `read` and throws CaseFileErrors with all its wrong values. A value whose
  // rule has a stand-in is refused only after the rest has been read. Any other refusal ends the
  // reading. Beside wrong values it is reported only if it is a CaseFileErrors, which depends on no
  // other value; otherwise it may only follow from them.
  void read_all(const std::function<void(const TomlTable&)>& read) const;

  bool has(std::string_view key) const;
  bool has_table(std::string_view key) const;
  bool has_list(std::string_view key) const;
  std::vector<std::string> keys() const;            // in the order of the file
  std::string written(std::string_view key) const;  // a value's own text; "" when absent
  std::string as_toml() const;                      // the text of a file with these keys alone
  SourceLocation where() const;
  // Refuses the value at a key, which may be absent.
  [[noreturn]] void refuse(std::string_view key, std::string_view expected) const;
  // Refuses an element of an array, which must be there.
  [[noreturn]] void refuse_element(std::string_view key, std::size_t element,
                                   std::string_view expected) const;
  // Refuses the table itself. `holds` takes the place of the value in the message.
  [[noreturn]] void refuse_table(std::string_view holds, std::string_view expected) const;

 private:
  struct Content;
  explicit TomlTable(std::shared_ptr<const Content> content) : content_(std::move(content)) {}
  static TomlTable of(Content content);
  std::string refusal(std::string_view key, std::string_view expected) const;
  // Keeps the refusal and returns the rule's stand-in. Throws the refusal if the rule has none.
  template <class T>
  T refused(std::string_view key, const Rule<T>& rule) const;
  std::shared_ptr<const Content> content_;
};

}  // namespace slosh
