// The pixels of a PNG file, for the tests that look at pictures.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace slosh::reports {

using Colour = std::array<int, 3>;  // red, green, blue of 255

struct PicturePixels {
  int width, height;
  std::vector<Colour> colours;  // row by row from the bottom

  const Colour& at(int x, int y) const {
    return colours.at(static_cast<std::size_t>(y * width + x));
  }
};

// As gnuplot, which decodes what it did not draw here, prints them. Throws std::runtime_error.
PicturePixels picture_pixels(const std::string& png, const std::filesystem::path& scratch);

}  // namespace slosh::reports
