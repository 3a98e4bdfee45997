#include "reports/pages/pdf_places.hpp"

#include <cctype>
#include <cstdlib>
#include <string_view>

namespace slosh::reports {
namespace {

// Returns the number of the object that begins last before this place: "12 0 obj\n<</Type /Page".
int object_before(std::string_view pdf, std::size_t place) {
  const std::size_t word = pdf.rfind(" 0 obj", place);
  if (word == pdf.npos) return 0;
  std::size_t digits = word;
  while (digits > 0 && std::isdigit(static_cast<unsigned char>(pdf[digits - 1]))) --digits;
  return std::atoi(std::string(pdf.substr(digits, word - digits)).c_str());
}

// Maps the objects of the pages, which stand in the document's order, to their numbers.
std::map<int, int> page_numbers(std::string_view pdf) {
  std::map<int, int> numbers;
  const std::string_view opening = "<</Type /Page\n";
  for (std::size_t at = pdf.find(opening); at != pdf.npos; at = pdf.find(opening, at + 1)) {
    const int number = static_cast<int>(numbers.size()) + 1;
    numbers[object_before(pdf, at)] = number;
  }
  return numbers;
}

}  // namespace

// A destination reads "/waves [8 0 R /XYZ 6 827.67 0]".
std::map<std::string, int> pdf_places(const std::string& pdf) {
  const std::map<int, int> numbers = page_numbers(pdf);
  const std::string target = " 0 R /XYZ ";
  std::map<std::string, int> places;
  for (std::size_t at = pdf.find(target); at != pdf.npos; at = pdf.find(target, at + 1)) {
    const std::size_t bracket = pdf.rfind(" [", at), slash = pdf.rfind('/', bracket);
    if (bracket == pdf.npos || slash == pdf.npos) continue;
    const auto page = numbers.find(std::atoi(pdf.substr(bracket + 2, at - bracket - 2).c_str()));
    if (page != numbers.end()) places[pdf.substr(slash + 1, bracket - slash - 1)] = page->second;
  }
  return places;
}

}  // namespace slosh::reports
