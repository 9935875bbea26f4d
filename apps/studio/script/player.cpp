// The verbs of a script, as beats.
#include "script/player.h"

#include <sturnus/parameters.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace studio {
namespace {

constexpr double caption_seconds = 4;
constexpr float points_per_frame = 22;  // the pace of the hand
constexpr int least_frames = 8, most_frames = 45;
constexpr int frames_down = 5, frames_after_click = 8;

float eased(float part) {
  return part * part * (3 - 2 * part);
}

}  // namespace

Player::Player(Script script, Studio& studio) : script_(std::move(script)), studio_(studio) {
  const Box& world = studio.desk().layout.world;
  cursor_ = planned_ = {world.width / 2, world.height / 2};
  studio.desk().overlay = [this] { draw_overlay(); };
}

Player::~Player() {
  studio_.desk().overlay = nullptr;
}

bool Player::next() {
  while (beats_.empty() && status_) {
    if (at_ == script_.lines.size()) return false;
    begin(script_.lines[at_++]);
  }
  if (!status_) return false;
  const Beat beat = std::move(beats_.front());
  beats_.pop_front();
  beat();
  return static_cast<bool>(status_);
}

void Player::begin(const ScriptLine& line) {
  static const std::map<std::string, void (Player::*)(const std::vector<std::string>&)> deeds = {
      {"wait", &Player::wait},   {"move", &Player::move},     {"click", &Player::click},
      {"drag", &Player::drag},   {"key", &Player::press_key}, {"type", &Player::type},
      {"wheel", &Player::wheel}, {"say", &Player::caption},   {"shot", &Player::shoot},
      {"open", &Player::open}};
  line_ = line.number;
  if (line.is_optional && !studio_.desk().items.contains(line.words[1])) return;
  (this->*deeds.at(line.words[0]))(line.words);
}

void Player::fail(const std::string& text) {
  if (status_) status_ = sturnus::Problem{script_.file, line_, "", text, false};
}

std::optional<double> Player::number(const std::string& word) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc{} && end == word.data() + word.size()) return value;
  fail("\"" + word + "\" is no number");
  return {};
}

// Points, or a share of the window such as 50%.
std::optional<float> Player::coordinate(const std::string& word, int whole) {
  const bool is_share = word.ends_with('%');
  const auto value = number(is_share ? word.substr(0, word.size() - 1) : word);
  if (!value) return {};
  return static_cast<float>(is_share ? *value / 100 * whole : *value);
}

std::optional<Player::Spot> Player::spot(const std::vector<std::string>& words, std::size_t& at) {
  const std::string& word = words[at++];
  if (!word.empty() && (std::isdigit(static_cast<unsigned char>(word[0])) != 0 || word[0] == '-')) {
    if (at >= words.size())
      return fail("a place has two numbers, but after " + word + " the line ends"), std::nullopt;
    const Box& world = studio_.desk().layout.world;
    const auto x = coordinate(word, static_cast<int>(world.width));
    const auto y = coordinate(words[at++], static_cast<int>(world.height));
    if (!x || !y) return {};
    return Spot{*x, *y};
  }
  const auto& items = studio_.desk().items;
  const auto found = items.find(word);
  if (found != items.end())
    return Spot{found->second.x + found->second.width / 2, found->second.y + found->second.height / 2};
  std::vector<std::string> known;
  for (const auto& [name, box] : items) known.push_back(name);
  const std::string near = sturnus::nearest_word(word, known);
  fail("there is no \"" + word + "\" in the window" +
       (near.empty() ? "" : "; did you mean \"" + near + "\"?"));
  return {};
}

std::optional<Player::Manner> Player::manner(const std::vector<std::string>& words, std::size_t at) {
  Manner out;
  for (; at < words.size(); ++at) {
    if (const int button = button_of_word(words[at]); button != 0) {
      out.button = button;
    } else if (const int mod = modifier_of(words[at]); mod != 0) {
      out.mod |= mod;
    } else if (const auto frames = number(words[at]); frames && *frames >= 1 && *frames <= 1e5) {
      out.frames = static_cast<int>(*frames);
    } else {
      fail("\"" + words[at] + "\" is neither a button, nor ctrl, shift or alt, nor a number of frames");
      return {};
    }
  }
  return out;
}

