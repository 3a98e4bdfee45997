#include "reports/tests/picture_pixels.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "reports/drawing/gnuplot_script.hpp"
#include "reports/model/report_files.hpp"

namespace slosh::reports {

PicturePixels picture_pixels(const std::string& png, const std::filesystem::path& scratch) {
  write_text(scratch / "looked-at.png", png);
  const std::string file = (scratch / "looked-at").string();
  run_gnuplot(
      "set table '" + file + ".txt'\nplot '" + file + ".png' binary filetype=png with rgbimage\n",
      "looking", scratch);
  // The table has a million lines of x, y, red, green, blue, alpha and a letter, row by row from
  // the top.
  const std::string table = read_text(scratch / "looked-at.txt");
  std::vector<std::vector<Colour>> rows;
  long last_y = -1;
  for (std::size_t start = 0; start < table.size(); start = table.find('\n', start) + 1) {
    const char* place = table.c_str() + start;
    if (*place != ' ') continue;  // a comment or a gap
    std::array<long, 5> numbers{};
    for (long& number : numbers) {
      char* after = nullptr;
      number = std::strtol(place, &after, 10);
      place = after;
    }
    if (rows.empty() || numbers[1] != last_y) rows.emplace_back();
    rows.back().push_back(
        {static_cast<int>(numbers[2]), static_cast<int>(numbers[3]), static_cast<int>(numbers[4])});
    last_y = numbers[1];
  }
  if (rows.empty()) throw std::runtime_error("no pixels in " + file + ".png");
  PicturePixels picture{static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), {}};
  std::for_each(rows.rbegin(), rows.rend(), [&](const std::vector<Colour>& row) {
    picture.colours.insert(picture.colours.end(), row.begin(), row.end());
  });
  return picture;
}

}  // namespace slosh::reports
