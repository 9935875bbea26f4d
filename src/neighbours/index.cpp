// Chooses the neighbour index, and the plainest of them: all pairs.
#include "neighbours/index.h"

#include <algorithm>
#include <cmath>

namespace sturnus {
namespace {

// The reference: everybody may be near, in the order in which they stand.
class AllPairs : public NeighbourIndex {
 public:
  void build(const Cloud& cloud, float, const Workers&, std::vector<std::uint32_t>& order) override {
    order.clear();
    cloud_ = cloud;
  }
  void spans(const std::array<float, 3>&, const std::array<float, 3>&, float,
             std::vector<Span>& spans) const override {
    spans.assign(1, {0, static_cast<std::uint32_t>(cloud_.count)});
  }
  void batches(std::vector<Span>& batches) const override {
    batches.clear();
    cut(0, static_cast<std::uint32_t>(cloud_.count), batches);
  }
  void boxes(std::vector<IndexBox>& boxes) const override { boxes.assign(1, {cloud_.min, cloud_.max}); }

 private:
  Cloud cloud_;
};

}  // namespace

void cut(std::uint32_t begin, std::uint32_t end, std::vector<Span>& batches) {
  for (; begin < end; begin += batch_size) batches.push_back({begin, std::min(end, begin + batch_size)});
}

std::unique_ptr<NeighbourIndex> make_all_pairs() {
  return std::make_unique<AllPairs>();
}

double padded_reach(const Cloud& cloud, float reach) {
  double size = 0;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(cloud.dimensions); ++axis) {
    size = std::max({size, std::abs(double{cloud.min[axis]}), std::abs(double{cloud.max[axis]})});
  }
  return double{reach} * 1.0001 + size * 1e-6;
}

bool may_divide(const Cloud& cloud, float reach) {
  if (!cloud.wraps) return true;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(cloud.dimensions); ++axis) {
    if (double{cloud.max[axis]} - double{cloud.min[axis]} < 3 * padded_reach(cloud, reach)) return false;
  }
  return true;
}

std::unique_ptr<NeighbourIndex> make_index(const Index& wanted, const Cloud& cloud, float reach) {
  if (wanted.kind == IndexKind::all_pairs || !may_divide(cloud, reach)) return make_all_pairs();
  if (wanted.kind == IndexKind::tree) return make_tree(wanted.leaf_size, wanted.depth_limit);
  return make_grid();
}

}  // namespace sturnus
