// Draws all boids of a frame, and the ways that they came.
#pragma once

#include <sturnus/result.h>

#include <array>
#include <vector>

#include "session/frame.h"
#include "view/lens.h"
#include "view/meshes.h"
#include "view/view.h"

namespace studio {

/// Frames that were uploaded, the newest first: one buffer each, which take turns.
class Past {
 public:
  /// Takes a frame's boids. Another generation forgets all; the same step once more takes the place of
  /// itself.
  void take(const Frame& frame);
  struct Step {
    gl::Pulled buffer{GL_RGBA32UI};
    std::size_t boids = 0;
  };
  /// How many frames there are.
  std::size_t size() const { return known_; }
  /// 0: the newest.
  const Step& at(std::size_t ago) const { return steps_[(newest_ + steps_.size() - ago) % steps_.size()]; }

 private:
  void advance(std::size_t room);

  std::vector<Step> steps_;
  std::size_t newest_ = 0, known_ = 0;
  std::uint64_t generation_ = 0, step_ = 0;
};

/// Steps that are kept when each has so many boids: their buffers take 64 MB at most.
std::size_t steps_kept(std::size_t boids);

/// The mesh that a flock's boids get.
Mesh mesh_of(const sturnus::FlockDef& flock, int dimensions, Look look, std::size_t boids);

/// Whether edges of triangles show: bodies and things in space have them, figures of the plane and points
/// fade by themselves. Of very many boids each is too small for that.
bool has_rough_edges(const Frame& frame, Look look);

class Boids {
 public:
  static sturnus::Result<Boids> create();
  void draw(const Past& past, const Frame& frame, const Lens& lens, const ViewOptions& options,
            const Moment& moment) const;
  void draw_trails(const Past& past, const Frame& frame, const Lens& lens, const ViewOptions& options,
                   const Moment& moment) const;

 private:
  Boids(gl::Program figures, gl::Program bodies, gl::Program points, gl::Program trails);
  void draw_kind(Mesh mesh, std::size_t boids, const Frame& frame, const Lens& lens,
                 const ViewOptions& options, const Moment& moment) const;

  gl::Program figures_, bodies_, points_, trails_;
  gl::Pulled meshes_{GL_RGBA32F};
  MeshBuffer parts_;
};

}  // namespace studio
