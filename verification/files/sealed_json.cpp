#include "verification/files/sealed_json.hpp"

#include <nlohmann/json.hpp>

#include "verification/files/atomic_file.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/foreign/json_text.hpp"
#include "verification/files/result_error.hpp"

namespace slosh {
namespace {

using nlohmann::json;

std::string text_of(const json& document, int indent) {
  return document.dump(indent, ' ', false, json::error_handler_t::replace);
}

}  // namespace

void write_sealed_json(const json& body, const std::filesystem::path& file) try {
  const json document{{"body", body}, {"hash", content_hash(text_of(body, -1))}};
  replace_file(file, text_of(document, 1), Durability::power_loss);
} catch (const std::filesystem::filesystem_error& error) {
  throw ResultError(error.what());
}

bool is_sealed_json(std::string_view text) try {
  const json document = parsed_json<json>(text);
  return document.is_object() && document.contains("body") && document.contains("hash") &&
         document.at("hash") == content_hash(text_of(document.at("body"), -1));
} catch (const json::exception&) {
  return false;
}

json read_sealed_json(const char* format, const std::filesystem::path& file) try {
  if (!std::filesystem::exists(file)) throw ResultError(file.string() + " does not exist");
  const json document = parsed_json<json>(read_bytes(file));
  const json& body = document.at("body");
  if (document.at("hash") != content_hash(text_of(body, -1)))
    throw ResultError(file.string() + " has been altered");
  if (body.at("format") != format)
    throw ResultError(file.string() + " does not have the format \"" + format + "\"");
  return body;
} catch (const json::exception& error) {
  throw ResultError(file.string() + " is truncated or altered: " + words_of(error));
} catch (const std::filesystem::filesystem_error& error) {
  throw ResultError(error.what());
}

}  // namespace slosh
