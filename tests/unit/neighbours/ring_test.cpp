// The two parts of a ring: whole cells hold neighbours of every place of the box and nobody else, and
// everybody who is in the ring of any place stands in exactly one part.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "crowds.h"

namespace sturnus::test {
namespace {

struct RingQuestion {
  Corner low{}, high{};
  float inner = 0, outer = 1;
};

/// A place of the box: one of its corners, or any.
Corner place_in(const RingQuestion& question, std::uint32_t number, Dice& dice) {
  Corner at{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float share = number < 8 ? static_cast<float>(number >> axis & 1) : dice.share();
    at[axis] = std::clamp(question.low[axis] + (question.high[axis] - question.low[axis]) * share,
                          question.low[axis], question.high[axis]);
  }
  return at;
}

/// The box of a batch, or of any place of the world; in a wrapped world it lies inside.
RingQuestion random_question(const RandomWorld& world, std::span<const Span> batches, Dice& dice) {
  RingQuestion question;
  const Span batch = batches[dice.below(static_cast<std::uint32_t>(batches.size()))];
  const bool is_any_place = dice.below(3) == 0;
  for (std::size_t axis = 0; axis < world.axes(); ++axis) {
    const auto first = world.position[axis].begin() + batch.begin;
    const auto last = world.position[axis].begin() + batch.end;
    question.low[axis] = *std::min_element(first, last);
    question.high[axis] = is_any_place
                              ? std::min(world.max[axis], question.low[axis] + world.reach * dice.share() / 2)
                              : *std::max_element(first, last);
    question.high[axis] = std::max(question.low[axis], question.high[axis]);
  }
  question.outer = world.reach * (dice.below(2) == 0 ? 1.0f : dice.between(0.3f, 1));
  question.inner = dice.below(2) == 0 ? 0.0f : question.outer * dice.between(0, 0.8f);
  return question;
}

float distance_squared(const RandomWorld& world, const Corner& from, std::size_t boid) {
  Vec<3> to;
  for (std::size_t axis = 0; axis < world.axes(); ++axis) to.at[axis] = world.position[axis][boid];
  const Vec<3> o = offset<3>({from}, to, world.image());
  return world.dimensions == 3 ? dot(o, o) : o[0] * o[0] + o[1] * o[1];
}

bool is_in(const RingQuestion& question, float squared) {
  return question.inner * question.inner <= squared && squared < question.outer * question.outer;
}

/// Everybody in the cells, from where the shift says, at a distance within the ring in exact numbers too.
void expect_within(const RandomWorld& world, const RingQuestion& question, const CellRun& run,
                   const CellLayout& layout, const Corner& from) {
  for (std::uint32_t boid = layout.begin[run.first]; boid < layout.begin[run.last]; ++boid) {
    RC_ASSERT(is_in(question, distance_squared(world, from, boid)));
    double squared = 0;
    for (std::size_t axis = 0; axis < world.axes(); ++axis) {
      const double o = double{world.position[axis][boid]} + double{run.shift[axis]} - double{from[axis]};
      squared += o * o;
    }
    const double distance = std::sqrt(squared);
    RC_ASSERT(double{question.inner} <= distance);
    RC_ASSERT(distance < double{question.outer});
  }
}

/// How often each boid stands in the parts.
std::vector<int> times_named(const RandomWorld& world, const RingParts& parts, const CellLayout& layout) {
  std::vector<int> times(world.size(), 0);
  for (const Span span : parts.edge)
    for (std::uint32_t i = span.begin; i < span.end; ++i) ++times[i];
  for (const CellRun& run : parts.whole)
    for (std::uint32_t i = layout.begin[run.first]; i < layout.begin[run.last]; ++i) ++times[i];
  return times;
}

void expect_law(const RandomWorld& world, const NeighbourIndex& grid, const RingQuestion& question,
                Dice& dice, int& whole_cells) {
  RingParts parts;
  grid.ring(question.low, question.high, question.inner, question.outer, parts);
  const CellLayout layout = grid.layout();
  const auto times = times_named(world, parts, layout);
  for (const int named : times) RC_ASSERT(named <= 1);
  for (const CellRun& run : parts.whole) {
    RC_ASSERT(run.first / layout.cells_in_row == (run.last - 1) / layout.cells_in_row);
    whole_cells += static_cast<int>(run.last - run.first);
  }
  for (std::uint32_t place = 0; place < 12; ++place) {
    const Corner from = place_in(question, place, dice);
    for (const CellRun& run : parts.whole) expect_within(world, question, run, layout, from);
    for (std::size_t i = 0; i < world.size(); ++i) {
      if (world.hidden[i] == 0 && is_in(question, distance_squared(world, from, i))) RC_ASSERT(times[i] == 1);
    }
  }
}

/// Asks a grid over the world several times; returns how many whole cells it named.
int ask_often(RandomWorld& world, Dice& dice) {
  const auto grid = sorted_into_grid(world, *rc::gen::element(1, 2, 4, 7, 12));
  std::vector<Span> batches;
  grid->batches(batches);
  int whole_cells = 0;
  for (int i = 0; i < 6 && !batches.empty(); ++i)
    expect_law(world, *grid, random_question(world, batches, dice), dice, whole_cells);
  return whole_cells;
}

TEST(Ring, IsCutIntoWholeCellsAndEdges) {
  for (const int dimensions : {2, 3}) {
    for (const bool wraps : {false, true}) {
      int worlds = 0, with_whole_cells = 0;
      EXPECT_TRUE(rc::check(wraps ? "wrapped" : "open", [&] {
        Dice dice(*rc::gen::arbitrary<std::uint32_t>());
        RandomWorld world = crowded_world(dimensions, wraps, 800, dice);
        ++worlds;
        with_whole_cells += ask_often(world, dice) > 0 ? 1 : 0;
      }));
      EXPECT_GT(with_whole_cells, worlds / 3) << "too few whole cells for a proof";
    }
  }
}

/// A column of boids thousands of reaches long, outside of the space that its scenario speaks of.
RandomWorld long_column(int count, Dice& dice) {
  RandomWorld world;
  world.reach = 1;
  world.min = {-10, -10, 0};
  world.max = {10, 10, 0};
  for (int i = 0; i < count; ++i) {
    const float up = static_cast<float>(dice.below(40));
    world.position[0].push_back(dice.between(0, 1.5f));
    world.position[1].push_back(dice.below(4) == 0 ? dice.between(0, 3000)
                                                   : 3000 - up * 0.25f + dice.between(-1e-3f, 1e-3f));
    world.hidden.push_back(0);
    world.ids.push_back(static_cast<std::uint64_t>(i));
  }
  return world;
}

TEST(Ring, HoldsFarFromTheSpace) {
  EXPECT_TRUE(rc::check("a long column", [] {
    Dice dice(*rc::gen::arbitrary<std::uint32_t>());
    RandomWorld world = long_column(8000, dice);
    ask_often(world, dice);
  }));
}

}  // namespace
}  // namespace sturnus::test
