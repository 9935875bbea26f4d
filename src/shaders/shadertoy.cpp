// From a scenario to Shadertoy tabs: the compiled Model as GLSL constants, in front of fixed functions.
#include <sturnus/shaders.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "draw/theme.h"
#include "scenario/model.h"
#include "shaders/tabs.h"

namespace sturnus {
namespace {

constexpr std::string_view numbers_begin = "// ---- numbers ----\n";
constexpr std::string_view numbers_end = "// ---- end of numbers ----\n";

// ---- what a shader can't say ----

class Objections {
 public:
  Objections(const ScenarioDef& scenario, ShaderWorld world) : scenario_(scenario), world_(world) {}

  Problems all() {
    if (world_ == ShaderWorld::window && scenario_.space.dimensions == 3)
      object("space.dimensions", "a space of three dimensions can't be the window");
    if (!scenario_.run.events.empty()) object("run.events", "a shader has no events");
    if (!scenario_.run.initial.empty()) object("run.initial", "a shader can't read boids from a file");
    if (!scenario_.obstacles.empty()) object("obstacle", "a shader knows no obstacles");
    if (scenario_.flocks.size() > 31) object("flock", "a shader has at most 31 flocks");
    if (scenario_.boid_count() > most_shader_boids) {
      object("flock",
             say("a shader has at most ", most_shader_boids, " boids, here are ", scenario_.boid_count()));
    }
    if (!scenario_.food.empty()) object("food", "a shader has no food");
    if (!scenario_.targets.empty()) object("target", "a shader has no targets");
    check_form("pointer.form", scenario_.pointer.form);
    if (scenario_.pointer.repel_radius) object("pointer.repel_radius", "a shader's mouse only attracts");
    for (const FlockDef& flock : scenario_.flocks) check_flock(flock);
    return problems_;
  }

 private:
  void object(const std::string& key, const std::string& text) {
    problems_.push_back({scenario_.file, 0, key, text, false});
  }

  void check_form(const std::string& key, SteeringForm form) {
    if (form == SteeringForm::arrive || form == SteeringForm::orbit)
      object(key, "a shader knows the forms heading, seek and linear");
  }

  void check_flock(const FlockDef& flock) {
    const std::string key = "flock." + flock.name + ".";
    if (flock.hunt) object(key + "hunt", "nobody hunts or dies in a shader");
    for (const Flee& flee : flock.flee) check_form(key + "flee.form", flee.form);
    if (flock.arbitration != Arbitration::weighted)
      object(key + "arbitration", "a shader adds its terms by weight and knows no other arbitration");
    if (!flock.start.file.empty()) object(key + "start.file", "a shader can't read boids from a file");
    if (flock.colour.averaging > 0)
      object(key + "colour.averaging", "a shader's colours don't drift; set it to 0");
    if (flock.colour.noise > 0) object(key + "colour.noise", "a shader's colours don't drift; set it to 0");
    if (flock.colour.start == "random")
      object(key + "colour.start", "a shader's flock has one colour; name it");
    check_behaviours(key, flock);
    check_samples(key + "separation", flock.separation);
    check_samples(key + "alignment", flock.alignment);
    check_samples(key + "cohesion", flock.cohesion);
  }

  void check_behaviours(const std::string& key, const FlockDef& flock) {
    const auto refuse = [&](const auto& term, const char* name) {
      if (term && term->on) object(key + name, "a shader does not know this behaviour");
    };
    refuse(flock.pursue, "pursue");
    refuse(flock.evade, "evade");
    refuse(flock.hide, "hide");
    refuse(flock.follow_path, "follow_path");
    refuse(flock.follow_wall, "follow_wall");
    refuse(flock.flow, "flow");
    refuse(flock.follow_leader, "follow_leader");
    refuse(flock.avoid_collisions, "avoid_collisions");
    refuse(flock.queue, "queue");
  }

  template <class Term>
  void check_samples(const std::string& key, const std::vector<Term>& terms) {
    for (const Term& term : terms) {
      if (term.on && term.sample < 1)
        object(key + ".sample", "a shader looks at all neighbours; set it to 1");
    }
  }

