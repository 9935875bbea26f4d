// Scripted visits: text lines that say where the mouse goes and which keys are pressed.
#pragma once

#include <sturnus/result.h>

#include <string>
#include <vector>

namespace studio {

struct ScriptLine {
  int number = 0;  ///< 1-based
  std::vector<std::string> words;
  bool is_optional = false;  ///< passed over where the window has no such item
};

struct Script {
  std::string file;
  std::vector<ScriptLine> lines;
};

/// What a script may say: a verb and how many words may follow it.
struct Verb {
  const char* name;
  std::size_t fewest, most;
  const char* usage;
};
const std::vector<Verb>& script_verbs();

/// Reads a script; words with spaces stand in "quotes", # begins a remark. Every line is checked.
sturnus::Result<Script> parse_script(const std::string& text, const std::string& file);

/// A key with what is held down besides: "space", "ctrl+z", "shift+ctrl+z".
struct KeyPress {
  int sym = 0;  ///< SDL_Keycode
  int mod = 0;  ///< SDL_Keymod
};
/// The key, or its sym is 0 where there is none of that name.
KeyPress key_of(const std::string& name);
/// "shift" as SDL_Keymod; 0 where the word is none of ctrl, shift and alt.
int modifier_of(const std::string& word);
/// "left", "middle", "right" as SDL's number; 0 where the word is none of them.
int button_of_word(const std::string& word);

}  // namespace studio
