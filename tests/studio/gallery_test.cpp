// The gallery: searching, reading, opening, trying, recent files and saving.
#include "panels/gallery.h"

#include <sturnus/events.h>

#include <algorithm>

#include "ui.h"

namespace studio::test {
namespace {

class StudioGallery : public Ui {
 protected:
  void SetUp() override {
    Ui::SetUp();
    setenv("XDG_STATE_HOME", (std::filesystem::current_path() / "state").c_str(), 1);
  }
  void show() {
    key(SDLK_g);
    frames(3);
    ASSERT_TRUE(desk().open.gallery);
  }
  void type(const std::string& text) {
    for (const char letter : text) {
      SDL_Event event{};
      event.type = SDL_TEXTINPUT;
      event.text.text[0] = letter;
      SDL_PushEvent(&event);
      frames();
    }
    frames();
  }
  void search(const std::string& text) {
    press("gallery.search");
    type(text);
  }
  // Cards and lines that can be seen.
  std::vector<std::string> shown() {
    std::vector<std::string> names;
    for (const Exhibit& exhibit : exhibits()) {
      if (desk().items.contains("gallery." + exhibit.name)) names.push_back(exhibit.name);
    }
    return names;
  }
  std::string said() {
    std::string text;
    for (const ShownNote& shown : desk().notes) text += shown.note.text + "\n";
    return text;
  }
  std::size_t files_that_end(const std::string& ending) {
    std::size_t count = 0;
    for (const auto& file : std::filesystem::directory_iterator("."))
      count += file.path().string().ends_with(ending) ? 1u : 0u;
    return count;
  }
};

TEST_F(StudioGallery, ASecondClickOpensAndUndoBringsTheOldWorldBack) {
  open("ucsd");
  show();
  press("gallery.two-flocks");
  EXPECT_EQ(desk().gallery.looked_at, "two-flocks");
  EXPECT_EQ(world().scenario->name, "ucsd") << "one click only tells of it";
  press("gallery.two-flocks");
  frames(3);
  EXPECT_EQ(world().scenario->name, "two-flocks");
  EXPECT_FALSE(desk().open.gallery);
  key(SDLK_z, KMOD_CTRL);
  frames(3);
  EXPECT_EQ(world().scenario->name, "ucsd");
}

TEST_F(StudioGallery, TheDetailsStayWhileTheMouseCrossesOtherCards) {
  open("ucsd");
  show();
  press("gallery.two-flocks");
  for (const std::string& name : shown()) {
    const Box box = desk().items["gallery." + name];
    move(box.x + box.width / 2, box.y + box.height / 2);
  }
  EXPECT_EQ(desk().gallery.looked_at, "two-flocks");
  press("gallery.open");
  frames(3);
  EXPECT_EQ(world().scenario->name, "two-flocks");
}

TEST_F(StudioGallery, SearchLeavesWhatItFindsAndEnterOpensTheFirst) {
  open("ucsd");
  show();
  const std::size_t all = shown().size();
  search("zebra");
  const auto found = shown();
  EXPECT_LT(found.size(), all);
  ASSERT_FALSE(found.empty());
  for (const Exhibit& exhibit : exhibits()) {
    const bool is_shown = std::find(found.begin(), found.end(), exhibit.name) != found.end();
    if (is_shown) {
      EXPECT_TRUE(is_found(exhibit, "zebra")) << exhibit.name;
    }
  }
  key(SDLK_RETURN);
  frames(3);
  EXPECT_EQ(world().scenario->name, found.front());
}

TEST_F(StudioGallery, ATriedValueIsSetInTheWorldThatRuns) {
  open("two-flocks");
  show();
  const auto& all = exhibits();
  const auto here =
      std::find_if(all.begin(), all.end(), [](const Exhibit& each) { return each.name == "two-flocks"; });
  std::size_t index = 0;
  while (sturnus::is_fixed_while_running(here->try_this[index].substr(0, here->try_this[index].find(" = "))))
    ++index;
  const std::string path = here->try_this[index].substr(0, here->try_this[index].find(" = "));
  const std::string before = value(path);
  const std::uint64_t generation = world().generation;
  press("gallery.try." + std::to_string(index + 1));
  frames(3);
  EXPECT_NE(value(path), before);
  EXPECT_EQ(world().generation, generation) << "the flock flies on";
  EXPECT_FALSE(desk().open.gallery) << "so that one sees what it does";
  key(SDLK_z, KMOD_CTRL);
  frames(3);
  EXPECT_EQ(value(path), before);
}

TEST_F(StudioGallery, ATriedCountBeginsTheWorldAnewAndUndoBringsTheOldOneBack) {
  const auto& all = exhibits();
  const auto is_count = [](const std::string& line) { return line.find(".count = ") != std::string::npos; };
  const auto found = std::find_if(all.begin(), all.end(), [&](const Exhibit& each) {
    return each.group != "bench" && std::any_of(each.try_this.begin(), each.try_this.end(), is_count);
  });
  ASSERT_NE(found, all.end());
  const auto line = std::find_if(found->try_this.begin(), found->try_this.end(), is_count);
  const auto at = line - found->try_this.begin() + 1;
  const std::string path = line->substr(0, line->find(" = ")), wanted = line->substr(line->find(" = ") + 3);
  open(found->name, 33);
  show();
  frames(3);
  press("gallery.try." + std::to_string(at));
  frames(4);
  EXPECT_EQ(value(path), wanted) << said();
  EXPECT_EQ(world().scenario->name, found->name);
  key(SDLK_z, KMOD_CTRL);
  frames(3);
  EXPECT_NE(value(path), wanted);
}

TEST_F(StudioGallery, AnotherWorldsSuggestionOpensThatWorldWithIt) {
  open("ucsd");
  show();
  press("gallery.sharks-and-fish");
  press("gallery.try.1");
  frames(3);
  EXPECT_EQ(world().scenario->name, "sharks-and-fish");
  const auto& all = exhibits();
  const auto there = std::find_if(all.begin(), all.end(),
                                  [](const Exhibit& each) { return each.name == "sharks-and-fish"; });
  const std::string& line = there->try_this.front();
  EXPECT_EQ(value(line.substr(0, line.find(" = "))), line.substr(line.find(" = ") + 3));
}

// Every suggestion of every shipped scenario makes a world that can begin.
TEST(StudioExhibits, EverySuggestionCanBeTried) {
  for (const Exhibit& exhibit : exhibits()) {
    for (const std::string& line : exhibit.try_this) {
      const auto sign = line.find(" = ");
      if (sign == std::string::npos) continue;
      auto scenario = sturnus::load_scenario(exhibit.name);
      ASSERT_TRUE(scenario);
      const auto set = sturnus::set_parameter(*scenario, line.substr(0, sign),
                                              sturnus::parse_value(line.substr(sign + 3)));
      EXPECT_TRUE(set) << exhibit.name << ": " << line << "\n" << set.error();
      for (const sturnus::Problem& problem : sturnus::check(*scenario))
        EXPECT_TRUE(problem.is_warning) << exhibit.name << ": " << line << "\n" << problem.sentence();
    }
  }
}

TEST_F(StudioGallery, RecentFilesAreListedAndOpen) {
  auto mine = sturnus::load_scenario("ucsd");
  mine->flocks[0].count = 21;
  mine->name = "mine";
  ASSERT_TRUE(sturnus::write_text("mine.toml", sturnus::to_toml(*mine)));
  open("two-flocks");
  desk().files.open(desk(), "mine.toml");
  frames(3);
  ASSERT_EQ(world().boids.size(), 21u);
  key(SDLK_z, KMOD_CTRL);
  frames(3);
  ASSERT_EQ(world().scenario->name, "two-flocks");
  show();
  press("gallery.recent.mine.toml");
  frames(3);
  EXPECT_EQ(world().boids.size(), 21u);
  EXPECT_FALSE(desk().open.gallery);
}

TEST_F(StudioGallery, TheSaveButtonsWriteScenarioSessionAndBoids) {
  open("ucsd");
  frames(20);
  pause();
  click(500, 300);
  const std::uint64_t is = hash();
  show();
  press("gallery.save_scenario");
  EXPECT_EQ(files_that_end(".toml"), 1u) << said();
  press("gallery.save_session");
  EXPECT_EQ(files_that_end(".toml"), 2u) << said();
  press("gallery.save_state");
  EXPECT_EQ(files_that_end(".csv"), 1u) << said();
  EXPECT_EQ(hash(), is) << "saving changes nothing";
  press("gallery.file_name");
  type("kept");
  press("gallery.save_scenario");
  const auto kept = sturnus::load_scenario("kept.toml");
  ASSERT_TRUE(kept) << kept.error();
  EXPECT_EQ(kept->flocks[0].count, world().scenario->flocks[0].count);
}

}  // namespace
}  // namespace studio::test
