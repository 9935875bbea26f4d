// What one boid feels, as a picture: its terms as arrows, how far each looks, and whom it counts.
#pragma once

#include <sturnus/explain.h>

#include "observe/scene.h"

namespace sturnus {

/// The boid in play that is nearest to the middle of what the camera frames; nothing where nobody is.
std::optional<std::uint64_t> boid_in_the_middle(const View& view);

/// A colour for every slot: neighbours in that of the term of the smallest reach that counts them, the boid
/// itself as text, everybody else grey, or transparent outside of `only`.
std::vector<Rgba> vector_colours(const View& view, const Explanation& told, const SceneColours& colours,
                                 const std::optional<Framing>& only = {});

/// Arrows, rings, the field of view, and ghosts of neighbours who are seen over the seam of the space. The
/// longest arrow is `longest` (length); the legend has the lengths as numbers.
void add_vectors(const View& view, const Explanation& told, const SceneColours& colours, float longest,
                 DrawList& list);
/// A thin circle around the boid, which is hard to find in a crowd.
void add_halo(const View& view, const Explanation& told, const SceneColours& colours, DrawList& list);
/// The terms by colour, name, length and number of neighbours, in the picture's upper right corner.
void add_legend(const Explanation& told, const SceneColours& colours, DrawList& list);

/// A box around the boid that holds the farthest of its finite reaches; nothing where it has none.
std::optional<Framing> framing_of(const Explanation& told);

}  // namespace sturnus
