// Lines, words and what may follow which verb.
#include "script/script.h"

#include <SDL.h>
#include <sturnus/parameters.h>

#include <algorithm>
#include <sstream>

namespace studio {
namespace {

using sturnus::Problem;

// The words of a line, or nothing where a quote is not closed.
std::optional<std::vector<std::string>> words_of(const std::string& line) {
  std::vector<std::string> words;
  std::string word;
  bool is_quoted = false, is_begun = false;
  for (const char c : line) {
    if (c == '#' && !is_quoted && !is_begun) break;
    const bool is_end = !is_quoted && (c == ' ' || c == '\t' || c == '\r');
    if (c == '"') {
      is_quoted = !is_quoted;
      is_begun = true;
    } else if (!is_end) {
      word += c;
      is_begun = true;
    } else if (is_begun) {
      words.push_back(std::exchange(word, {}));
      is_begun = false;
    }
  }
  if (is_quoted) return {};
  if (is_begun) words.push_back(word);
  return words;
}

std::string quoted_with_guess(const std::string& word) {
  std::vector<std::string> known;
  for (const Verb& verb : script_verbs()) known.emplace_back(verb.name);
  const std::string near = sturnus::nearest_word(word, known);
  return "\"" + word + "\" is no verb of scripts" + (near.empty() ? "" : "; did you mean \"" + near + "\"?");
}

// What is wrong with a line, or an empty text.
std::string fault_of(const std::vector<std::string>& words) {
  const auto& verbs = script_verbs();
  const auto verb =
      std::find_if(verbs.begin(), verbs.end(), [&](const Verb& one) { return words[0] == one.name; });
  if (verb == verbs.end()) return quoted_with_guess(words[0]);
  if (words.size() - 1 < verb->fewest || words.size() - 1 > verb->most)
    return words[0] + " is written " + verb->usage;
  if (words[0] == "key" && key_of(words[1]).sym == 0) return "there is no key \"" + words[1] + "\"";
  return {};
}

}  // namespace

const std::vector<Verb>& script_verbs() {
  static const std::vector<Verb> verbs = {
      {"wait", 1, 1, "wait FRAMES"},
      {"move", 1, 3, "move X Y [FRAMES] or move ITEM [FRAMES]"},
      {"click", 1, 4, "click X Y [left|right|middle] or click ITEM [left|right|middle]"},
      {"drag", 3, 8, "drag X Y X2 Y2 [FRAMES] [BUTTON] or drag ITEM DX DY [FRAMES] [BUTTON]"},
      {"key", 1, 1, "key NAME, such as space or ctrl+z"},
      {"type", 1, 1, "type \"TEXT\""},
      {"wheel", 1, 2, "wheel NOTCHES [ctrl]"},
      {"say", 1, 2, "say \"CAPTION\" [SECONDS]"},
      {"shot", 1, 1, "shot FILE.png"},
      {"open", 1, 1, "open SCENARIO"},
  };
  return verbs;
}

sturnus::Result<Script> parse_script(const std::string& text, const std::string& file) {
  Script script{file, {}};
  sturnus::Problems problems;
  std::istringstream stream(text);
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    auto words = words_of(line);
    if (words && words->empty()) continue;
    const bool is_optional = words && words->size() > 1 && words->front() == "maybe";
    if (is_optional) words->erase(words->begin());
    const std::string fault = words ? fault_of(*words) : "a quote is not closed";
    if (!fault.empty()) {
      problems.push_back(Problem{file, number, "", fault, false});
    } else {
      script.lines.push_back({number, std::move(*words), is_optional});
    }
  }
  if (!problems.empty()) return problems;
  return script;
}

int modifier_of(const std::string& word) {
  return word == "ctrl" ? KMOD_LCTRL : word == "shift" ? KMOD_LSHIFT : word == "alt" ? KMOD_LALT : 0;
}

int button_of_word(const std::string& word) {
  return word == "left"     ? SDL_BUTTON_LEFT
         : word == "middle" ? SDL_BUTTON_MIDDLE
         : word == "right"  ? SDL_BUTTON_RIGHT
                            : 0;
}

KeyPress key_of(const std::string& name) {
  KeyPress press;
  std::string rest = name;
  for (auto plus = rest.find('+'); plus != std::string::npos && plus + 1 < rest.size();
       plus = rest.find('+')) {
    const int mod = modifier_of(rest.substr(0, plus));
    if (mod == 0) return {};
    press.mod |= mod;
    rest.erase(0, plus + 1);
  }
  press.sym = SDL_GetKeyFromName(rest.c_str());
  return press;
}

}  // namespace studio
