// Small deeds of the desk.
#include "desk.h"

namespace studio {
namespace {

constexpr double note_seconds = 6, problem_seconds = 12;

}  // namespace

void Desk::say(std::string text, bool is_problem) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  notes.push_back({{std::move(text), is_problem}, is_problem ? problem_seconds : note_seconds, {}});
}

void Desk::keep_saying(const std::string& about, std::string text) {
  unsay(about);
  say(std::move(text), true);
  notes.back().about = about;
}

void Desk::unsay(const std::string& about) {
  std::erase_if(notes, [&](const ShownNote& shown) { return !about.empty() && shown.about == about; });
}

void Desk::set(const std::string& path, const std::string& value, std::uint64_t gesture) {
  session.act(sturnus::SetParameter{path, value}, path, gesture);
}

void Desk::toggle_recording() {
  if (recorder.is_recording()) return recorder.stop();
  const std::string name = new_name(*this, film.is_gif ? ".gif" : ".mp4");
  const sturnus::Status status = recorder.start(name, pixels, film);
  if (!status) say(status.error(), true);
}

}  // namespace studio
