// The tables and the JSON of an explanation.
#include "explain_report.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "json_text.h"
#include "output.h"

namespace program {
namespace {

using sturnus::ExplainedNeighbour;
using sturnus::ExplainedTerm;
using sturnus::Explanation;
using Json = nlohmann::ordered_json;
using Vector = std::array<float, 3>;
using Row = std::vector<std::string>;

double length(const Vector& v) {
  return std::hypot(double{v[0]}, double{v[1]}, double{v[2]});
}

std::string number(double value) {
  return format("%.4g", value == 0 ? 0.0 : value);
}

std::string vector_text(const Vector& v, int dimensions) {
  std::string out = "(";
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis)
    out += (axis == 0 ? "" : ", ") + number(double{v[axis]});
  return out + ")";
}

// Letters, not bytes.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

// Columns wide enough for all, two spaces apart; no line ends in spaces.
std::string table(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths;
  for (const Row& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  }
  std::string out;
  for (const Row& row : rows) {
    std::string line = "  ";
    for (std::size_t i = 0; i < row.size(); ++i)
      line += row[i] + std::string(widths[i] - width_of(row[i]) + 2, ' ');
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + "\n";
  }
  return out;
}

const char* name_of(sturnus::Arbitration arbitration) {
  switch (arbitration) {
    case sturnus::Arbitration::weighted:
      return "weighted";
    case sturnus::Arbitration::budget:
      return "budget";
    case sturnus::Arbitration::first:
      return "first";
  }
  return "";
}

std::string opening(const Explanation& e, const sturnus::ScenarioDef& scenario) {
  std::string out =
      format("Boid %llu of %s in %s, from step %llu to the next\n\n", static_cast<unsigned long long>(e.id),
             e.flock_name.c_str(), scenario.name.c_str(), static_cast<unsigned long long>(e.step));
  return out +
         table({{"position", vector_text(e.position, e.dimensions)},
                {"velocity", vector_text(e.velocity, e.dimensions), "speed", number(length(e.velocity))},
                {"heading", vector_text(e.heading, e.dimensions)}});
}

std::string term_table(const Explanation& e) {
  std::vector<Row> rows = {{"term", "neighbours", "asks for", "weight", "weighted", "granted", "length"}};
  for (const ExplainedTerm& term : e.terms) {
    rows.push_back({term.name, term.neighbours ? std::to_string(*term.neighbours) : "",
                    vector_text(term.felt, e.dimensions), number(double{term.weight}),
                    vector_text(term.weighted, e.dimensions), vector_text(term.granted, e.dimensions),
                    number(length(term.granted))});
  }
  const auto total = [&](const char* what, const std::string& how, const Vector& v) {
    rows.push_back({what, "", "", "", how, vector_text(v, e.dimensions), number(length(v))});
  };
  total("sum", "", e.sum);
  Vector capped = e.sum;
  for (float& component : capped) component *= e.cap_factor;
  const std::string cap =
      std::isinf(e.max_acceleration) ? "no cap" : "at most " + number(double{e.max_acceleration});
  total("capped", cap + ": times " + number(double{e.cap_factor}), capped);
  total("boundary", "", e.boundary);
  total("acceleration", "", e.acceleration);
  return std::string("\nTerms in their order, arbitration ") + name_of(e.arbitration) + "\n\n" + table(rows);
}

std::string result_line(const Explanation& e, const sturnus::ScenarioDef& scenario) {
  const sturnus::FlockDef& flock = scenario.flocks[static_cast<std::size_t>(e.flock)];
  if (e.is_jumping) {
    return "\nIt is in a jump, straight on whatever it feels. Next velocity: " +
           vector_text(e.next_velocity, e.dimensions) + ", speed " + number(length(e.next_velocity)) + "\n";
  }
  return "\nNext velocity, before the speed limits (" + number(flock.min_speed) + " to " +
         number(flock.max_speed) + "): v + dt·a = " + vector_text(e.next_velocity, e.dimensions) +
         ", dt = " + number(double{e.dt}) + ", speed " + number(length(e.next_velocity)) + "\n";
}

std::string counters(const Explanation& e, const ExplainedNeighbour& neighbour) {
  std::string out;
  for (const std::size_t term : neighbour.terms) out += (out.empty() ? "" : ", ") + e.terms[term].name;
  return out;
}

// In the plane one sees on which side somebody is.
std::string bearing_text(const Explanation& e, const ExplainedNeighbour& neighbour) {
  if (!neighbour.bearing) return "-";
  const std::string angle = format("%.0f°", std::abs(*neighbour.bearing));
  if (e.dimensions == 3 || angle == "0°" || angle == "180°") return angle;
  return angle + (*neighbour.bearing > 0 ? " left" : " right");
}

std::string neighbour_table(const Explanation& e, const sturnus::ScenarioDef& scenario, std::size_t most) {
  const std::size_t shown = std::min(most, e.neighbours.size());
  if (e.neighbours.empty()) return "\nNo neighbour counts for any term.\n";
  std::string out = "\n";
  out += counted(e.neighbours.size(), "neighbour");
  if (shown < e.neighbours.size()) out += ", the nearest " + std::to_string(shown);
  std::vector<Row> rows = {{"boid", "flock", "distance", "from heading", "counts for"}};
  for (std::size_t i = 0; i < shown; ++i) {
    const ExplainedNeighbour& one = e.neighbours[i];
    rows.push_back({std::to_string(one.id), scenario.flocks[static_cast<std::size_t>(one.flock)].name,
                    number(double{one.distance}), bearing_text(e, one), counters(e, one)});
  }
  return out + "\n\n" + (shown > 0 ? table(rows) : "");
}

// Each kind once, in the order of the terms.
std::string formula_table(const Explanation& e) {
  std::vector<Row> rows;
  for (const ExplainedTerm& term : e.terms) {
    const auto is_same = [&](const Row& row) { return row.front() == term.kind; };
    if (!term.formula.empty() && std::none_of(rows.begin(), rows.end(), is_same))
      rows.push_back({term.kind, term.formula, term.source});
  }
  return "\nFormulas (sturnus keys TERM tells more)\n\n" + table(rows);
}

// The number that the shortest text of the float means.
Json exact(float value) {
  if (!std::isfinite(value)) return nullptr;
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  double out = 0;
  std::from_chars(text, end, out);
  return out;
}

Json exact(const Vector& v, int dimensions) {
  Json out = Json::array();
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis)
    out.push_back(exact(v[axis]));
  return out;
}

