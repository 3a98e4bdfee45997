// The JSON library with its class templates compiled once, in json.cpp: each file that uses them
// would compile them anew, which takes it several seconds.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

// Declares, with `extern` before it, or else defines what reads, holds and writes one kind of JSON.
// Later versions name these otherwise.
#if NLOHMANN_JSON_VERSION_MAJOR == 3 && NLOHMANN_JSON_VERSION_MINOR < 12
#define SLOSH_JSON_TEMPLATES(how, Json)                                                       \
  how template class nlohmann::detail::parser<                                                \
      nlohmann::Json, nlohmann::detail::iterator_input_adapter<std::string::const_iterator>>; \
  how template class nlohmann::detail::lexer<                                                 \
      nlohmann::Json, nlohmann::detail::iterator_input_adapter<std::string::const_iterator>>; \
  how template class nlohmann::detail::json_sax_dom_parser<nlohmann::Json>;                   \
  how template class nlohmann::detail::json_sax_dom_callback_parser<nlohmann::Json>;          \
  how template class nlohmann::detail::serializer<nlohmann::Json>;
#else
#define SLOSH_JSON_TEMPLATES(how, Json)
#endif

extern template class nlohmann::basic_json<>;
extern template class nlohmann::basic_json<nlohmann::ordered_map>;
SLOSH_JSON_TEMPLATES(extern, json)
SLOSH_JSON_TEMPLATES(extern, ordered_json)
