// Feed: toward food within a radius, like an attraction that does not reach far (CS 184).
#include "rules/pull.h"
#include "rules/rules.h"

namespace sturnus {

template <int D>
Vec<D> feed(const FeedModel& feed, const Pieces& pieces, const Self<D>& self, float max_speed) {
  Vec<D> sum;
  int count = 0;
  pieces.visit<D>(self.position, feed.radius, [&](std::uint32_t, std::uint8_t kind, const Vec<D>& o) {
    if (kind != feed.kind) return;
    sum += feed.form == SteeringForm::linear ? o : unit(o);
    ++count;
  });
  if (count == 0) return {};
  const Vec<D> toward = sum * (1.0f / static_cast<float>(count));
  // A mean of unit vectors is shorter where they differ, and counts less.
  if (feed.form == SteeringForm::heading) return toward - self.heading();
  return pull_of({feed.form}, toward, self, max_speed);
}

template Vec<2> feed<2>(const FeedModel&, const Pieces&, const Self<2>&, float);
template Vec<3> feed<3>(const FeedModel&, const Pieces&, const Self<3>&, float);

}  // namespace sturnus
