#include "verification/solvers/external/script_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>
#include <vector>

namespace slosh {
namespace {

enum class Words { in_strings, of_shell, of_octave };

struct Language {
  std::string_view suffix, interpreter, comment;
  Words words;
  std::vector<std::string_view> loaders;     // a string behind them names a module
  std::vector<std::string_view> statements;  // so do the bare words of such a statement
};

const std::array<Language, 7> languages{{
    {".py",
     "python",
     "#",
     Words::in_strings,
     {"import_module", "__import__", "run_module", "find_spec"},
     {"import", "from"}},
    {".rb",
     "ruby",
     "#",
     Words::in_strings,
     {"require", "require_relative", "load", "autoload"},
     {}},
    {".lua", "lua", "--", Words::in_strings, {"require", "dofile", "loadfile"}, {}},
    {".js", "node", "//", Words::in_strings, {"require", "import", "from"}, {}},
    {".pl", "perl", "#", Words::in_strings, {"require", "do"}, {"use", "require"}},
    {".m", "octave", "%", Words::of_octave, {}, {}},
    {".sh", "sh", "#", Words::of_shell, {}, {}},
}};

const Language* language_of(const std::filesystem::path& file, const std::string& text) {
  const std::string suffix = file.extension().string();
  const std::string_view first = std::string_view(text).substr(0, text.find('\n'));
  for (const Language& one : languages)
    if (suffix == one.suffix ||
        (first.starts_with("#!") && first.find(one.interpreter) != first.npos))
      return &one;
  return nullptr;
}

bool is_of_word(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) ||
         std::string_view("_./-+").find(letter) != std::string_view::npos;
}

bool is_of_name(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) || letter == '_' || letter == '.';
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n\\";
  const std::size_t begin = text.find_first_not_of(blanks);
  return begin == text.npos ? "" : text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

std::string_view last_name(std::string_view code) {
  while (!code.empty() && std::string_view(" \t\n(").find(code.back()) != code.npos)
    code.remove_suffix(1);
  std::size_t begin = code.size();
  while (begin > 0 && (is_of_name(code[begin - 1]) && code[begin - 1] != '.')) --begin;
  return code.substr(begin);
}

// Blanks what stands behind the marks of a comment that begin a word outside of quotes.
std::string without_comments(std::string text, std::string_view marks) {
  std::array<bool, 2> inside{};  // of " and of '
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') inside = {};
    if (text[i] == '"') inside[0] = !inside[0];
    if (text[i] == '\'') inside[1] = !inside[1];
    const bool begins = i == 0 || std::string_view(" \t\n").find(text[i - 1]) != marks.npos;
    if (begins && !inside[0] && !inside[1] && marks.find(text[i]) != marks.npos)
      for (; i + 1 < text.size() && text[i + 1] != '\n'; ++i) text[i] = ' ';
  }
  return text;
}

// Splits a text into its code, in which strings and comments are blank, and its strings.
class StringReader {
 public:
  StringReader(const std::string& text, const Language& language, ScriptWords& words)
      : text_(text), language_(language), words_(words) {
    while (at_ < text_.size()) {
      const std::string_view rest = std::string_view(text_).substr(at_);
      const bool is_block = language_.suffix == ".js" && rest.starts_with("/*");
      if (rest.starts_with(language_.comment) || is_block)
        at_ = std::min(text_.find(is_block ? "*/" : "\n", at_), text_.size());
      else if (rest[0] == '"' || rest[0] == '\'' || rest[0] == '`')
        read_string(rest);
      else
        code_ += text_[at_++];
    }
  }
  const std::string& code() const { return code_; }

 private:
  void read_string(std::string_view rest) {
    const std::string_view one = rest.substr(0, 1), three = rest.substr(0, 3);
    const bool is_triple =
        language_.suffix == ".py" && (three == "\"\"\"" || three == std::string_view("'''"));
    const std::string_view quote = is_triple ? three : one;
    const std::size_t begin = at_ += quote.size();
    for (; at_ < text_.size() && text_.compare(at_, quote.size(), quote) != 0; ++at_)
      if (text_[at_] == '\\') ++at_;
    at_ = std::min(at_, text_.size());
    take(text_.substr(begin, at_ - begin), is_triple);
    at_ = std::min(at_ + quote.size(), text_.size());
    code_ += ' ';
  }

  // A string of several lines that stands alone is a comment.
  void take(const std::string& content, bool is_triple) {
    const std::string_view before = std::string_view(code_).substr(code_.rfind('\n') + 1);
    if (is_triple && trimmed(before).empty()) return;
    words_.files.merge(words_of(content));
    const std::string_view loader = last_name(code_);
    if (std::ranges::count(language_.loaders, loader) > 0) words_.modules.merge(words_of(content));
  }

