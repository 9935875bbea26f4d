// Reading of numbers and choices, and sentences for what CLI11 finds wrong.
#include "command_line.h"

#include <sturnus/parameters.h>
#include <sturnus/scenario.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <functional>

namespace program {
namespace {

std::optional<std::int64_t> whole_number(const std::string& text) {
  const sturnus::Value value = sturnus::parse_value(text);
  const auto* number = std::get_if<double>(&value.held);
  if (number == nullptr || *number != std::floor(*number) || std::abs(*number) > 9007199254740992.0)
    return {};
  return static_cast<std::int64_t>(*number);
}

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : between) + word;
  return out;
}

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> parts(1);
  for (const char letter : list) {
    if (letter == ',') {
      parts.emplace_back();
    } else {
      parts.back() += letter;
    }
  }
  return parts;
}

// What is wrong with a word that should be a whole number; empty when nothing is.
std::string complaint_about_whole(const std::string& word, std::int64_t low, std::int64_t high) {
  const auto number = whole_number(word);
  if (!number) return "must be a whole number, but is \"" + word + "\"";
  if (*number < low) return "must be at least " + std::to_string(low) + ", but is " + word;
  if (*number > high) return "must be at most " + std::to_string(high) + ", but is " + word;
  return {};
}

// The same for one of a few words.
std::string complaint_about_word(const std::string& word, const std::vector<std::string>& words) {
  if (std::find(words.begin(), words.end(), word) != words.end()) return {};
  return "must be one of " + joined(words, ", ") + ", but is " + quoted_with_guess(word, words);
}

// Checks every part of a list; the first complaint counts.
CLI::Validator each_of_list(const std::function<std::string(const std::string&)>& check) {
  const auto check_all = [check](const std::string& list) -> std::string {
    for (const std::string& part : split(list)) {
      if (std::string complaint = check(part); !complaint.empty()) return complaint;
    }
    return {};
  };
  return {check_all, "", ""};
}

bool is_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-';
}

// "sturnus run" or "sturnus"
std::string full_name(const CLI::App& app) {
  return app.get_parent() == nullptr ? app.get_name() : app.get_parent()->get_name() + " " + app.get_name();
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  return names;
}

const CLI::App& chosen_command(const CLI::App& app) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  return chosen.empty() ? app : *chosen.front();
}

// The first line of the examples in the footer.
std::string first_example(const CLI::App& command) {
  const std::string footer = command.get_footer();
  const auto begin = footer.find("sturnus");
  if (begin == std::string::npos) return {};
  return footer.substr(begin, footer.find('\n', begin) - begin);
}

std::string unknown_option(const CLI::App& app, const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  return full_name(app) + ": unknown option " + quoted_with_guess(name, option_names(app)) + " (" +
         full_name(app) + " --help lists them)";
}

std::string one_too_many(const CLI::App& command, const std::string& word) {
  return full_name(command) + ": \"" + word + "\" is one word too many (" + full_name(command) +
         " --help shows what is expected)";
}

std::string unknown_command(const CLI::App& app, const std::string& word) {
  if (command_names(app).empty()) return one_too_many(app, word);
  for (const sturnus::ShippedScenario& shipped : sturnus::shipped_scenarios()) {
    if (word == shipped.name) {
      return "sturnus: \"" + word + "\" is a scenario, not a command; try: sturnus run " + word;
    }
  }
  return "sturnus: unknown command " + quoted_with_guess(word, command_names(app)) +
         " (sturnus --help lists them)";
}

}  // namespace

CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& about,
                      const std::vector<std::string>& examples) {
  CLI::App* command = app.add_subcommand(name, about)->group("Commands");
  command->allow_extras();  // they are found and explained by `unexpected_words`
  command->footer("Examples:\n  " + joined(examples, "\n  "));
  return command;
}

CLI::Option* add_whole(CLI::App& command, const std::string& name, std::optional<std::int64_t>& place,
                       std::int64_t low, std::int64_t high, const std::string& about) {
  const auto store = [&place](const CLI::results_t& words) {
    place = whole_number(words.back());
    return place.has_value();
  };
  const auto check = [low, high](const std::string& word) { return complaint_about_whole(word, low, high); };
  return command.add_option(name, store, about)
      ->type_name("N")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
      ->check(check);
}

CLI::Option* add_wholes(CLI::App& command, const std::string& name, std::vector<std::int64_t>& place,
                        std::int64_t low, std::int64_t high, const std::string& about) {
  const auto store = [&place](const CLI::results_t& lists) {
    place.clear();
    for (const std::string& part : split(lists.back())) place.push_back(whole_number(part).value_or(0));
    return true;
  };
  const auto check = [low, high](const std::string& word) { return complaint_about_whole(word, low, high); };
  return command.add_option(name, store, about)
      ->type_name("N,N,...")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
      ->check(each_of_list(check));
}

