// Everything that touches a disk or a pipe. Files appear complete under their final names, or not at all.
#pragma once

#include <sturnus/measure.h>
#include <sturnus/picture.h>
#include <sturnus/result.h>
#include <sturnus/simulation.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace sturnus {

/// Reads a scenario: a shipped name such as "ucsd", or a path. Warnings go to `problems` when given;
/// otherwise the result carries every problem with file, line and key.
Result<ScenarioDef> load_scenario(const std::string& name_or_path, Problems* problems = nullptr);

/// Reads the state CSVs that a scenario names (relative to the scenario's folder) and creates the simulation.
Result<Simulation> open_simulation(const ScenarioDef& scenario, int threads = 0);

/// State CSV: header id,flock,x,y,vx,vy or id,flock,x,y,z,vx,vy,vz, one boid a line in storage order, numbers
/// that read back to the same bits; `flock` counts from 0. Scenarios that wander or drift colours add the
/// columns wander_x,wander_y(,wander_z) and red,green,blue; boids in quarantine add the column quarantined,
/// and where the newest boids are gone next_id keeps their ids from being used again. Hunters add their
/// clocks full, fasting, jump, rest and the id in focus, empty for nobody. A line with a number in the column
/// food is a piece of that kind of food, counted from 0, and has no more than id and place.
std::string state_csv(const State& state);
/// The state, or what is wrong with the text, by file and line. Columns may come in any order; velocity
/// columns and `flock` may be absent (0), id too (line order).
Result<State> parse_state_csv(std::string_view text, const std::string& file);
Result<State> read_state_csv(const std::string& path);

/// A whole file as text, or the sentence that says why not.
Result<std::string> read_text(const std::string& path);
/// Writes a whole file; /dev/stdout and the like are written directly.
Status write_text(const std::string& path, std::string_view text);
/// Creates a folder and those above it.
Status make_folder(const std::string& path);
/// What stands in the way of writing this file, found before any work is done: pictures (.png, .ppm), videos
/// (.mp4, .gif: also whether ffmpeg is there), frame patterns (frames/%05d.png), or anything else as plain
/// file.
Status check_output(const std::string& path);

/// The same for one file of any name, whatever its ending.
Status check_file(const std::string& path);

/// Whether a name means a video or a pattern of frames rather than one picture.
bool is_movie_name(const std::string& path);

/// Whether a name has a place for a number (states/%05d.csv), so that it means many files.
bool is_numbered_name(const std::string& path);
/// The file's name for a number: states/00007.csv for states/%05d.csv and 7. A pattern has one place for the
/// number, %d or %0Nd for N digits, in the file's name and not the folder's; %% is one percent sign.
Result<std::string> numbered_name(const std::string& pattern, std::int64_t number);

/// Writes a picture as PNG or PPM by the name's ending.
Status save_picture(const std::string& path, const Image& image);

/// Takes frames one by one: .mp4 and .gif through the ffmpeg program, or numbered pictures (frames/%05d.png).
/// A video appears under its name when `finish` succeeds, and never otherwise.
class Movie {
 public:
  /// All frames must have this size; `frames_per_second` is what the player shows.
  static Result<Movie> open(const std::string& path, Size size, double frames_per_second);
  ~Movie();
  Movie(Movie&&) noexcept;
  Movie& operator=(Movie&&) noexcept;
  Status add(const Image& frame);
  Status finish();

 private:
  struct Writers;
  explicit Movie(std::unique_ptr<Writers> writers);
  std::unique_ptr<Writers> writers_;
};

}  // namespace sturnus
