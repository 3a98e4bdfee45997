// Reads the pixels of a PNG file.
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

// Lets gnuplot decode the file. Throws std::runtime_error where it finds no pixels.
PicturePixels picture_pixels(const std::string& png, const std::filesystem::path& scratch);

}  // namespace slosh::reports
