// What the mouse does to the world: the tools, what they are called, and how strokes become commands.
#pragma once

#include <sturnus/colour.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "session/session.h"
#include "view/camera.h"
#include "view/shapes.h"

namespace studio {

enum class Tool { hand, add, obstacle, attractor, eraser, follow, avoid, food, predator, scatter };

struct ToolInfo {
  Tool tool;
  char key;          ///< on the keyboard; 0 to 9 or a letter
  const char* name;  ///< "add units"
  const char* hint;  ///< one sentence
  sturnus::Rgba colour;
};
const std::vector<ToolInfo>& tool_list();
const ToolInfo& info_of(Tool tool);

/// Where the mouse is and what it means there.
struct Hand {
  float x = -1, y = -1;  ///< pixels
  bool in_view = false;  ///< over the world and not over a panel
};

class Tools {
 public:
  Tool tool = Tool::hand;
  int power = 3;              ///< units per click are 2^power
  float radius = 30;          ///< of eraser and scatter, as a length
  std::size_t flock = 0;      ///< to whom units are added, index in file order
  std::size_t predators = 0;  ///< to whom predators are

  static constexpr int most_power = 12;

  std::int64_t units_per_click() const { return std::int64_t{1} << power; }
  /// Lengths that suit a world of this size.
  void suit(const Frame& frame);

  void press(const Hand& hand, bool right, const Frame& frame, const Camera& camera, Session& session);
  void move(const Hand& hand, const Frame& frame, const Camera& camera, Session& session);
  void release(const Hand& hand, const Frame& frame, const Camera& camera, Session& session);
  /// Once a frame: another tool or another moment of the world ends what the hand was doing.
  void notice(const Hand& hand, const Frame& frame, const Camera& camera, Session& session);
  /// Everyone near the cursor flies away.
  void scatter(const Hand& hand, const Frame& frame, const Camera& camera, Session& session);
  /// The tool's ring at the cursor, in its colour.
  void show(const Hand& hand, const Frame& frame, const Camera& camera, sturnus::ThemeName theme,
            Shapes& shapes) const;
  /// The flocks among which the tool can choose, the one to which it adds (nobody: there is none), and the
  /// choice of the next one.
  std::vector<std::size_t> choices(const sturnus::ScenarioDef& scenario) const;
  std::optional<std::size_t> chosen(const sturnus::ScenarioDef& scenario) const;
  void choose_next(const sturnus::ScenarioDef& scenario);
  /// What a click would touch, in words of the space: where new things go.
  Point place(const Hand& hand, const Frame& frame, const Camera& camera) const;

 private:
  void stroke(const Hand& hand, const Frame& frame, const Camera& camera, Session& session);
  void place_obstacle(const Point& at, const Frame& frame, Session& session);
  void add(const Point& at, const Frame& frame, Session& session);
  void bring_predators(const Point& at, const Frame& frame, Session& session);
  void add_food(const Point& at, const Frame& frame, Session& session);
  void follow(const Hand& hand, const Frame& frame, const Camera& camera, Session& session);
  void point(const Hand& hand, sturnus::PointerMode mode, bool pressed, const Frame& frame,
             const Camera& camera, Session& session);

  std::uint64_t gesture_ = 0;
  std::uint64_t generation_ = 0;  // of the frame that was noticed last
  Tool noticed_ = Tool::hand;
  bool rests_ = false;        // after a jump: motion alone does nothing until a click or until the mouse left
  bool is_pressed_ = false;   // a stroke goes on
  bool is_pointing_ = false;  // the world's pointer is pressed
  sturnus::PointerMode mode_ = sturnus::PointerMode::attract;
  float last_x_ = -1e9f, last_y_ = -1e9f;
};

}  // namespace studio
