#include "reports/fields/indexed_png.hpp"

#include <zlib.h>

#include <new>

namespace slosh::reports {
namespace {

std::string four_bytes(std::uint32_t number) {
  std::string bytes;
  for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(number >> shift & 0xffU);
  return bytes;
}

std::string chunk(const std::string& type, const std::string& data) {
  const std::string body = type + data;
  const auto sum =
      crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  return four_bytes(static_cast<std::uint32_t>(data.size())) + body +
         four_bytes(static_cast<std::uint32_t>(sum));
}

std::string compressed(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(),
                Z_BEST_COMPRESSION) != Z_OK)
    throw std::bad_alloc();  // the buffer is large enough, and the level exists
  packed.resize(size);
  return packed;
}

std::string palette_bytes(const std::vector<std::string>& palette) {
  std::string bytes;
  for (const std::string& colour : palette)
    for (const std::size_t channel : {1, 3, 5})
      bytes += static_cast<char>(std::stoi(colour.substr(channel, 2), nullptr, 16));
  return bytes;
}

}  // namespace

std::string indexed_png(const IndexedPicture& picture) {
  // Eight bits a pixel, places in a palette, deflate, filters by row, no interlacing.
  const std::string form{8, 3, 0, 0, 0};
  const auto width = static_cast<std::size_t>(picture.width);
  std::string rows;
  for (std::size_t start = 0; start < picture.pixels.size(); start += width) {
    rows += '\0';  // unfiltered, which is best for palettes (12.7 of the specification)
    rows.append(reinterpret_cast<const char*>(picture.pixels.data()) + start, width);
  }
  return "\x89PNG\r\n\x1a\n" +
         chunk("IHDR", four_bytes(static_cast<std::uint32_t>(picture.width)) +
                           four_bytes(static_cast<std::uint32_t>(picture.height)) + form) +
         chunk("PLTE", palette_bytes(picture.palette)) + chunk("IDAT", compressed(rows)) +
         chunk("IEND", "");
}

}  // namespace slosh::reports
