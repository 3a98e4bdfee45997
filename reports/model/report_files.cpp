#include "reports/model/report_files.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>

#include "reports/model/report_model.hpp"

namespace slosh::reports {
namespace {

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + "\"";
}

}  // namespace

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) line += csv_cell(cell) + ",";
  if (!line.empty()) line.pop_back();
  return line + "\n";
}

std::string csv_number(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

std::string base64(const std::string& bytes) {
  using namespace boost::archive::iterators;
  using Base64 = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  // Three bytes make four characters; '=' stands for what the last three lack.
  const std::size_t lacking = (3 - bytes.size() % 3) % 3;
  const std::string whole = bytes + std::string(lacking, '\0');
  std::string text(Base64(whole.begin()), Base64(whole.end()));
  return text.replace(text.size() - lacking, lacking, lacking, '=');
}

bool is_whole_png(const std::string& bytes) {
  constexpr std::string_view signature = "\x89PNG\r\n\x1a\n", end = "IEND\xae\x42\x60\x82";
  return bytes.starts_with(signature) && bytes.ends_with(end);
}

bool is_whole_gif(const std::string& bytes) {
  return bytes.starts_with("GIF89a") && bytes.ends_with('\x3b');
}

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw ReportError("cannot read " + path.string() + ": " + std::strerror(errno));
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();  // a full disk fails here at the latest
  if (!file) throw ReportError("cannot write " + path.string() + ": " + std::strerror(errno));
}

TemporaryDirectory::TemporaryDirectory(const std::string& name_start) {
  std::string name = name_start + "XXXXXX";
  if (mkdtemp(name.data()) == nullptr)
    throw ReportError("cannot create a directory " + name + ": " + std::strerror(errno));
  path_ = name;
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;  // nothing can be done here about what is left
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace slosh::reports
