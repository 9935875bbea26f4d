// The pointer: while pressed it attracts or repels within its range.
#include "rules/pull.h"
#include "rules/rules.h"

namespace sturnus {

template <int D>
Vec<D> pointer_pull(const PointerModel& model, const PointerState& pointer, const Self<D>& self,
                    const Wrapping& image, float max_speed) {
  if (!pointer.pressed) return {};
  const bool repels = pointer.mode == PointerMode::repel;
  Vec<D> o = offset(self.position, narrow_to<D>(pointer.at), image);
  const Vec<D> along = narrow_to<D>(pointer.along);
  o -= along * dot(o, along);
  if (length(o) > (repels ? model.repel_radius : model.radius)) return {};
  if (repels) o *= -1.0f;
  return pull_of({model.form, model.slowing}, o, self, max_speed);
}

template Vec<2> pointer_pull<2>(const PointerModel&, const PointerState&, const Self<2>&, const Wrapping&,
                                float);
template Vec<3> pointer_pull<3>(const PointerModel&, const PointerState&, const Self<3>&, const Wrapping&,
                                float);

}  // namespace sturnus
