// Pictures of a running flock, of its measures, and sheets of several pictures.
#pragma once

#include <sturnus/measure.h>
#include <sturnus/picture.h>
#include <sturnus/simulation.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace sturnus {

/// What is drawn besides the boids.
struct RenderOptions {
  PictureOptions picture;
  bool trails = false;      ///< where each boid was in the last `camera.trail` steps
  bool index = false;       ///< cells or leaves of the neighbour index that hold boids
  bool velocities = false;  ///< an arrow along each velocity
  bool vectors = false;     ///< what one boid feels: an arrow for each term, its reaches, its neighbours
  /// Whose vectors; not given: of the boid that is nearest to the middle of the first picture.
  std::optional<std::uint64_t> boid = {};
  bool zoom = false;    ///< with vectors: show only what that boid can see
  bool caption = true;  ///< title, step and count in a corner, and with vectors a legend
  int threads = 0;      ///< 0: one for each core; the picture does not depend on it
};

/// Draws one simulation again and again. Trails need to have seen every step: call `follow` after each.
class Renderer {
 public:
  explicit Renderer(const RenderOptions& options = {});
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Remembers where the boids are, for trails.
  void follow(const Simulation& simulation);
  Image frame(const Simulation& simulation);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// The course of all measures of a scenario, one panel each; how many there are of each flock, where that
/// changes. Rows in order of their steps; none makes an empty plot.
Image plot_measures(const std::vector<Measures>& rows, const ScenarioDef& scenario, ThemeName theme,
                    int width = 1280);

/// Measures of several runs against the parameter that they differ in.
struct SweepPlot {
  std::string title;
  std::string parameter;       ///< "flock.fish.count"
  std::vector<double> values;  ///< of the parameter, rising
  struct Curve {
    std::string name;
    std::vector<double> results;  ///< one for each value; NaN leaves a gap, and so do missing ones at the end
  };
  struct Panel {
    std::string measure;  ///< "polarisation"
    std::vector<Curve> curves;
  };
  std::vector<Panel> panels;
};
Image plot_sweep(const SweepPlot& sweep, ThemeName theme, int width = 960);

/// Pictures from left to right and top to bottom, `columns` in a row, each with a caption.
Image picture_sheet(const std::vector<Image>& pictures, const std::vector<std::string>& captions, int columns,
                    ThemeName theme);

}  // namespace sturnus
