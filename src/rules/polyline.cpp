// Places on a polyline: the nearest to somebody, and the one that lies further along.
#include <sturnus/steering.h>

#include <algorithm>
#include <limits>

#include "base/vec.h"

namespace sturnus {
namespace {

std::size_t piece_count(const Polyline& line) {
  const std::size_t corners = line.corners.size();
  return corners == 0 ? 0 : corners - (line.loop ? 0 : 1);
}

struct Piece {
  Vec<3> begin, along;  // a unit vector, or zero
  float size = 0;
};

Piece piece_of(const Polyline& line, std::size_t piece) {
  const Vec<3> begin{line.corners[piece]};
  const Vec<3> way = Vec<3>{line.corners[(piece + 1) % line.corners.size()]} - begin;
  return {begin, unit(way), length(way)};
}

OnPolyline on(const Piece& piece, std::size_t number, float into) {
  return {(piece.begin + piece.along * into).at, piece.along.at, 0, number, into};
}

}  // namespace

OnPolyline nearest_on(const Polyline& line, const Vector& place) {
  OnPolyline best;
  best.distance = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < piece_count(line); ++i) {
    const Piece piece = piece_of(line, i);
    const float into = std::clamp(dot(Vec<3>{place} - piece.begin, piece.along), 0.0f, piece.size);
    OnPolyline found = on(piece, i, into);
    found.distance = length(Vec<3>{place} - Vec<3>{found.at});
    if (found.distance < best.distance) best = found;
  }
  return best;
}

OnPolyline further_on(const Polyline& line, const OnPolyline& from, float length_ahead) {
  const std::size_t pieces = piece_count(line);
  std::size_t number = from.piece;
  float into = from.into_piece + length_ahead;
  for (std::size_t passed = 0; passed < pieces; ++passed) {
    const float size = piece_of(line, number).size;
    if (into <= size || (!line.loop && number + 1 == pieces)) break;
    into -= size;
    number = (number + 1) % pieces;
  }
  if (pieces == 0) return from;
  const Piece piece = piece_of(line, number);
  OnPolyline place = on(piece, number, std::min(into, piece.size));
  place.distance = length(Vec<3>{place.at} - Vec<3>{from.at});
  return place;
}

}  // namespace sturnus
