// Options that say clearly what is wrong with them.
#pragma once

#include <sturnus/picture.h>
#include <sturnus/result.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace program {

/// A command with its examples, the first of which also explains what is missing when something is.
CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& about,
                      const std::vector<std::string>& examples);

/// A whole number between `low` and `high`; 1e6 is one too. The last one given counts.
CLI::Option* add_whole(CLI::App& command, const std::string& name, std::optional<std::int64_t>& place,
                       std::int64_t low, std::int64_t high, const std::string& about);
/// Whole numbers with commas between them. The last list given counts.
CLI::Option* add_wholes(CLI::App& command, const std::string& name, std::vector<std::int64_t>& place,
                        std::int64_t low, std::int64_t high, const std::string& about);
/// A word or path. The last one given counts.
CLI::Option* add_text(CLI::App& command, const std::string& name, std::string& place, const std::string& type,
                      const std::string& about);
/// One of a few words. The last one given counts.
CLI::Option* add_choice(CLI::App& command, const std::string& name, std::string& place,
                        const std::vector<std::string>& words, const std::string& about);

/// Some of a few words, with commas between them. The last list given counts.
CLI::Option* add_choices(CLI::App& command, const std::string& name, std::vector<std::string>& place,
                         const std::vector<std::string>& words, const std::string& about);

/// Checks a value to be one of a few words, with "did you mean".
CLI::Validator one_of(const std::vector<std::string>& words);

/// `"rnu"; did you mean run?` or just the quoted word.
std::string quoted_with_guess(const std::string& word, const std::vector<std::string>& known);

/// Two whole numbers with a letter between them, such as 1280x720.
std::optional<std::pair<int, int>> two_numbers(const std::string& text, char between = 'x');
/// The size of a picture from an option such as --size 1280x720, or what is wrong with it.
sturnus::Result<sturnus::Size> picture_size(const std::string& option, const std::string& text);
/// "dir/" of "dir/file", empty when there is none.
std::string folder_of(const std::string& path);
/// Whether a path ends in .png or .ppm, in either case of letters.
bool is_picture_name(const std::string& path);

/// What is wrong with the value of an option.
sturnus::Problem complaint(const std::string& option, std::string text);

/// What nobody expected on the command line, as a sentence; empty when all was expected.
std::string unexpected_words(const CLI::App& app);
/// CLI11's complaint as a sentence that names the command.
std::string sentence_of(const CLI::ParseError& error, const CLI::App& app);

}  // namespace program
