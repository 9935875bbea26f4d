// The unit that is followed: what it is, what it feels, and the same as arrows in the world.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "panels/inspector.h"
#include "panels/style.h"
#include "panels/widgets.h"

namespace studio {
namespace {

constexpr float longest_arrow = 60;      // points on the screen
constexpr float farthest_ring = 1e6f;    // lengths beyond this are no rings
constexpr std::size_t most_ringed = 48;  // neighbours, the nearest of them
constexpr float many_ringed = 16;        // more are fainter, so that one still sees between them

// One colour for each kind of term, in the table and in the world.
sturnus::Rgba term_colour(const std::string& kind) {
  using sturnus::rgb;
  static const std::map<std::string, sturnus::Rgba> known{
      {"separation", rgb(0xe69f00)}, {"alignment", rgb(0x009e73)},
      {"cohesion", rgb(0x56b4e9)},   {"avoid_obstacles", rgb(0x9aa5b1)},
      {"flee", rgb(0xd55e00)},       {"evade", rgb(0xd55e00)},
      {"noise", rgb(0xb58ee0)},      {"targets", rgb(0x3f8efc)},
      {"pointer", rgb(0x7cc4ff)},    {"cruise", rgb(0xcc79a7)},
      {"wander", rgb(0xb58ee0)},     {"hunt", rgb(0xff6b4a)},
      {"feed", rgb(0x6cc24a)}};
  const auto found = known.find(kind);
  return found == known.end() ? rgb(0xc9b458) : found->second;
}
const sturnus::Rgba cap_colour = sturnus::rgb(0xf0f3f6);

float length(const std::array<float, 3>& vector) {
  return std::sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
}

Point plus(const Point& from, const std::array<float, 3>& vector, float factor) {
  return {from[0] + vector[0] * factor, from[1] + vector[1] * factor, from[2] + vector[2] * factor};
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

// In as few letters as a narrow table has room for.
std::string brief(double value) {
  char text[32];
  std::snprintf(text, sizeof text,
                std::abs(value) >= 100   ? "%.0f"
                : std::abs(value) < 0.01 ? "%.1g"
                                         : "%.2g",
                value);
  return text;
}

std::string readable(std::string text) {
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

// Where the unit is shown, between two steps.
Point shown_place(const Desk& desk) {
  const Instance& boid = desk.frame->boids[*desk.frame->tracked];
  const float part = desk.frame->has_previous ? desk.playback.part(*desk.frame) : 1;
  Point at{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    at[axis] = boid.previous[axis] + part * (boid.position[axis] - boid.previous[axis]);
  return at;
}

float largest_granted(const sturnus::Explanation& told, const TrackingState& state) {
  float most = length(told.boundary);
  for (const sturnus::ExplainedTerm& term : told.terms) {
    if (!state.hidden.contains(term.kind)) most = std::max(most, length(term.granted));
  }
  return most;
}

// Rings and neighbours lie below the arrows.
void add_reaches(const sturnus::Explanation& told, const TrackingState& state, const Point& at,
                 Shapes& shapes) {
  std::map<float, bool> drawn;
  for (const sturnus::ExplainedTerm& term : told.terms) {
    if (!term.neighbours || state.hidden.contains(term.kind) ||
        !(term.radius > 0 && term.radius < farthest_ring))
      continue;
    const sturnus::Rgba colour = term_colour(term.kind);
    if (state.sight && term.field_of_view < 360 && !drawn[term.radius] && length(told.heading) > 0)
      shapes.sector(at, told.heading, term.radius, static_cast<float>(term.field_of_view),
                    sturnus::with_alpha(colour, 0.07f));
    if (state.rings) shapes.ring(at, term.radius, sturnus::with_alpha(colour, 0.6f), 1.5f);
    drawn[term.radius] = true;
  }
}

void add_neighbours(const sturnus::Explanation& told, const Point& at, float size, Shapes& shapes) {
  std::size_t ringed = 0;
  const auto counted = static_cast<float>(std::min(most_ringed, told.neighbours.size()));
  const float strength = 0.8f * std::sqrt(many_ringed / std::max(many_ringed, counted));
  for (const sturnus::ExplainedNeighbour& neighbour : told.neighbours) {
    if (neighbour.terms.empty() || ++ringed > most_ringed) continue;
    const auto nearest =
        std::min_element(neighbour.terms.begin(), neighbour.terms.end(),
                         [&](auto a, auto b) { return told.terms[a].radius < told.terms[b].radius; });
    shapes.ring(plus(at, neighbour.offset, 1), size,
                sturnus::with_alpha(term_colour(told.terms[*nearest].kind), strength), 1.2f);
  }
}

void add_arrows(const sturnus::Explanation& told, const TrackingState& state, const Point& at, float pixel,
                Shapes& shapes) {
  const float most = largest_granted(told, state);
  if (!(most > 0)) return;
  const float scale = longest_arrow * pixel / most;
  for (const sturnus::ExplainedTerm& term : told.terms) {
    if (!state.hidden.contains(term.kind) && length(term.granted) > 0.01f * most)
      shapes.arrow(at, plus(at, term.granted, scale), term_colour(term.kind), 2.5f);
  }
  if (!state.hidden.contains("boundary") && length(told.boundary) > 0)
    shapes.arrow(at, plus(at, told.boundary, scale), cap_colour, 2);
}

void step_to(Desk& desk, int direction) {
  desk.session.order([direction](World& world) {
    world.track_next(direction);
    return sturnus::Status();
  });
}

void show_buttons(Desk& desk, const sturnus::Explanation& told) {
  ImGui::AlignTextToFramePadding();
  ImGui::Text("Unit %llu", static_cast<unsigned long long>(told.id));
  mark(desk, "tracking.unit");
  const float side = ImGui::GetFrameHeight();
  ImGui::SameLine(ImGui::GetContentRegionMax().x - side * 4.4f);
  if (button(desk, "tracking.previous", "\u2190", "The unit before (left key)")) step_to(desk, -1);
  ImGui::SameLine(0, 4);
  if (button(desk, "tracking.next", "\u2192", "The next unit (right key)")) step_to(desk, 1);
  ImGui::SameLine(0, 4);
  if (button(desk, "tracking.end", "\u00d7", "Back to the settings (T)")) {
    desk.is_tracking = false;
    desk.session.order([](World& world) {
      world.track({});
      return sturnus::Status();
    });
  }
}

void show_line(const char* name, const std::string& value) {
  faint(name);
  ImGui::SameLine(ImGui::GetFontSize() * 7);
  ImGui::TextWrapped("%s", value.c_str());
}

void show_facts(const sturnus::Explanation& told) {
  show_line("flock", told.flock_name);
  show_line("speed", number(static_cast<double>(length(told.velocity))) + " length per time");
  const auto counted = std::count_if(told.neighbours.begin(), told.neighbours.end(),
                                     [](const auto& neighbour) { return !neighbour.terms.empty(); });
  show_line("neighbours", std::to_string(counted));
}

void show_term(Desk& desk, const sturnus::ExplainedTerm& term, bool is_narrow) {
  const bool is_hidden = desk.tracking.hidden.contains(term.kind);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  if (dot_switch(desk, "tracking." + term.name, !is_hidden, packed(term_colour(term.kind)))) {
    if (is_hidden) desk.tracking.hidden.erase(term.kind);
    if (!is_hidden) desk.tracking.hidden.insert(term.kind);
  }
  tip("Its arrow, ring and neighbours in the world");
  ImGui::SameLine(0, 2);
  ImGui::AlignTextToFramePadding();
  const bool is_felt = length(term.felt) > 0;
  ImGui::PushStyleColor(ImGuiCol_Text,
                        ImGui::GetStyleColorVec4(is_felt ? ImGuiCol_Text : ImGuiCol_TextDisabled));
  const std::string weight = brief(static_cast<double>(term.weight)),
                    felt = brief(static_cast<double>(length(term.felt)));
  ImGui::TextWrapped("%s", readable(term.name).c_str());  // a long name takes two lines
  mark(desk, "tracking.name." + term.name);
  tip("Weight " + weight + ", felt " + felt + "\n" + term.formula +
      (term.source.empty() ? "" : "\nSource: " + term.source));
  const std::string gets = brief(static_cast<double>(length(term.granted)));
  for (const std::string& text : is_narrow ? std::vector{gets} : std::vector{weight, felt, gets}) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text.c_str());
  }
  ImGui::PopStyleColor();
  ImGui::TableNextColumn();
  faint(term.neighbours ? std::to_string(*term.neighbours) : "\u00b7");
}

// Where there is little room, weight and what is felt are only in the tooltips.
void show_table(Desk& desk, const sturnus::Explanation& told) {
  const bool is_narrow = ImGui::GetContentRegionAvail().x < 17 * ImGui::GetFontSize();
  std::vector<const char*> heads{"term", "weight", "felt", "gets", "of"};
  if (is_narrow) heads = {"term", "gets", "of"};
  if (!ImGui::BeginTable("terms", static_cast<int>(heads.size()), ImGuiTableFlags_SizingFixedFit)) return;
  for (const char* head : heads)
    ImGui::TableSetupColumn(
        head, head == heads.front() ? ImGuiTableColumnFlags_WidthStretch : ImGuiTableColumnFlags_WidthFixed);
  ImGui::TableNextRow();
  for (const char* head : heads) {
    ImGui::TableNextColumn();
    faint(head);
    tip("Weight as set; felt before the weight; what the term gets of the acceleration; of how many "
        "neighbours");
  }
  for (const sturnus::ExplainedTerm& term : told.terms) show_term(desk, term, is_narrow);
  ImGui::EndTable();
}

void show_sum(const sturnus::Explanation& told) {
  show_line("sum", number(static_cast<double>(length(told.sum))));
  const std::string cap =
      std::isinf(told.max_acceleration) ? "no limit" : number(static_cast<double>(told.max_acceleration));
  show_line("cap", "\u00d7 " + number(static_cast<double>(told.cap_factor)) + " (at most " + cap + ")");
  show_line("boundary", number(static_cast<double>(length(told.boundary))));
  show_line("acceleration",
            number(static_cast<double>(length(told.acceleration))) + " length per time\u00b2");
  if (told.is_jumping) ImGui::TextUnformatted("It is in a jump, and obeys nothing.");
}

void zoom_in(Desk& desk, const sturnus::Explanation& told, const Point& at) {
  float reach = 0;
  for (const sturnus::ExplainedTerm& term : told.terms) {
    if (term.neighbours && term.radius < farthest_ring) reach = std::max(reach, term.radius);
  }
  const float height = static_cast<float>(desk.camera.pixels().height);
  const float wanted = std::max(reach, 10.0f) * 5 / height, now = desk.camera.pixel_length(at);
  const sturnus::Size pixels = desk.camera.pixels();
  if (now > wanted)
    desk.camera.zoom(now / wanted, static_cast<float>(pixels.width) / 2,
                     static_cast<float>(pixels.height) / 2);
}

}  // namespace

void follow_tracked(Desk& desk) {
  const Frame& frame = *desk.frame;
  if (!desk.is_tracking || !frame.explained || !frame.tracked) {
    desk.tracking.was_on = desk.is_tracking && desk.tracking.was_on;
    return;
  }
  const Point at = shown_place(desk);
  desk.camera.follow(at);
  if (!std::exchange(desk.tracking.was_on, true)) zoom_in(desk, *frame.explained, at);
  const float size =
      static_cast<float>(frame.scenario->flocks[frame.boids[*frame.tracked].flock].size) * 0.7f;
  const float pixel = desk.camera.pixel_length(at) * desk.density;
  desk.shapes.push_back([told = *frame.explained, state = desk.tracking, at, size, pixel](Shapes& shapes) {
    add_reaches(told, state, at, shapes);
    if (state.neighbours) add_neighbours(told, at, size, shapes);
    add_arrows(told, state, at, pixel, shapes);
  });
}

void show_tracked(Desk& desk) {
  const sturnus::Explanation& told = *desk.frame->explained;
  show_buttons(desk, told);
  show_facts(told);
  ImGui::Dummy({0, 4});
  toggle(desk, "tracking.rings", "rings", desk.tracking.rings, "How far each term looks");
  ImGui::SameLine(0, 4);
  toggle(desk, "tracking.sight", "sight", desk.tracking.sight,
         "The field of view, where it is not all round");
  ImGui::SameLine(0, 4);
  toggle(desk, "tracking.neighbours", "neighbours", desk.tracking.neighbours,
         "Rings around those that count");
  ImGui::Dummy({0, 4});
  ImGui::BeginChild("forces");
  show_table(desk, told);
  ImGui::Separator();
  show_sum(told);
  ImGui::EndChild();
}

}  // namespace studio
