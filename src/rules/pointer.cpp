// The pointer: while pressed it attracts or repels within its range.
#include "rules/rules.h"

namespace sturnus {

template <int D>
Vec<D> pointer_pull(const PointerModel& model, const PointerState& pointer, const Self<D>& self,
                    const Wrapping& image, float max_speed) {
  if (!pointer.pressed) return {};
  Vec<D> o = offset(self.position, narrow_to<D>(pointer.at), image);
  if (length(o) > model.radius) return {};
  if (pointer.mode == PointerMode::repel) o *= -1.0f;
  switch (model.form) {
    case SteeringForm::heading:
      return narrow_to<D>(face(widened(o), widened(self.velocity)));
    case SteeringForm::seek:
      return narrow_to<D>(seek(widened(o), widened(self.velocity), max_speed));
    case SteeringForm::linear:
      return o;
  }
  return {};
}

template Vec<2> pointer_pull<2>(const PointerModel&, const PointerState&, const Self<2>&, const Wrapping&,
                                float);
template Vec<3> pointer_pull<3>(const PointerModel&, const PointerState&, const Self<3>&, const Wrapping&,
                                float);

}  // namespace sturnus
