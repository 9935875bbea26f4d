// What a run of prog06 is to be: the six arguments, and the settings that a file or an option may change.
#pragma once

#include <sturnus/parameters.h>
#include <sturnus/picture.h>
#include <sturnus/triangles.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace prog06 {

/// PATH=VALUE, a further parameter of the scenario, and where it was said.
struct Parameter {
  std::string text;
  std::string file;  ///< of settings; empty on the command line
  int line = 0;      ///< in the file
};

/// Everything that may be chosen, with its defaults.
struct Choices {
  std::int64_t boids = 0;  ///< N
  double radius = 0;       ///< R, length: who is this near is felt by separation
  double separation = 0;   ///< ws
  double alignment = 0;    ///< wa
  double cohesion = 0;     ///< wc
  std::string picture;     ///< where the key w writes

  sturnus::Size size{720, 720};        ///< of the window and the picture, pixels
  std::optional<sturnus::Point3> eye;  ///< length; not given: see `eye_of`
  sturnus::Point3 target{};            ///< length; what the camera looks at
  double field_of_view = 40;           ///< degrees, vertical
  double boid_size = 0.06;             ///< factor on the cone of the assignment, which is 0.5 long
  int dimensions = 2;                  ///< 2 or 3
  std::optional<std::int64_t> seed;    ///< not given: the scenario's own
  std::vector<Parameter> parameters;   ///< in the order in which they are applied

  std::string keys;  ///< keys that press themselves, one a frame
};

/// Where the camera stands when it is not chosen: above the flat box, or aside of the cube, whose depth would
/// not show otherwise.
sturnus::Point3 eye_of(const Choices& choices);

/// One setting of a file (`boid_size = 0.1`) and of the command line (`--boid-size 0.1`).
struct Setting {
  std::string key;          ///< as in a file
  std::string value;        ///< what its value looks like, for the help
  std::string about;        ///< one line
  bool is_list = false;     ///< of numbers with commas between them on the command line
  bool may_repeat = false;  ///< on the command line
  /// Takes a value; the sentence says what is wrong with it and is empty otherwise.
  std::string (*take)(Choices& choices, const sturnus::Value& value);
};

const std::vector<Setting>& settings();

/// The setting of this key, or nothing.
const Setting* setting_of(const std::string& key);

/// Applies a file of settings; everything that is wrong with it otherwise, by file, line and key.
sturnus::Status apply_file(const std::string& path, Choices& choices);

}  // namespace prog06
