// Small pictures of all shipped scenarios, drawn on a thread while people look at something else.
#pragma once

#include <imgui.h>
#include <sturnus/picture.h>

#include <atomic>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace studio {

class Thumbnails {
 public:
  Thumbnails() = default;
  ~Thumbnails();
  Thumbnails(const Thumbnails&) = delete;
  Thumbnails& operator=(const Thumbnails&) = delete;

  static constexpr sturnus::Size size{320, 180};  ///< pixels: twice what is shown, for fine displays

  /// Begins to draw them in this theme, if they are not yet.
  void want(sturnus::ThemeName theme);
  /// Hands a few pictures that are ready to the graphics card. Needs the window's context.
  void upload();
  /// The picture, or null while there is none.
  ImTextureID of(const std::string& name) const;
  bool is_complete() const { return is_drawn_ && ready_count() == 0; }

 private:
  struct Ready {
    std::string name;
    sturnus::Image picture;
  };
  void draw_all(sturnus::ThemeName theme);
  std::size_t ready_count() const;
  void stop();

  std::thread artist_;
  bool is_wanted_ = false;
  sturnus::ThemeName theme_ = sturnus::ThemeName::dark;
  std::atomic<bool> quit_ = false, is_drawn_ = false;
  mutable std::mutex mutex_;
  std::vector<Ready> ready_;
  std::map<std::string, unsigned> textures_;  // OpenGL's names for them
};

/// The scenario's picture after a short flight with few boids.
sturnus::Image draw_thumbnail(const std::string& name, sturnus::ThemeName theme);

}  // namespace studio
