// Where the world is seen from: the plane by pan and zoom, space by orbit and flight.
#pragma once

#include <sturnus/picture.h>
#include <sturnus/scenario.h>

#include <array>

#include "view/points.h"

namespace studio {

/// A line from the eye through a pixel.
struct Ray {
  Point from{};
  Point along{0, 0, -1};  ///< unit length
};

/// Distance of a point from a ray; in the plane the ray stands upright on it, so it is the plane's distance.
float distance(const Ray& ray, const Point& point);

class Camera {
 public:
  /// The whole of a box, as large as it fits; keeps the plane's camera upright and space's at three quarters.
  void fit(const sturnus::Extent& extent, int dimensions);
  /// The window in pixels, and how much of it panels cover at the left, top, right and bottom: the middle of
  /// what is seen is the middle of the rest.
  void resize(sturnus::Size pixels, const std::array<float, 4>& covered = {});
  /// Shows what was seen beside panels in the whole window, as large as it fits.
  void fill();

  /// Moves what is under the hand by so many pixels.
  void pan(float dx, float dy);
  /// Nearer (above 1) or farther, keeping what is under the pixel.
  void zoom(float factor, float x, float y);
  /// Turns around the middle; pixels of a drag. In the plane: pans.
  void orbit(float dx, float dy);
  /// Moves the eye: right, up and forward, as shares of the distance to the middle. In the plane: pans.
  void fly(float right, float up, float forward);
  /// Turns the view around the eye itself, pixels of a drag.
  void look(float dx, float dy);
  /// Brings a point to the middle, part of the way (1: all).
  void follow(const Point& point, float part = 1);

  int dimensions() const { return dimensions_; }
  sturnus::Size pixels() const { return pixels_; }
  Point middle() const { return middle_; }
  Point eye() const;
  Point right() const;
  Point up() const;
  Point forward() const;
  /// Column-major, as glUniformMatrix4fv takes it: from world to clip coordinates.
  std::array<float, 16> matrix() const;
  /// In space: what is nearer to the eye than this is not drawn, length.
  float nearest() const;
  /// World length of a pixel at a place.
  float pixel_length(const Point& at) const;

  Ray ray(float x, float y) const;
  /// Where a pixel's ray meets the plane through `through` that faces the camera; in the plane, the point
  /// itself.
  Point place(float x, float y, const Point& through) const;
  /// Pixels from the left and the top, and the distance along the view; z <= 0 lies behind the eye.
  Point project(const Point& at) const;

 private:
  float half_slope() const;
  Point towards_eye() const;
  void turn(float dx, float dy);

  int dimensions_ = 2;
  sturnus::Size pixels_{1280, 720};
  float shift_x_ = 0,
        shift_y_ = 0;              // where the middle is seen: of half the window right and up of its middle
  float free_x_ = 1, free_y_ = 1;  // parts of the window that nothing covers
  Point middle_{};
  float span_ = 100;          ///< plane: world length of the window's height; space: distance of the eye
  float turn_ = 0.6f;         ///< space: radians around the upright axis
  float tilt_ = 0.35f;        ///< space: radians above the horizon
  float field_of_view_ = 40;  ///< space: degrees, vertical
};

}  // namespace studio
