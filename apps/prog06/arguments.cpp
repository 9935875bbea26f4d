// Six arguments in a fixed order, and options anywhere between them.
#include "arguments.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

namespace prog06 {
namespace {

constexpr std::size_t argument_count = 6;
constexpr const char* argument_names[argument_count] = {"N", "R", "ws", "wa", "wc", "out.ppm"};
constexpr double largest_weight = 1e9;
constexpr double most_boids = 1e9;  // as many as the library takes; below that the memory decides

// The words, told apart.
struct Words {
  std::vector<std::string> arguments;
  std::vector<std::pair<std::string, std::string>>
      options;                  ///< key of the setting, and the word for its value
  std::set<std::string> given;  ///< keys of the options so far
  std::string config;
};

class Reader {
 public:
  explicit Reader(const std::vector<std::string>& words) : words_(words) {}

  sturnus::Result<Request> read() {
    sort_words();
    if (request_.help) return request_;
    take_arguments();
    take_settings();
    if (!problems_.empty()) return problems_;
    return request_;
  }

 private:
  void complain(const std::string& text) { problems_.push_back({"prog06", 0, "", text, false}); }

  void sort_words() {
    bool only_arguments = false;
    while (next_ < words_.size()) {
      const std::string& word = words_[next_++];
      if (only_arguments || (!word.starts_with("--") && word != "-h")) {
        found_.arguments.push_back(word);
      } else if (word == "--") {
        only_arguments = true;
      } else {
        take_option(word);
      }
    }
  }

  // --name VALUE or --name=VALUE
  void take_option(const std::string& word) {
    const auto equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const bool is_switch = name == "-h" || name == "--help" || name == "--3d";
    if (is_switch && equals != std::string::npos) return complain(name + " takes no value");
    if (name == "--3d") return add_option("dimensions", "3");
    if (is_switch) return void(request_.help = true);
    std::string key = name.substr(2);
    std::replace(key.begin(), key.end(), '-', '_');
    if (key != "config" && key != "keys" && setting_of(key) == nullptr) return complain(unknown(name));
    if (equals == std::string::npos && next_ == words_.size()) return complain(name + " needs a value");
    const std::string value = equals == std::string::npos ? words_[next_++] : word.substr(equals + 1);
    add_option(key, value);
  }

  void add_option(const std::string& key, const std::string& value) {
    const Setting* setting = setting_of(key);
    const bool is_new = found_.given.insert(key).second;
    if (!is_new && (setting == nullptr || !setting->may_repeat)) {
      return complain(option_name(key) + " is given twice" +
                      (key == "dimensions" ? " (--3d is the same as --dimensions 3)" : ""));
    }
    if (key == "config") {
      found_.config = value;
      if (value.empty()) complain("--config needs the name of a file");
    } else if (key == "keys") {
      take_keys(value);
    } else {
      found_.options.emplace_back(key, value);
    }
  }

  static std::string unknown(const std::string& name) {
    std::vector<std::string> known = {"--3d", "--config", "--keys", "--help"};
    for (const Setting& setting : settings()) known.push_back(option_name(setting.key));
    const std::string near = sturnus::nearest_word(name, known);
    return "unknown option \"" + name + "\"" +
           (near.empty() ? " (prog06 --help lists them)" : "; did you mean " + near + "?");
  }

  void take_keys(const std::string& keys) {
    const auto wrong = keys.find_first_not_of("aswq \x1b");
    if (wrong != std::string::npos) {
      return complain("--keys: the keys are a, s, w and q, and a space waits for a frame; there is no \"" +
                      keys.substr(wrong, 1) + "\"");
    }
    request_.choices.keys = keys;
  }

  void take_arguments() {
    const std::vector<std::string>& words = found_.arguments;
    std::string missing;
    for (std::size_t i = words.size(); i < argument_count; ++i)
      missing += std::string(" ") + argument_names[i];
    if (!missing.empty()) complain("missing:" + missing);
    if (words.size() > argument_count) {
      const bool has_option = std::any_of(words.begin(), words.end(), [](const std::string& word) {
        return word.starts_with("--");  // and stood behind --
      });
      complain("\"" + words[argument_count] + "\" is one word too many" +
               (has_option ? "; options come before --" : ""));
    }
    Choices& choices = request_.choices;
    double count = 0;
    take_number(0, 0, most_boids, count);
    if (count != std::floor(count)) complain("N must be a whole number, but is \"" + words[0] + "\"");
    choices.boids = static_cast<std::int64_t>(count);
    take_number(1, 0, largest_weight, choices.radius);
    take_number(2, -largest_weight, largest_weight, choices.separation);
    take_number(3, -largest_weight, largest_weight, choices.alignment);
    take_number(4, -largest_weight, largest_weight, choices.cohesion);
    if (words.size() < argument_count) return;
    choices.picture = words[5];
    if (choices.picture.empty()) complain("out.ppm must not be empty");
  }

