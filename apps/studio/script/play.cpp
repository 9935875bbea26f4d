// Frames of a script until its end.
#include "script/play.h"

#include <algorithm>

#include "script/player.h"

namespace studio {
namespace {

constexpr int most_frames = 12;

bool is_same(const std::map<std::string, Box>& one, const std::map<std::string, Box>& other) {
  const auto same_box = [](const auto& a, const auto& b) {
    return a.first == b.first && a.second.x == b.second.x && a.second.y == b.second.y &&
           a.second.width == b.second.width && a.second.height == b.second.height;
  };
  return std::equal(one.begin(), one.end(), other.begin(), other.end(), same_box);
}

// Panels know their size when they have been shown once: until they stand still there is nothing to point at.
// The world waits for them.
void settle_panels(Studio& studio) {
  Desk& desk = studio.desk();
  const bool plays = desk.playback.is_playing();
  desk.playback.play(false);
  std::map<std::string, Box> before;
  studio.frame();
  for (int i = 0; i < most_frames && (i == 0 || !is_same(before, desk.items)); ++i) {
    before = desk.items;
    studio.frame();
  }
  desk.playback.play(plays);
}

}  // namespace

sturnus::Status play(Studio& studio, const Script& script, const PlayOptions& options) {
  Desk& desk = studio.desk();
  settle_panels(studio);
  Player player(script, studio);
  if (!options.video.empty()) {
    FilmOptions film;
    film.frames_per_second = options.frames_per_second;
    film.waits = true;
    const sturnus::Status status = desk.recorder.start(options.video, desk.pixels, film);
    if (!status) return status;
  }
  while (player.next() && studio.frame()) {
  }
  if (options.video.empty()) return player.status();
  const Film film = desk.recorder.finish();
  return player.status() ? film.status : player.status();
}

}  // namespace studio
