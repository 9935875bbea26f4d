// Targets: places that attract or repel, several at once (VUW, CS 184, quadtree project).
#include "rules/pull.h"
#include "rules/rules.h"

namespace sturnus {

template <int D>
Vec<D> targets_pull(const Model& model, const std::vector<std::array<float, 3>>& places, std::size_t flock,
                    const Self<D>& self, const Wrapping& image) {
  Vec<D> sum;
  Vec<D> facing[2];
  float count[2] = {};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const TargetModel& target = model.targets[i];
    Vec<D> o = offset(self.position, narrow_to<D>(places[i]), image);
    if ((target.felt_by >> flock & 1) == 0 || length(o) > target.radius) continue;
    const bool repels = target.kind == TargetKind::repel;
    if (repels) o *= -1.0f;
    const Vec<D> pull =
        pull_of({target.form, target.slowing}, o, self, model.flocks[flock].max_speed) * target.weight;
    if (target.form == SteeringForm::heading) {
      facing[repels ? 1 : 0] += pull;
      count[repels ? 1 : 0] += 1;
    } else {
      sum += pull;
    }
  }
  for (int kind = 0; kind < 2; ++kind) {
    if (count[kind] > 0) sum += facing[kind] * (1.0f / count[kind]);
  }
  return sum;
}

template Vec<2> targets_pull<2>(const Model&, const std::vector<std::array<float, 3>>&, std::size_t,
                                const Self<2>&, const Wrapping&);
template Vec<3> targets_pull<3>(const Model&, const std::vector<std::array<float, 3>>&, std::size_t,
                                const Self<3>&, const Wrapping&);

}  // namespace sturnus