  // The number that is argument i, all of it: "3x" is none, nor is "nan".
  void take_number(std::size_t i, double low, double high, double& place) {
    if (i >= found_.arguments.size()) return;
    const std::string& word = found_.arguments[i];
    const std::string name = argument_names[i];
    const bool has_plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
    double number = 0;
    const char* end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data() + (has_plus ? 1 : 0), end, number);
    const bool out_of_range = error == std::errc::result_out_of_range;
    if (stop != end || (error != std::errc() && !out_of_range)) {
      return complain(name + " must be a number, but is \"" + word + "\"");
    }
    if (out_of_range) return complain(name + " is out of range: " + word);
    if (!std::isfinite(number)) {
      return complain(name + " must be a finite number, but is \"" + word + "\"");
    }
    if (number < low)
      return complain(name + " must be at least " + sturnus::number_text(low) + ", but is " + word);
    if (number > high)
      return complain(name + " must be at most " + sturnus::number_text(high) + ", but is " + word);
    place = number;
  }

  // The file first, so that the command line has the last word.
  void take_settings() {
    if (!found_.config.empty()) {
      const sturnus::Status status = apply_file(found_.config, request_.choices);
      problems_.insert(problems_.end(), status.problems().begin(), status.problems().end());
    }
    for (const auto& [key, word] : found_.options) {
      const Setting& setting = *setting_of(key);
      const bool is_open_list = setting.is_list && !word.starts_with('[');
      const sturnus::Value value = setting.may_repeat ? sturnus::Value{word}
                                   : is_open_list     ? sturnus::parse_value("[" + word + "]")
                                                      : sturnus::parse_value(word);
      const std::string error = setting.take(request_.choices, value);
      if (!error.empty()) complain(option_name(key) + " " + error);
    }
    const Choices& choices = request_.choices;
    if (eye_of(choices) == choices.target) complain("eye and target are the same place");
  }

  static std::string option_name(std::string key) {
    std::replace(key.begin(), key.end(), '_', '-');
    return "--" + key;
  }

  const std::vector<std::string>& words_;
  std::size_t next_ = 0;
  Words found_;
  Request request_;
  sturnus::Problems problems_;
};

}  // namespace

const char* const usage = "usage: prog06 N R ws wa wc out.ppm [options]";

std::string help_text() {
  std::string text = std::string(usage) + R"(

A swarm of boids in a window, drawn by a software rasteriser.

Arguments:
  N        how many boids
  R        radius within which they push each other away
  ws       weight of separation
  wa       weight of alignment with all others
  wc       weight of cohesion with all others
  out.ppm  where the key w writes the picture: PNG where the name ends in .png, PPM otherwise

Keys: a animates and stops, s takes one step, w writes the picture, q or ESC quits.
Mouse: the left button attracts the boids, the right one drives them away.

Options:
)";
  const auto line = [&text](const std::string& left, const std::string& about) {
    text += "  " + left + std::string(left.size() < 25 ? 25 - left.size() : 1, ' ') + about + "\n";
  };
  line("--config FILE", "settings from a file: the options below with _ for -, as in boid_size = 0.1");
  for (const Setting& setting : settings()) {
    std::string name = "--" + setting.key + " " + setting.value;
    std::replace(name.begin(), name.begin() + static_cast<std::ptrdiff_t>(setting.key.size()) + 2, '_', '-');
    line(name, setting.about);
  }
  line("--3d", "the same as --dimensions 3");
  line("--keys KEYS", "presses keys by itself, one a frame; a space waits for a frame");
  line("--help", "this text");
  return text + R"(
Try: prog06 300 0.4 0.1 0.3 1.0 myboids.ppm
Exit codes: 0 done, 1 failed while running (no display, a picture not written), 2 wrong arguments, 130 interrupted.
)";
}

sturnus::Result<Request> read_arguments(const std::vector<std::string>& words) {
  return Reader(words).read();
}

}  // namespace prog06
