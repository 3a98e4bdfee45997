// A sealed JSON file, for small files of this project that a person may want to read:
//   body: its content, with the member "format" that names its kind
//   hash: content_hash of the body's compact text
// It is written under a temporary name and renamed when complete. The hash is checked when it is
// read, so that an altered or truncated file is refused.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace slosh {

// Replaces bytes that are not UTF-8. Throws ResultError (result_error.hpp) with the file's name.
void write_sealed_json(const nlohmann::json& body, const std::filesystem::path& file);

// Whether the text is a whole sealed JSON file, of any format.
bool is_sealed_json(std::string_view text);

// The body. Throws ResultError with the file's name where the file is missing, truncated, altered,
// or of another format than `format`.
nlohmann::json read_sealed_json(const char* format, const std::filesystem::path& file);

}  // namespace slosh
