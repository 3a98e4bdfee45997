#include "verification/cli/completions.hpp"

#include <algorithm>
#include <sstream>

namespace slosh {
namespace {

// How far the words that are typed in full lead.
struct Place {
  const CLI::App* app;
  std::vector<std::string> positionals;   // values that were given without an option's name
  const CLI::Option* awaiting = nullptr;  // the option whose value comes next
};

bool takes_value(const CLI::Option& option) { return option.get_expected_max() > 0; }

bool is_shown(const CLI::App& app) { return !app.get_group().empty(); }

std::vector<const CLI::App*> subcommands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* one) { return is_shown(*one); });
}

const CLI::App* subcommand(const CLI::App& app, const std::string& name) {
  for (const CLI::App* one : subcommands(app))
    if (one->get_name() == name) return one;
  return nullptr;
}

void pass(Place& place, const std::string& word) {
  if (place.awaiting) {
    if (word != "=") place.awaiting = nullptr;  // bash takes --option=value for three words
  } else if (word.starts_with("-")) {
    const CLI::Option* option = place.app->get_option_no_throw(word);
    if (option && takes_value(*option)) place.awaiting = option;
  } else if (const CLI::App* below = subcommand(*place.app, word)) {
    place = {below, {}, nullptr};
  } else {
    place.positionals.push_back(word);
  }
}

// Those that a check allows, which stand in the type as "{a,b}".
std::vector<std::string> allowed_values(const std::string& type) {
  const auto begin = type.find('{'), end = type.find('}');
  std::vector<std::string> values;
  if (begin == std::string::npos || end == std::string::npos) return values;
  std::istringstream list(type.substr(begin + 1, end - begin - 1));
  for (std::string one; std::getline(list, one, ',');) values.push_back(one);
  return values;
}

std::vector<Completion> values_of(const CLI::Option& option, const std::vector<std::string>& before,
                                  const KnownNames& known_names) {
  const std::string type = option.get_type_name();
  std::vector<std::string> names = allowed_values(type);
  if (names.empty()) names = known_names(type, before);
  std::vector<Completion> values;
  for (const std::string& name : names) values.push_back({name, ""});
  return values;
}

std::vector<Completion> options_of(const CLI::App& app) {
  std::vector<Completion> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames())
      names.push_back({"--" + name, option->get_description()});
  return names;
}

// The one that comes next, or the last where it takes any number of values.
const CLI::Option* next_positional(const Place& place) {
  std::vector<const CLI::Option*> all;
  for (const CLI::Option* option : place.app->get_options())
    if (option->get_positional()) all.push_back(option);
  if (place.positionals.size() < all.size()) return all[place.positionals.size()];
  return !all.empty() && all.back()->get_expected_max() > 1 ? all.back() : nullptr;
}

std::vector<Completion> candidates(const Place& place, const std::string& begun,
                                   const KnownNames& known_names) {
  if (place.awaiting) return values_of(*place.awaiting, place.positionals, known_names);
  if (begun.starts_with("-")) return options_of(*place.app);
  std::vector<Completion> found;
  for (const CLI::App* one : subcommands(*place.app))
    if (place.positionals.empty()) found.push_back({one->get_name(), one->get_description()});
  if (const CLI::Option* positional = next_positional(place))
    for (Completion& one : values_of(*positional, place.positionals, known_names))
      found.push_back(std::move(one));
  return found;
}

}  // namespace

std::vector<Completion> completions(const CLI::App& app, const std::vector<std::string>& words,
                                    const KnownNames& known_names) {
  if (words.empty()) return {};
  Place place{&app, {}, nullptr};
  for (std::size_t i = 0; i + 1 < words.size(); ++i) pass(place, words[i]);
  const std::string begun = words.back() == "=" ? "" : words.back();
  std::vector<Completion> found = candidates(place, begun, known_names);
  std::erase_if(found, [&](const Completion& one) { return !one.word.starts_with(begun); });
  return found;
}

}  // namespace slosh
