// One frame after the other.
#include "studio.h"

#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <thread>

#include "panels/layout.h"
#include "panels/style.h"

namespace studio {
namespace {

constexpr double lockstep_seconds = 1.0 / 60;

// Where all but the outermost twentieth of the boids are, on every axis.
std::optional<sturnus::Extent> crowd_of(const Frame& frame) {
  if (frame.boids.size() < 2) return {};
  sturnus::Extent crowd;
  std::vector<float> places(frame.boids.size());
  for (std::size_t axis = 0; axis < frame.extent.min.size(); ++axis) {
    for (std::size_t i = 0; i < places.size(); ++i) places[i] = frame.boids[i].position[axis];
    std::sort(places.begin(), places.end());
    const std::size_t left_out = places.size() / 40;
    crowd.min.push_back(double{places[left_out]});
    crowd.max.push_back(double{places[places.size() - 1 - left_out]} + 1e-6);
  }
  return crowd;
}

bool same(const sturnus::Extent& one, const sturnus::Extent& other) {
  return one.min == other.min && one.max == other.max;
}

}  // namespace

Studio::ImguiEnd::~ImguiEnd() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext();
}

sturnus::Result<std::unique_ptr<Studio>> Studio::open(sturnus::Simulation simulation,
                                                      const StudioOptions& options) {
  auto window = Window::open("Sturnus", options.points);
  if (!window) return window.problems();
  auto view = View::create();
  if (!view) return view.problems();
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui_ImplOpenGL3_Init("#version 330");
  return std::unique_ptr<Studio>(
      new Studio(std::move(*window), std::move(*view), std::move(simulation), options));
}

Studio::Studio(Window window, View view, sturnus::Simulation simulation, const StudioOptions& options)
    : options_(options),
      window_(std::move(window)),
      view_(std::move(view)),
      session_(std::move(simulation), {options.history_bytes, options.in_lockstep}),
      desk_(session_) {
  desk_.view.theme = options.theme;
  remembered_ = recall(options.memory);
  desk_.open.legend = remembered_.legend;
  desk_.open.hint = remembered_.hint;
}

Studio::~Studio() = default;

bool Studio::frame() {
  const auto begin = std::chrono::steady_clock::now();
  const double seconds = time_of_frame();
  SDL_Event event;
  while (SDL_PollEvent(&event) != 0) hear(event);
  desk_.files.poll(desk_);
  serve(seconds);
  fly(seconds);
  tell_of_film();
  counted_ = std::chrono::steady_clock::now();
  show_panels(seconds);
  count_time(times_.panels);
  remember_panels();
  notice_hand();
  is_frame_due_ = desk_.recorder.is_due(seconds);
  draw();
  desk_.frame_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  window_.present();
  rest(begin);
  return !desk_.wants_quit;
}

// Where the display does not set the pace, the clock does.
void Studio::rest(std::chrono::steady_clock::time_point begin) const {
  if (options_.in_lockstep || window_.has_pace()) return;
  std::this_thread::sleep_until(begin + std::chrono::microseconds(1'000'000 / 60));
}

double Studio::time_of_frame() {
  const auto now = std::chrono::steady_clock::now();
  const double passed = std::chrono::duration<double>(now - last_frame_).count();
  last_frame_ = now;
  const double seconds = options_.in_lockstep ? lockstep_seconds : std::min(passed, 0.25);
  desk_.seconds += seconds;
  return seconds;
}

// Takes the newest frame, and asks for the steps that are due.
void Studio::serve(double seconds) {
  desk_.frame = session_.frame();
  desk_.playback.advance(seconds, *desk_.frame, session_);
  if (options_.in_lockstep) {
    session_.settle();
    desk_.frame = session_.frame();
  }
  if (titled_ != desk_.scenario().name)
    window_.set_title((titled_ = desk_.scenario().name) + " \u2013 Sturnus");
  for (Note& note : session_.take_notes()) desk_.say(std::move(note.text), note.is_problem);
  for (const auto& what : session_.take_handed_back()) what(desk_);
  desk_.is_tracking = desk_.frame->tracked.has_value();
  if (!same(fitted_, desk_.frame->extent)) {
    resize_camera();
    fit_camera();
    desk_.tools.suit(*desk_.frame);
    fitted_ = desk_.frame->extent;
  }
  if (wished_ == desk_.wishes) return;
  wished_ = desk_.wishes;
  session_.order([wishes = wished_](World& world) {
    world.wish(wishes);
    return sturnus::Status();
  });
}

// Whether the mouse is over the world is known when the panels stand; a pointer that left it lets go, and so
// does one whose tool was laid down.
void Studio::notice_hand() {
  const bool was_in_view = desk_.hand.in_view;
  desk_.hand.in_view = !ImGui::GetIO().WantCaptureMouse && ImGui::IsMousePosValid() && desk_.hand.x >= 0;
  if (drag_ == Drag::orbit || drag_ == Drag::look) return;
  desk_.tools.notice(desk_.hand, *desk_.frame, desk_.camera, session_);
  if (was_in_view != desk_.hand.in_view) desk_.tools.move(desk_.hand, *desk_.frame, desk_.camera, session_);
}

