// Opening, watching, dropping and pasting.
#include "files/files.h"

#include <SDL.h>
#include <sturnus/files.h>

#include "desk.h"
#include "files/recent.h"
#include "session/replacing.h"

namespace studio {
namespace {

using sturnus::ScenarioDef;

constexpr double seconds_between_looks = 0.5;

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

}  // namespace

std::optional<Files::Look> Files::look_at(const std::string& path) {
  std::error_code error;
  Look look;
  look.time = std::filesystem::last_write_time(path, error);
  if (!error) look.size = std::filesystem::file_size(path, error);
  if (error) return {};
  return look;
}

void Files::watch(Desk& desk, const ScenarioDef& scenario) {
  if (!look_at(scenario.file)) return;
  remember_file(recent_list_path(), scenario.file);
  desk.session.order([scenario](World& world) {
    world.watch(scenario.file, scenario);
    return sturnus::Status();
  });
}

void Files::open(Desk& desk, const std::string& path) {
  const auto scenario = sturnus::load_scenario(path);
  if (!scenario) return desk.say(scenario.error(), true);
  const bool is_file = look_at(scenario->file).has_value();
  open_in(desk.session, *scenario, "open " + scenario->name, is_file);
  if (is_file) remember_file(recent_list_path(), scenario->file);
}

void Files::open(Desk& desk, const ScenarioDef& scenario) {
  open_in(desk.session, scenario, "open " + scenario.name, false);
}

void Files::drop(Desk& desk, const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".toml") return open(desk, path);
  if (ending == ".csv") {
    const std::string name = file_name(path);
    return replace_boids_in(desk.session, std::filesystem::absolute(path).string(), "boids of " + name,
                            "The boids are those of " + name + ".");
  }
  desk.say(file_name(path) + ": only scenarios (.toml) and states (.csv) can be dropped here.", true);
}

// Opening, undoing and redoing change whose file it is. What was saved while another world was shown is read
// now.
void Files::follow(Desk& desk) {
  if (opened_ == desk.frame->opened && path_ == desk.frame->watched) return;
  desk.unsay(path_);
  opened_ = desk.frame->opened;
  path_ = desk.frame->watched;
  look_.reset();
}

void Files::poll(Desk& desk) {
  follow(desk);
  if (path_.empty() || desk.seconds < next_look_) return;
  next_look_ = desk.seconds + seconds_between_looks;
  const auto look = look_at(path_);
  const bool is_half_written = look && look->size == 0;  // editors empty a file before they fill it
  if (!look || look == look_ || is_half_written) return;
  look_ = look;
  const auto scenario = sturnus::load_scenario(path_);
  if (!scenario) return desk.keep_saying(path_, scenario.error());
  desk.unsay(path_);
  reload_in(desk.session, path_, *scenario);
}

void Files::copy(Desk& desk) const {
  desk.session.order([&session = desk.session](World& world) {
    session.hand_back([text = to_toml(with_whole_paths(world.arranged()))](Desk& asked) {
      const bool copied = SDL_SetClipboardText(text.c_str()) == 0;
      asked.say(copied ? "The scenario is in the clipboard."
                       : std::string("The clipboard takes nothing: ") + SDL_GetError(),
                !copied);
    });
    return sturnus::Status();
  });
}

void Files::paste(Desk& desk) {
  char* held = SDL_GetClipboardText();
  const std::string text = held == nullptr ? "" : held;
  SDL_free(held);
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    return desk.say("The clipboard holds no text; copy a scenario first.", true);
  const auto scenario = sturnus::parse_scenario(text, "clipboard");
  if (!scenario) return desk.say(scenario.error(), true);
  open(desk, *scenario);
}

}  // namespace studio
