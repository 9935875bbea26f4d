// A user's program over the engine alone: a scenario made by hand, a rule of its own, no files.
#include <sturnus/measure.h>
#include <sturnus/simulation.h>

#include <cstdio>

int main() {
  sturnus::ScenarioDef scenario;
  scenario.flocks[0].count = 200;
  auto flock = sturnus::Simulation::create(scenario);
  if (!flock) {
    std::fputs(flock.error().c_str(), stderr);
    return 2;
  }
  flock->add_rule("wind", 0, [](const sturnus::View& view, sturnus::Accelerations& wind) {
    for (std::size_t slot = 0; slot < view.size(); ++slot) wind.add(slot, 0.02f, 0.0f);
  });
  flock->run(300);
  std::printf("polarisation %.3f, hash %016llx\n", sturnus::polarisation(flock->view()),
              static_cast<unsigned long long>(flock->hash()));
}