CLI::Option* add_text(CLI::App& command, const std::string& name, std::string& place, const std::string& type,
                      const std::string& about) {
  const auto not_empty = [](const std::string& word) -> std::string {
    return word.empty() ? "must not be empty" : "";
  };
  return command.add_option(name, place, about)
      ->type_name(type)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
      ->check(CLI::Validator(not_empty, "", ""));
}

CLI::Option* add_choice(CLI::App& command, const std::string& name, std::string& place,
                        const std::vector<std::string>& words, const std::string& about) {
  return add_text(command, name, place, joined(words, "|"), about)->check(one_of(words));
}

CLI::Option* add_choices(CLI::App& command, const std::string& name, std::vector<std::string>& place,
                         const std::vector<std::string>& words, const std::string& about) {
  const auto store = [&place](const CLI::results_t& lists) {
    place = split(lists.back());
    return true;
  };
  const auto check = [words](const std::string& word) { return complaint_about_word(word, words); };
  return command.add_option(name, store, about)
      ->type_name(joined(words, "|") + ",...")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
      ->check(each_of_list(check));
}

CLI::Validator one_of(const std::vector<std::string>& words) {
  const auto check = [words](const std::string& word) { return complaint_about_word(word, words); };
  return {check, "", ""};
}

std::string quoted_with_guess(const std::string& word, const std::vector<std::string>& known) {
  const std::string near = sturnus::nearest_word(word, known);
  return "\"" + word + "\"" + (near.empty() ? "" : "; did you mean " + near + "?");
}

std::optional<std::pair<int, int>> two_numbers(const std::string& text, char between) {
  std::pair<int, int> numbers;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, numbers.first);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != between) return {};
  const auto second = std::from_chars(first.ptr + 1, end, numbers.second);
  if (second.ec != std::errc() || second.ptr != end) return {};
  return numbers;
}

sturnus::Result<sturnus::Size> picture_size(const std::string& option, const std::string& text) {
  const auto size = two_numbers(text);
  if (!size)
    return complaint(option, "write width x height in pixels, such as 1280x720, but found \"" + text + "\"");
  for (const int side : {size->first, size->second}) {
    if (side < sturnus::min_picture_side || side > sturnus::max_picture_side) {
      return complaint(option, "each side must be " + std::to_string(sturnus::min_picture_side) + " to " +
                                   std::to_string(sturnus::max_picture_side) + " pixels, but found \"" +
                                   text + "\"");
    }
  }
  return sturnus::Size{size->first, size->second};
}

std::string folder_of(const std::string& path) {
  const auto slash = path.find_last_of('/');
  return slash == std::string::npos ? "" : path.substr(0, slash + 1);
}

bool is_picture_name(const std::string& path) {
  if (path.size() < 5) return false;
  std::string ending = path.substr(path.size() - 4);
  for (char& letter : ending) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return ending == ".png" || ending == ".ppm";
}

sturnus::Problem complaint(const std::string& option, std::string text) {
  return {option, 0, "", std::move(text), false};
}

std::string unexpected_words(const CLI::App& app) {
  const std::vector<std::string> before = app.remaining();
  const CLI::App& command = chosen_command(app);
  if (!before.empty() && is_option(before.front())) {
    const bool of_command = &command != &app && command.get_option_no_throw(before.front()) != nullptr;
    if (!of_command) return unknown_option(app, before.front());
    return "sturnus: the option \"" + before.front() + "\" comes after the command: sturnus " +
           command.get_name() + " " + before.front();
  }
  if (!before.empty()) return unknown_command(app, before.front());
  if (&command == &app || command.get_prefix_command()) return {};
  const std::vector<std::string> after = command.remaining();
  const auto option = std::find_if(after.begin(), after.end(), is_option);
  if (option != after.end()) return unknown_option(command, *option);
  if (after.empty()) return {};
  return one_too_many(command, after.front());
}

std::string sentence_of(const CLI::ParseError& error, const CLI::App& app) {
  const CLI::App& command = chosen_command(app);
  const std::string text = error.what();
  if (error.get_name() == "RequiredError") {
    return full_name(command) + " needs " + text.substr(0, text.find(" is required")) +
           "; for example: " + first_example(command);
  }
  if (error.get_name() == "ArgumentMismatch") {
    return full_name(command) + ": " + text.substr(0, text.find(':')) + " needs a value";
  }
  return full_name(command) + ": " + text;
}

}  // namespace program
