// What can be wrong with hunters, their prey and their food, each in one sentence.
#include <sturnus/parameters.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "scenario/assign.h"
#include "scenario/common_checks.h"
#include "scenario/creatures.h"

namespace sturnus {
namespace {

constexpr std::size_t most_kinds_of_food = 64;

class CreatureChecker : Findings {
 public:
  CreatureChecker(const ScenarioDef& scenario, Problems& problems) : Findings(scenario, problems) {
    for (const FlockDef& flock : scenario.flocks) names_.push_back(flock.name);
    for (const FoodDef& food : scenario.food) foods_.push_back(food.name);
  }

  void run() {
    if (foods_.size() > most_kinds_of_food)
      say_error("food", say("there are more than ", most_kinds_of_food, " kinds of food"));
    for (std::size_t i = 0; i < scenario_.food.size(); ++i) check_food(i);
    for (const FlockDef& flock : scenario_.flocks) check_flock(flock, say("flock.", flock.name, "."));
  }

 private:
  void check_food(std::size_t i) {
    const FoodDef& food = scenario_.food[i];
    const std::string prefix = say("food.", food.name, ".");
    say_if(wrong_name("kinds of food", food.name,
                      {foods_.begin(), foods_.begin() + static_cast<std::ptrdiff_t>(i)}),
           prefix + "name");
    say_if(wrong_place(food.at, static_cast<std::size_t>(scenario_.space.dimensions)), prefix + "at");
    const std::string& colour = food.colour;
    if (!colour.empty() && !is_hex_colour(colour))
      say_error(prefix + "colour", say("must be \"#rrggbb\", but found \"", colour, "\""));
  }

  void check_flock(const FlockDef& flock, const std::string& prefix) {
    if (flock.hunt) check_hunt(flock, prefix);
    if (flock.jump && !flock.hunt)
      say_error(prefix + "jump", "a jump is at prey: it needs a hunt = { prey = [...] } in the same flock");
    if (flock.hunger && !flock.hunt)
      say_error(prefix + "hunger",
                "only who hunts can be hungry: it needs a hunt = { prey = [...] } in the same flock");
    if (flock.jump && std::isinf(flock.max_speed) && !(flock.cruise && flock.cruise->on))
      say_error(prefix + "jump", "has no speed to slow down to; give max_speed or cruise");
    if (flock.feed) check_feed(flock, prefix + "feed.");
  }

  void check_hunt(const FlockDef& flock, const std::string& prefix) {
    const Hunt& hunt = *flock.hunt;
    const std::string key = prefix + "hunt.prey";
    if (hunt.prey.empty()) say_error(key, "names nobody to hunt");
    for (const std::string& name : hunt.prey) {
      if (name == flock.name) say_error(key, "a flock can't hunt itself");
      const auto found = std::find(names_.begin(), names_.end(), name);
      if (found == names_.end()) {
        say_error(key, unknown_word("flock", name, names_));
      } else {
        check_prey(flock, scenario_.flocks[static_cast<std::size_t>(found - names_.begin())], prefix);
      }
    }
    if (hunt.aim != HuntAim::heading && std::isinf(flock.max_speed)) {
      say_error(prefix + "hunt.aim", say("goes at full speed, but the max_speed of \"", flock.name,
                                         "\" is infinite; give one, or aim = \"heading\""));
    }
    if (hunt.confusion > 0 && hunt.choose == HuntChoice::average)
      say_warning(prefix + "hunt.confusion", "has no effect: only choose = \"nearest\" has a prey in focus");
  }

  void check_prey(const FlockDef& flock, const FlockDef& prey, const std::string& prefix) {
    if (!(flock.body_radius + prey.body_radius > 0)) {
      say_warning(prefix + "body_radius", say("neither \"", flock.name, "\" nor its prey \"", prey.name,
                                              "\" has a body_radius: they hardly ever touch"));
    }
    const bool jumps = flock.jump && flock.jump->on;
    const double fastest = std::max(flock.max_speed, jumps ? flock.jump->speed : 0.0);
    if (fastest <= prey.max_speed) {
      say_warning(prefix + (jumps ? "jump.speed" : "max_speed"),
                  say("\"", flock.name, "\" can't outrun its prey \"", prey.name, "\"",
                      jumps ? " even in a jump: " : ": ", number_text(fastest), " is not above ",
                      number_text(prey.max_speed)));
    }
  }

  void check_feed(const FlockDef& flock, const std::string& prefix) {
    const Feed& feed = *flock.feed;
    if (std::find(foods_.begin(), foods_.end(), feed.on) == foods_.end()) {
      say_error(prefix + "on", foods_.empty() ? say("there is no food \"", feed.on,
                                                    "\"; a file needs a [[food]] with that name")
                                              : unknown_word("food", feed.on, foods_));
    }
    if (feed.form == SteeringForm::arrive)
      say_error(prefix + "form", "nobody slows down for food; \"arrive\" is for targets and the pointer");
    say_if(wrong_form(feed.form, flock), prefix + "form");
    if (feed.population_cap > 0 && feed.population_cap < flock.count) {
      say_warning(prefix + "population_cap", say(feed.population_cap, " is below the count of ", flock.count,
                                                 ": nobody is born until some have died"));
    }
  }

  std::vector<std::string> names_, foods_;
};

}  // namespace

void check_creatures(const ScenarioDef& scenario, Problems& problems) {
  CreatureChecker(scenario, problems).run();
}

}  // namespace sturnus
