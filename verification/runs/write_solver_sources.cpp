// Writes the file that the keys of one solver's results hash: write_solver_sources BUILD REQUEST
// ROOT. The request (solver_builds.cmake) says the compiler and its options, which are copied, then
// in lines "leave out NAME" and "source NAME" which files the text is made of.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "verification/runs/solver_sources.hpp"

namespace {

void write(const std::filesystem::path& build, const std::filesystem::path& request,
           const std::filesystem::path& root) {
  std::set<std::string> sources, left_out;
  std::string text;
  std::ifstream lines(request);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("leave out "))
      left_out.insert(line.substr(10));
    else if (line.starts_with("source "))
      sources.insert(line.substr(7));
    else
      text += line + '\n';
  }
  if (sources.empty()) throw std::runtime_error(request.string() + ": expected a source");
  text += slosh::text_of_sources(root, sources, left_out);
  const std::filesystem::path written = build.string() + ".new";
  if (!(std::ofstream(written, std::ios::binary) << text).flush())
    throw std::runtime_error("cannot write " + written.string());
  std::filesystem::rename(written, build);
}

}  // namespace

int main(int count, char** arguments) try {
  if (count != 4) throw std::runtime_error("expected BUILD REQUEST ROOT");
  write(arguments[1], arguments[2], arguments[3]);
} catch (const std::exception& error) {
  std::fprintf(stderr, "write_solver_sources: %s\n", error.what());
  return 1;
}