  const std::string& text_;
  const Language& language_;
  ScriptWords& words_;
  std::size_t at_ = 0;
  std::string code_;
};

// Ends at a line, a semicolon or a colon, outside of brackets.
std::vector<std::string> statements_of(const std::string& code) {
  std::vector<std::string> statements(1);
  int depth = 0;
  for (std::size_t i = 0; i < code.size(); ++i) {
    const char letter = code[i];
    if (letter == '(' || letter == '[' || letter == '{') ++depth;
    if (letter == ')' || letter == ']' || letter == '}') depth = std::max(0, depth - 1);
    const bool goes_on = depth > 0 || (i > 0 && code[i - 1] == '\\');
    if (letter == ';' || letter == ':' || (letter == '\n' && !goes_on))
      statements.emplace_back();
    else
      statements.back() += letter;
  }
  return statements;
}

std::vector<std::string> names_in(std::string_view text) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t begin = i;
    while (i < text.size() && is_of_name(text[i])) ++i;
    if (i > begin) names.emplace_back(text.substr(begin, i - begin));
    i += i == begin;
  }
  return names;
}

// `import a.b as c, d`; `from a import b`, where b may be a module of a; `use a`.
void add_imports(const Language& language, const std::string& code, ScriptWords& words) {
  for (const std::string& statement : statements_of(code)) {
    const std::vector<std::string> names = names_in(trimmed(statement));
    if (names.size() < 2 || std::ranges::count(language.statements, names[0]) == 0) continue;
    words.modules.insert(names[1]);
    const bool is_from = names[0] == "from";
    for (std::size_t i = 2; i < names.size(); ++i)
      if (names[i] != "as" && names[i - 1] != "as" && names[i] != "import")
        words.modules.insert(is_from ? names[1] + "." + names[i] : names[i]);
  }
}

// Blanks the names that are variables: `name=` and `for name` of a shell, also behind a $, and what
// Octave assigns.
std::set<std::string> words_of_commands(const std::string& text, Words kind) {
  std::set<std::string> words;
  std::string before;  // the last word
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t begin = i;
    while (i < text.size() && is_of_word(text[i])) ++i;
    const std::string word = text.substr(begin, i - begin);
    std::size_t next = i;
    while (kind == Words::of_octave && next < text.size() && text[next] == ' ') ++next;
    const bool is_assigned = next < text.size() && text[next] == '=' &&
                             (next + 1 == text.size() || text[next + 1] != '=');
    const bool is_first = begin == 0 || std::isspace(static_cast<unsigned char>(text[begin - 1])) ||
                          text[begin - 1] == ';' || text[begin - 1] == '(';
    const bool is_name = std::ranges::all_of(word, is_of_name) && word.find('.') == word.npos;
    const bool is_read =
        kind == Words::of_shell && begin > 0 &&
        (text[begin - 1] == '$' || (text[begin - 1] == '{' && begin > 1 && text[begin - 2] == '$'));
    const bool is_variable = is_name && ((is_first && is_assigned) || is_read ||
                                         (kind == Words::of_shell && before == "for"));
    if (!word.empty() && !is_variable) words.merge(words_of(word));
    if (!word.empty()) before = word;
    i += i == begin;
  }
  return words;
}

}  // namespace

std::set<std::string> words_of(const std::string& text) {
  std::set<std::string> words;
  for (auto at = text.begin(); at != text.end();) {
    const auto end = std::find_if_not(at, text.end(), is_of_word);
    const std::string word(at, end);
    if (std::any_of(word.begin(), word.end(), [](unsigned char c) { return std::isalpha(c); }))
      words.insert(word);
    at = end == text.end() ? end : end + 1;
  }
  return words;
}

ScriptWords words_of_script(const std::filesystem::path& file, const std::string& text) {
  const Language* language = language_of(file, text);
  if (!language) return {words_of(without_comments(text, "#")), {}, ""};
  ScriptWords words{{}, {}, std::string(language->suffix)};
  switch (language->words) {
    case Words::in_strings:
      add_imports(*language, StringReader(text, *language, words).code(), words);
      break;
    case Words::of_shell:
      words = {words_of_commands(without_comments(text, "#"), language->words), {}, ""};
      break;
    case Words::of_octave:
      words.files = words_of_commands(without_comments(text, "%#"), language->words);
      words.modules = words.files;
      break;
  }
  return words;
}

}  // namespace slosh
