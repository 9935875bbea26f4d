// Frames of a script until its end.
#include "script/play.h"

#include "script/player.h"

namespace studio {

sturnus::Status play(Studio& studio, const Script& script, const PlayOptions& options) {
  Desk& desk = studio.desk();
  studio.frame();  // so that there are places to point at
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