  const ScenarioDef& scenario_;
  ShaderWorld world_;
  Problems problems_;
};

// ---- values as GLSL ----

std::string glsl(float value) {
  if (std::isinf(value)) return value > 0 ? "ENDLESS" : "-ENDLESS";
  std::string text = say(value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}
std::string glsl(double value) {
  return glsl(static_cast<float>(value));
}
std::string glsl(int value) {
  return say(value);
}
std::string glsl(std::size_t value) {
  return say(value);
}
std::string glsl(bool value) {
  return value ? "true" : "false";
}
std::string glsl(const char* name) {
  return name;
}
std::string glsl(const std::array<float, 3>& v) {
  return say("vec3(", glsl(v[0]), ", ", glsl(v[1]), ", ", glsl(v[2]), ")");
}

template <class... Values>
std::string call(const char* name, const Values&... values) {
  std::string inside;
  ((inside += (inside.empty() ? "" : ", ") + glsl(values)), ...);
  return say(name, "(", inside, ")");
}

template <class Value>
std::string constant(const char* type, const char* name, const Value& value, const char* comment = "") {
  std::string line = say("const ", type, " ", name, " = ", glsl(value), ";");
  return line + (*comment == 0 ? "" : say("  // ", comment)) + "\n";
}

struct Row {
  std::string value;
  std::string comment;
};

std::string table(const char* type, const char* name, const std::vector<Row>& rows) {
  std::string out = say("const ", type, " ", name, "[", rows.size(), "] = ", type, "[](\n");
  for (std::size_t i = 0; i < rows.size(); ++i)
    out += say("  ", rows[i].value, i + 1 < rows.size() ? "," : "", "  // ", rows[i].comment, "\n");
  return out + ");\n";
}

std::array<float, 3> vec_of(const Coordinates& at) {
  std::array<float, 3> out{};
  for (std::size_t axis = 0; axis < at.size() && axis < 3; ++axis) out[axis] = static_cast<float>(at[axis]);
  return out;
}

// ---- the tables ----

const char* name_of(SteeringForm form) {
  if (form == SteeringForm::heading) return "FACE";
  return form == SteeringForm::seek ? "SEEK" : "LINEAR";
}

const char* name_of(BoundaryKind kind) {
  constexpr const char* names[] = {"OPEN", "WRAP", "TURN", "BOUNCE"};
  return names[static_cast<int>(kind)];
}

const char* added_by(const NeighbourRow& row) {
  if (row.quantity == Quantity::velocity) return "VELOCITY";
  if (row.quantity == Quantity::heading) return "HEADING";
  constexpr const char* names[] = {"GROWS", "CONSTANT", "FADES"};
  return names[static_cast<int>(row.strength)];
}

std::string upper(std::string text) {
  for (char& c : text) c = c >= 'a' && c <= 'z' ? static_cast<char>(c & ~32) : c;
  return text;
}

Row term_row(const FlockModel& flock, const std::string& flock_name, std::size_t number,
             const TermModel& term) {
  const NeighbourRow& row = flock.rows[static_cast<std::size_t>(term.row)];
  const float outer = row.whole_population ? FlockModel::infinity_f : row.outer_squared;
  const float inner = row.whole_population ? 0.0f : row.inner_squared;
  const std::string view = row.sees_all ? "ALL_ROUND" : glsl(row.cos_half_view);
  return {call("Term", number, upper(name_of(term.kind)).c_str(), static_cast<std::size_t>(row.flocks), inner,
               outer, view.c_str(), added_by(row), term.combine == Combine::mean,
               term.count_self ? 1.0f : 0.0f, term.relative, name_of(term.form), term.weight),
          say(flock_name, ": ", name_of(term.kind))};
}

bool looks_at_neighbours(const TermModel& term) {
  return term.row >= 0 && term.kind != TermKind::custom;
}

std::vector<Row> term_rows(const ScenarioDef& scenario, const Model& model) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < model.flocks.size(); ++i) {
    for (const TermModel& term : model.flocks[i].terms) {
      if (looks_at_neighbours(term))
        rows.push_back(term_row(model.flocks[i], scenario.flocks[i].name, i, term));
    }
  }
  return rows;
}

// The term of one kind that a flock has of its own, or one of weight 0.
TermModel own_term(const FlockModel& flock, TermKind kind) {
  const auto found = std::find_if(flock.terms.begin(), flock.terms.end(),
                                  [&](const TermModel& term) { return term.kind == kind; });
  if (found != flock.terms.end()) return *found;
  TermModel none;
  none.weight = 0;
  return none;
}

std::array<float, 3> flock_colour(const FlockDef& flock, std::size_t number) {
  if (!flock.colour.start.empty()) return colour_of_hex(flock.colour.start);
  const Rgba colour = theme(ThemeName::dark).flock(number);
  const auto share = [](std::uint8_t byte) { return static_cast<float>(byte) / 255.0f; };
  return {share(colour.r), share(colour.g), share(colour.b)};
}

Row flock_row(const FlockDef& def, const FlockModel& flock, std::size_t number, std::int64_t first) {
  constexpr double whole_turn = 6.283185307179586;
  const TermModel cruise = own_term(flock, TermKind::cruise);
  const TermModel noise = own_term(flock, TermKind::noise);
  const TermModel wander = own_term(flock, TermKind::wander);
  return {call("Flock", static_cast<int>(first), flock.min_speed, flock.max_speed, flock.max_acceleration,
               cruise.amount, cruise.weight, noise.amount, double{flock.noise_turn} / whole_turn,
               wander.amount, wander.weight, flock_colour(def, number), def.size),
          def.name};
}

std::vector<Row> flock_rows(const ScenarioDef& scenario, const Model& model) {
  std::vector<Row> rows;
  std::int64_t first = 0;
  for (std::size_t i = 0; i < model.flocks.size(); ++i) {
    rows.push_back(flock_row(scenario.flocks[i], model.flocks[i], i, first));
    first += scenario.flocks[i].count;
  }
  return rows;
}

Row start_row(const FlockDef& flock) {
  const Start& start = flock.start;
  const bool is_round = start.region == StartRegion::ball || start.region == StartRegion::ring;
  const bool in_space = start.region == StartRegion::space || (is_round && start.centre.empty());
  const std::array<float, 3> low = vec_of(is_round ? start.centre : start.min);
  std::array<float, 3> heading = vec_of(start.heading);
  const float size = std::hypot(heading[0], heading[1], heading[2]);
  for (float& component : heading) component /= size > 0 ? size : 1;
  return {
      call("Start", in_space, low, vec_of(start.max), start.region == StartRegion::ring ? start.inner : 0.0,
           is_round ? start.radius : 0.0, start.min_speed, start.max_speed, heading),
      flock.name};
}

bool starts_at_a_place(const FlockDef& flock) {
  return flock.start.region == StartRegion::box || !flock.start.centre.empty();
}

bool is_window(const ScenarioDef& scenario, const Model& model, ShaderWorld world) {
  if (world != ShaderWorld::automatic) return world == ShaderWorld::window;
  if (model.dimensions == 3 || std::any_of(scenario.flocks.begin(), scenario.flocks.end(), starts_at_a_place))
    return false;
  return model.min[0] == 0 && model.min[1] == 0 && model.size[0] >= 256 && model.size[1] >= 256;
}

std::string space_and_time(const ScenarioDef& scenario, const Model& model, ShaderWorld world) {
  std::string out;
  out += constant("int", "DIMENSIONS", model.dimensions);
  out += constant("bool", "WORLD_IS_WINDOW", is_window(scenario, model, world),
                  "one unit a pixel; otherwise from MIN to MAX");
  out += constant("vec3", "MIN", model.min);
  out += constant("vec3", "MAX", model.max);
  out += constant("int", "BOUNDARY", name_of(model.boundary));
  out += constant("vec3", "MARGIN", model.margin);
  out += constant("float", "TURN_STRENGTH", model.turn_strength);
  out += constant("float", "DT", model.dt);
  out += constant("bool", "SEMI_IMPLICIT", model.integrator == Integrator::semi_implicit_euler,
                  "the new velocity moves the boid");
  out += say("const uint SEED = ", static_cast<std::uint32_t>(scenario.seed), "u;\n");
  return out;
}

std::string mouse(const Model& model) {
  return constant("float", "MOUSE_WEIGHT", model.pointer.weight) +
         constant("float", "MOUSE_RADIUS", model.pointer.radius) +
         constant("int", "MOUSE_FORM", name_of(model.pointer.form));
}

// One line, whatever a title may hold: a comment must not end early.
std::string in_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r' || c == '\\'; }, ' ');
  return text;
}