Json term_json(const ExplainedTerm& term, int dimensions) {
  Json out;
  out["name"] = term.name;
  out["kind"] = term.kind;
  out["felt"] = exact(term.felt, dimensions);
  out["weight"] = exact(term.weight);
  out["weighted"] = exact(term.weighted, dimensions);
  out["granted"] = exact(term.granted, dimensions);
  out["neighbours"] = term.neighbours ? Json(*term.neighbours) : Json(nullptr);
  if (term.neighbours) {
    out["inner"] = exact(term.inner);
    out["radius"] = exact(term.radius);
    out["field_of_view"] = term.field_of_view;
  }
  out["formula"] = term.formula;
  out["source"] = term.source;
  return out;
}

Json neighbour_json(const Explanation& e, const ExplainedNeighbour& neighbour,
                    const sturnus::ScenarioDef& scenario) {
  Json out;
  out["id"] = neighbour.id;
  out["flock"] = scenario.flocks[static_cast<std::size_t>(neighbour.flock)].name;
  out["distance"] = exact(neighbour.distance);
  out["offset"] = exact(neighbour.offset, e.dimensions);
  out["bearing"] = neighbour.bearing ? Json(*neighbour.bearing) : Json(nullptr);
  out["terms"] = Json::array();
  for (const std::size_t term : neighbour.terms) out["terms"].push_back(e.terms[term].name);
  return out;
}

}  // namespace

std::string explanation_text(const Explanation& e, const sturnus::ScenarioDef& scenario, std::size_t most) {
  return opening(e, scenario) + term_table(e) + result_line(e, scenario) +
         neighbour_table(e, scenario, most) + formula_table(e);
}

std::string explanation_json(const Explanation& e, const sturnus::ScenarioDef& scenario) {
  Json out;
  out["scenario"] = scenario.name;
  out["step"] = e.step;
  out["boid"] = e.id;
  out["flock"] = e.flock_name;
  out["position"] = exact(e.position, e.dimensions);
  out["velocity"] = exact(e.velocity, e.dimensions);
  out["heading"] = exact(e.heading, e.dimensions);
  out["arbitration"] = name_of(e.arbitration);
  out["terms"] = Json::array();
  for (const ExplainedTerm& term : e.terms) out["terms"].push_back(term_json(term, e.dimensions));
  out["sum"] = exact(e.sum, e.dimensions);
  out["max_acceleration"] = exact(e.max_acceleration);
  out["cap_factor"] = exact(e.cap_factor);
  out["boundary"] = exact(e.boundary, e.dimensions);
  out["acceleration"] = exact(e.acceleration, e.dimensions);
  out["dt"] = exact(e.dt);
  out["is_jumping"] = e.is_jumping;
  out["next_velocity"] = exact(e.next_velocity, e.dimensions);
  out["neighbours"] = Json::array();
  for (const ExplainedNeighbour& neighbour : e.neighbours)
    out["neighbours"].push_back(neighbour_json(e, neighbour, scenario));
  return json_text(out);
}

}  // namespace program