// The whole space, or the flock where the scenario's camera wants it.
void Studio::fit_camera() {
  const Frame& frame = *desk_.frame;
  const bool wants_flock = frame.scenario->camera.fit == sturnus::CameraFit::flock;
  const auto flock = wants_flock ? crowd_of(frame) : std::nullopt;
  desk_.camera.fit(flock ? *flock : frame.extent, frame.dimensions);
}

// The world's middle is the middle of what panels leave free.
void Studio::resize_camera() {
  const sturnus::Size points = window_.points();
  const Layout layout = lay_out(desk_, points);
  const auto width = static_cast<float>(points.width), height = static_cast<float>(points.height);
  const float scale = window_.density();
  desk_.camera.resize(
      window_.pixels(),
      {(layout.tools.x + layout.tools.width) * scale, (layout.top.y + layout.top.height) * scale,
       (width - layout.inspector.x) * scale, (height - layout.bottom.y) * scale});
}

void Studio::show_panels(double seconds) {
  const sturnus::Size pixels = window_.pixels(), points = window_.points();
  desk_.density = window_.density();
  desk_.pixels = pixels;
  if (loaded_scale_ != desk_.text_scale || loaded_density_ != desk_.density) {
    load_font(desk_.text_scale, desk_.density);
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    if (loaded_scale_ > 0) ImGui_ImplOpenGL3_CreateFontsTexture();
    loaded_scale_ = desk_.text_scale;
    loaded_density_ = desk_.density;
  }
  apply_style(desk_.view.theme, desk_.text_scale);
  input_.begin_frame(points, pixels, seconds);
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  desk_.items.clear();
  desk_.shapes.clear();
  desk_.layout = lay_out(desk_, points);
  show_top_bar(desk_);
  show_tool_column(desk_);
  show_legend(desk_);
  show_inspector(desk_);
  show_bottom(desk_);
  show_help(desk_);
  show_gallery(desk_);
  show_notes(desk_);
  if (std::exchange(desk_.wants_tracking, false)) toggle_tracking();
  if (desk_.overlay) desk_.overlay();
  ImGui::Render();
}

void Studio::remember_panels() {
  const Memory now{desk_.open.legend, desk_.open.hint};
  if (now == remembered_) return;
  remembered_ = now;
  remember(options_.memory, now);
}

void Studio::draw() {
  resize_camera();
  if (std::exchange(wants_picture_, false)) save_picture();
  if (is_frame_due_ && !desk_.recorder.options().with_panels) desk_.recorder.add(picture(false));
  counted_ = std::chrono::steady_clock::now();
  draw_world();
  count_time(times_.draw);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  count_time(times_.panels);
  if (is_frame_due_ && desk_.recorder.options().with_panels)
    desk_.recorder.add(read_pixels(window_.pixels()));
}

// Adds what passed since the last part of the frame was done, with what the graphics card still had to do.
void Studio::count_time(double& sum) {
  if (!options_.measures_frames) return;
  glFinish();
  const auto now = std::chrono::steady_clock::now();
  sum += std::chrono::duration<double>(now - std::exchange(counted_, now)).count();
  if (&sum != &times_.draw) return;
  ++times_.frames;
  if (std::exchange(uploaded_, desk_.frame->serial) == desk_.frame->serial) return;
  const double upload = view_.times().upload / 1e9;
  times_.upload += upload;
  times_.draw -= upload;
  ++times_.steps;
}

void Studio::draw_world() {
  const sturnus::Size pixels = window_.pixels();
  view_.upload(*desk_.frame);
  Shapes shapes(desk_.camera, desk_.density);
  for (const auto& add : desk_.shapes) add(shapes);
  desk_.tools.show(desk_.hand, *desk_.frame, desk_.camera, desk_.view.theme, shapes);
  Moment moment;
  moment.part = desk_.playback.part(*desk_.frame);
  moment.seconds = static_cast<float>(desk_.seconds);
  moment.scale = desk_.density;
  moment.tracked = desk_.frame->tracked;
  glViewport(0, 0, pixels.width, pixels.height);
  view_.draw(*desk_.frame, desk_.camera, desk_.view, moment, shapes);
}

// Without panels the world has the whole window, as a camera sees it that knows of no panels.
sturnus::Image Studio::picture(bool with_panels) {
  const Camera kept = desk_.camera;
  if (!with_panels) desk_.camera.fill();
  draw_world();
  desk_.camera = kept;
  if (with_panels) ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  return read_pixels(window_.pixels());
}

void Studio::save_picture() {
  const std::string name = new_name(desk_, ".png");
  const sturnus::Status status = sturnus::save_picture(name, picture(false));
  desk_.say(status ? "The picture is in " + name + "." : status.error(), !status);
}

void Studio::load(const sturnus::ScenarioDef& scenario) {
  desk_.files.open(desk_, scenario);
}

void Studio::tell_of_film() {
  const auto film = desk_.recorder.take_finished();
  if (!film) return;
  if (!film->status) return desk_.say(film->status.error(), true);
  std::string text = "The film is in ";
  text.append(film->path).append(".");
  if (film->missing > 0) {
    text.append(" ")
        .append(std::to_string(film->missing))
        .append(" of its ")
        .append(std::to_string(film->frames));
    text.append(" frames were left out, because writing took too long.");
  }
  desk_.say(text);
}

void Studio::toggle_tracking() {
  session_.order([](World& world) {
    const bool was_on = world.is_tracking();
    world.track({});
    if (!was_on) world.track_any();
    return sturnus::Status();
  });
}

}  // namespace studio