std::string numbers(const ScenarioDef& scenario, const ShaderOptions& options) {
  const Model model = compile(scenario);
  std::vector<Row> starts;
  for (const FlockDef& flock : scenario.flocks) starts.push_back(start_row(flock));
  std::vector<Row> terms = term_rows(scenario, model);
  const std::size_t term_count = terms.size();
  if (terms.empty())
    terms.push_back({"Term(-1, 0, 0, 0.0, 0.0, 0.0, 0, false, 0.0, false, 0, 0.0)", "nothing"});

  std::string out = say("// ", in_one_line(scenario.title.empty() ? scenario.name : scenario.title));
  if (!scenario.source.empty()) out += say(", after ", in_one_line(scenario.source));
  out += "\n";
  if (!options.written_by.empty()) out += say("// Written by: ", in_one_line(options.written_by), "\n");
  out += constant("int", "COUNT", static_cast<std::size_t>(scenario.boid_count()), "boids");
  out += constant("bool", "WANDERS", model.uses_wander);
  out += space_and_time(scenario, model, options.world) + mouse(model);
  out += constant("int", "FLOCK_COUNT", scenario.flocks.size());
  out += table("Flock", "FLOCKS", flock_rows(scenario, model));
  out += table("Start", "STARTS", starts);
  out += constant("int", "TERM_COUNT", term_count);
  out += table("Term", "TERMS", terms);
  return out;
}

}  // namespace

Result<std::vector<ShaderTab>> shadertoy_tabs(const ScenarioDef& scenario, const ShaderOptions& options) {
  if (Problems problems = Objections(scenario, options.world).all(); !problems.empty()) return problems;
  std::string common = common_tab;
  const auto begin = common.find(numbers_begin) + numbers_begin.size();
  common.replace(begin, common.find(numbers_end) - begin, numbers(scenario, options));
  return std::vector<ShaderTab>{
      {"common.glsl", common}, {"buffer_a.glsl", buffer_a_tab}, {"image.glsl", image_tab}};
}

}  // namespace sturnus