void Player::wait(const std::vector<std::string>& words) {
  const auto frames = number(words[1]);
  if (!frames) return;
  if (!(*frames >= 0 && *frames <= 1e6)) return fail("the frames to wait must be between 0 and 1e6");
  rest(static_cast<int>(*frames));
}

void Player::move(const std::vector<std::string>& words) {
  std::size_t at = 1;
  const auto to = spot(words, at);
  const auto how = to ? manner(words, at) : std::nullopt;
  if (how) glide(planned_, *to, how->frames);
}

void Player::click(const std::vector<std::string>& words) {
  std::size_t at = 1;
  const auto to = spot(words, at);
  const auto how = to ? manner(words, at) : std::nullopt;
  if (!how) return;
  glide(planned_, *to, how->frames);
  rest(2);
  beats_.emplace_back([this, how = *how] { push_button(how.button, true, how.mod); });
  rest(frames_down);
  beats_.emplace_back([this, how = *how] { push_button(how.button, false, how.mod); });
  rest(frames_after_click);
}

void Player::drag(const std::vector<std::string>& words) {
  std::size_t at = 1;
  const auto from = spot(words, at);
  if (!from) return;
  if (words.size() < at + 2) return fail("a drag needs to know where to");
  const bool is_by_name = at == 2;
  const Box& world = studio_.desk().layout.world;
  const auto x = coordinate(words[at], static_cast<int>(world.width));
  const auto y = coordinate(words[at + 1], static_cast<int>(world.height));
  const auto how = x && y ? manner(words, at + 2) : std::nullopt;
  if (!how) return;
  const Spot to = is_by_name ? Spot{from->x + *x, from->y + *y} : Spot{*x, *y};
  glide(planned_, *from, 0);
  rest(2);
  beats_.emplace_back([this, how = *how] { push_button(how.button, true, how.mod); });
  rest(2);
  glide(*from, to, how->frames);
  rest(2);
  beats_.emplace_back([this, how = *how] { push_button(how.button, false, how.mod); });
  rest(frames_after_click);
}

void Player::wheel(const std::vector<std::string>& words) {
  const auto notches = number(words[1]);
  const auto how = notches ? manner(words, 2) : std::nullopt;
  if (!how) return;
  const int sign = *notches < 0 ? -1 : 1;
  for (int i = 0; i < std::min(100, static_cast<int>(std::abs(*notches))); ++i) {
    beats_.emplace_back([sign, mod = how->mod] {
      SDL_SetModState(static_cast<SDL_Keymod>(mod));
      SDL_Event event{};
      event.type = SDL_MOUSEWHEEL;
      event.wheel.y = sign;
      SDL_PushEvent(&event);
    });
    rest(3);
  }
  beats_.emplace_back([] { SDL_SetModState(KMOD_NONE); });
}

void Player::caption(const std::vector<std::string>& words) {
  const auto seconds = words.size() > 2 ? number(words[2]) : std::optional(caption_seconds);
  if (!seconds) return;
  caption_ = words[1];
  caption_end_ = studio_.desk().seconds + *seconds;
}

void Player::shoot(const std::vector<std::string>& words) {
  beats_.emplace_back([this, path = words[1]] {
    const sturnus::Status status = sturnus::save_picture(path, studio_.picture(true));
    if (!status) fail(status.problems().front().sentence());
  });
}

void Player::open(const std::vector<std::string>& words) {
  const auto scenario = sturnus::load_scenario(words[1]);
  if (!scenario) return fail(scenario.problems().front().sentence());
  studio_.desk().files.open(studio_.desk(), *scenario);
  rest(2);
}

void Player::rest(int frames) {
  for (int i = 0; i < frames; ++i) beats_.emplace_back([] {});
}

void Player::glide(Spot from, Spot to, int frames) {
  const float way = std::hypot(to.x - from.x, to.y - from.y);
  if (frames == 0) frames = std::clamp(static_cast<int>(way / points_per_frame), least_frames, most_frames);
  for (int i = 1; i <= frames; ++i) {
    const float part = eased(static_cast<float>(i) / static_cast<float>(frames));
    beats_.emplace_back([this, from, to, part] {
      push_motion({from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)});
    });
  }
  planned_ = to;
}

}  // namespace studio
