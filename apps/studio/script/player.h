// Plays a scripted visit: one beat a frame, as events that a person's hand would make.
#pragma once

#include <deque>
#include <functional>
#include <map>

#include "script/script.h"
#include "studio.h"

namespace studio {

class Player {
 public:
  Player(Script script, Studio& studio);
  ~Player();
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;

  /// What happens before the next frame. False at the end of the script, or where it can't go on.
  bool next();
  /// Why it could not go on, with file and line.
  const sturnus::Status& status() const { return status_; }

 private:
  struct Spot {
    float x = 0, y = 0;  ///< points of the window
  };
  /// Words that may follow a place, in any order.
  struct Manner {
    int button = 1;  ///< SDL's number
    int mod = 0;     ///< SDL_Keymod
    int frames = 0;  ///< 0: as the way is long
  };
  using Beat = std::function<void()>;

  void begin(const ScriptLine& line);
  void fail(const std::string& text);
  std::optional<double> number(const std::string& word);
  std::optional<float> coordinate(const std::string& word, int whole);
  /// A place as X Y or as an item's name, from words[at] on; `at` moves behind it.
  std::optional<Spot> spot(const std::vector<std::string>& words, std::size_t& at);
  std::optional<Manner> manner(const std::vector<std::string>& words, std::size_t at);

  void wait(const std::vector<std::string>& words);
  void move(const std::vector<std::string>& words);
  void click(const std::vector<std::string>& words);
  void drag(const std::vector<std::string>& words);
  void press_key(const std::vector<std::string>& words);
  void type(const std::vector<std::string>& words);
  void wheel(const std::vector<std::string>& words);
  void caption(const std::vector<std::string>& words);
  void shoot(const std::vector<std::string>& words);
  void open(const std::vector<std::string>& words);

  void rest(int frames);
  void glide(Spot from, Spot to, int frames);
  void push_motion(Spot to);
  void push_button(int button, bool down, int mod);
  void draw_overlay() const;
  void draw_caption() const;

  Script script_;
  Studio& studio_;
  std::size_t at_ = 0;
  int line_ = 0;
  std::deque<Beat> beats_;
  Spot cursor_, planned_;  ///< where the cursor is, and where it is after the beats
  bool is_pressed_ = false;
  std::string caption_;
  double caption_end_ = 0;  ///< seconds of the desk
  sturnus::Status status_;
};

}  // namespace studio
