#include "verification/runs/solver_sources.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <map>
#include <system_error>
#include <vector>

namespace slosh {
namespace {

namespace fs = std::filesystem;
using std::string_view;

constexpr auto none = string_view::npos;

// The longest first.
constexpr std::array<string_view, 27> operators{
    "<<=", ">>=", "<=>", "->*", "...", "::", "++", "--", "->", "<<", ">>", "<=", ">=", "==",
    "!=",  "&&",  "||",  "+=",  "-=",  "*=", "/=", "%=", "&=", "|=", "^=", "##", ".*"};

bool is_space(char c) { return string_view(" \t\n\r\v\f").find(c) != none; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_word(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c < 0;
}

std::size_t end_of_word(string_view text) {
  return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_word) -
                                  text.begin());
}

// With a sign behind an exponent's letter, and quotes between digits.
std::size_t end_of_number(string_view text) {
  std::size_t end = 1;
  for (; end < text.size(); ++end) {
    const char c = text[end], last = text[end - 1];
    const bool sign =
        (c == '+' || c == '-') && string_view("eEpP").find(last) != none && !text.starts_with("0x");
    const bool separator = c == '\'' && end + 1 < text.size() && is_word(text[end + 1]);
    if (!is_word(c) && c != '.' && !sign && !separator) break;
  }
  return end;
}

std::size_t after(string_view text, string_view closing, std::size_t from) {
  const std::size_t found = text.find(closing, from);
  return found == none ? text.size() : found + closing.size();
}

std::size_t end_of_quoted(string_view text) {
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (text[i] == '\\')
      ++i;
    else if (text[i] == text[0])
      return i + 1;
  }
  return text.size();
}

// R"delimiter( ... )delimiter"
std::size_t end_of_raw(string_view text, std::size_t quote) {
  const std::size_t open = text.find('(', quote);
  if (open == none) return text.size();
  return after(text, ")" + std::string(text.substr(quote + 1, open - quote - 1)) + "\"", open);
}

std::size_t end_of_token(string_view text) {
  const char c = text[0];
  if (is_digit(c) || (c == '.' && text.size() > 1 && is_digit(text[1]))) return end_of_number(text);
  if (c == '"' || c == '\'') return end_of_quoted(text);
  if (is_word(c)) {
    const std::size_t end = end_of_word(text);
    return end < text.size() && text[end] == '"' && text[end - 1] == 'R' ? end_of_raw(text, end)
                                                                         : end;
  }
  for (const string_view one : operators)
    if (text.starts_with(one)) return one.size();
  return 1;
}

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.is_open() || stream.bad())
    throw fs::filesystem_error("cannot read a solver's source", file,
                               std::make_error_code(std::errc::no_such_file_or_directory));
  return text;
}

std::vector<std::string> included_by(string_view tokens) {
  constexpr string_view include = "\n# include \"";
  std::vector<std::string> names;
  for (std::size_t at = tokens.find(include); at != none; at = tokens.find(include, at + 1)) {
    const std::size_t begin = at + include.size();
    names.emplace_back(tokens.substr(begin, tokens.find('"', begin) - begin));
  }
  return names;
}

}  // namespace

std::string tokens_of(string_view source) {
  std::string tokens = "\n";
  bool in_directive = false;
  const auto end_line = [&] {
    if (tokens.back() == ' ') tokens.back() = '\n';
  };
  while (!source.empty()) {
    std::size_t end = 1;
    if (source.starts_with("//")) {
      end = std::min(source.find('\n'), source.size());
    } else if (source.starts_with("/*")) {
      end = after(source, "*/", 2);
    } else if (source.starts_with("\\\n")) {
      end = 2;
    } else if (is_space(source[0])) {
      if (source[0] == '\n' && in_directive) {
        in_directive = false;
        end_line();
      }
    } else {
      if (source[0] == '#' && !in_directive) {
        in_directive = true;
        end_line();
      }
      end = end_of_token(source);
      tokens.append(source.substr(0, end)) += ' ';
      if (end == 1 && string_view(";{}").find(source[0]) != none && !in_directive) end_line();
    }
    source.remove_prefix(end);
  }
  end_line();
  return tokens;
}

std::string text_of_sources(const fs::path& root, std::set<std::string> sources,
                            const std::set<std::string>& left_out) {
  std::map<std::string, std::string> texts;
  while (!sources.empty()) {
    const std::string name = sources.extract(sources.begin()).value();
    const std::string tokens = tokens_of(content_of(root / name));
    texts.emplace(name, tokens);
    for (const std::string& header : included_by(tokens))
      if (!texts.contains(header) && !left_out.contains(header)) sources.insert(header);
  }
  std::string whole;
  for (const auto& [name, tokens] : texts) whole += "== " + name + tokens;
  return whole;
}

}  // namespace slosh
