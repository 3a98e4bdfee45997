#include "verification/input/tables/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/locale/utf.hpp>
#include <charconv>
#include <cmath>

#include "verification/files/content_hash.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf", white = " \t";

bool is_utf_16(std::string_view first_line) {
  return first_line.starts_with("\xff\xfe") || first_line.starts_with("\xfe\xff") ||
         (first_line.size() > 1 && (first_line[0] == '\0' || first_line[1] == '\0'));
}

bool is_mistaken(char32_t character) {
  const auto within = [&](char32_t first, char32_t last) {
    return character >= first && character <= last;
  };
  return (character < U' ' && character != U'\t') || within(0x7f, 0xa0) || character == 0xad ||
         within(0x2000, 0x2015) || within(0x2028, 0x202f) || within(0x205f, 0x206f) ||
         character == 0x2212 || character == 0x3000 || character == 0xfeff;
}

constexpr std::size_t longest_line = 1'000'000;  // [byte]

// Returns the number of the first line that is longer; 0 where there is none.
int too_long_line(std::string_view text) {
  int number = 0;
  for (std::size_t begin = 0; begin < text.size(); ++begin) {
    ++number;
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (end - begin > longest_line) return number;
    begin = end;
  }
  return 0;
}

std::string with_code_points(std::string_view text) {
  using Utf8 = boost::locale::utf::utf_traits<char>;
  std::string shown;
  for (auto at = text.begin(); at != text.end();) {
    const auto begin = at;
    const auto character = Utf8::decode(at, text.end());
    if (!boost::locale::utf::is_valid_codepoint(character)) {
      at = begin + 1;
      shown += fmt::format("<byte {:02X}>", static_cast<unsigned char>(*begin));
    } else if (is_mistaken(character)) {
      shown += fmt::format("<U+{:04X}>", static_cast<unsigned>(character));
    } else {
      shown.append(begin, at);
    }
  }
  return shown;
}

}  // namespace

TableReader::TableReader(const fs::path& file) : file_(file) {
  if (std::error_code absent; fs::exists(file, absent) || absent) try {
      std::string text = read_input(file);
      // Before anything is split or quoted: a hole of a file is a line of zeros.
      if (line_number_ = too_long_line(text); line_number_ > 0)
        refuse("line", "of more than a megabyte", "a table, whose lines are shorter");
      stream_.str(std::move(text));
    } catch (const fs::filesystem_error& error) {
      refuse("file", error.what(), "a file of a disk that can be read");
    }
  next();
  if (is_utf_16(line_))
    refuse("encoding", "UTF-16", "UTF-8, as iconv -f UTF-16 -t UTF-8 writes it");
}

bool TableReader::next() {
  if (!std::getline(stream_, line_)) return false;
  ++line_number_;
  if (line_.ends_with('\r')) line_.pop_back();
  if (line_.starts_with(byte_order_mark)) line_.erase(0, byte_order_mark.size());
  return true;
}

double TableReader::number(std::string_view column, std::string_view text,
                           std::string_view unit) const {
  const std::optional<double> value = number_in(text);
  if (value && std::isfinite(*value)) return *value;
  refuse(column, text,
         has_decimal_comma(text)
             ? fmt::format("a number with a decimal point and no decimal comma, in {}", unit)
             : fmt::format("a number, in {}", unit));
}

void TableReader::refuse(std::string_view key, std::string_view value,
                         std::string_view expected) const {
  throw table_error(file_, std::max(line_number_, 1), key, value, expected);
}

std::optional<double> number_in(std::string_view text) {
  double value = 0;
  const auto is_whole = [&value](std::string_view all) {
    const auto [end, error] = std::from_chars(all.data(), all.data() + all.size(), value);
    return error == std::errc{} && end == all.data() + all.size();
  };
  if (is_whole(text)) return value;
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  std::string plain(text);
  if (const std::size_t exponent = plain.find_first_of("Dd"); exponent != plain.npos)
    plain[exponent] = 'e';
  return is_whole(plain) ? std::optional(value) : std::nullopt;
}

bool has_decimal_comma(std::string_view text) {
  std::string with_point(text);
  std::replace(with_point.begin(), with_point.end(), ',', '.');
  return with_point != text && number_in(with_point);
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(white), text.size());
  return text.substr(begin, text.find_last_not_of(white) + 1 - begin);
}

CaseFileError table_error(const std::filesystem::path& file, int line, std::string_view key,
                          std::string_view value, std::string_view expected) {
  return CaseFileError(
      fmt::format("{}:{}: {}", file.string(), line,
                  with_code_points(fmt::format("{} = {}: expected {}", key, value, expected))));
}

}  // namespace slosh
