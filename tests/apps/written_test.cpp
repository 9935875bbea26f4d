// The written answers: five of them, each in at most a hundred words, and every figure they show is there.
#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

struct Answer {
  std::string title;
  std::size_t words = 0;
  std::vector<std::string> figures;
};

// A word is what has a letter or a digit; signs such as = and list bullets are none.
bool is_word(const std::string& text) {
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) return true;
  }
  return false;
}

std::vector<Answer> answers() {
  std::ifstream file(STURNUS_SOURCE "/written/README.md");
  std::vector<Answer> out;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("## ")) {
      out.push_back({line, 0, {}});
    } else if (!out.empty() && line.starts_with("![")) {
      const auto begin = line.find("](") + 2;
      out.back().figures.push_back(line.substr(begin, line.find(')', begin) - begin));
    } else if (!out.empty()) {
      std::istringstream words(line);
      for (std::string word; words >> word;) out.back().words += is_word(word) ? 1 : 0;
    }
  }
  return out;
}

TEST(Written, FiveAnswersOfAtMostAHundredWords) {
  const auto all = answers();
  ASSERT_EQ(all.size(), 5u);
  for (const Answer& answer : all) {
    EXPECT_GE(answer.words, 30u) << answer.title;
    EXPECT_LE(answer.words, 100u) << answer.title;
  }
}

TEST(Written, EveryFigureIsThereAndSmall) {
  std::size_t count = 0;
  for (const Answer& answer : answers()) {
    for (const std::string& figure : answer.figures) {
      ++count;
      std::ifstream file(STURNUS_SOURCE "/written/" + figure);
      std::ostringstream text;
      text << file.rdbuf();
      EXPECT_EQ(text.str().find("<svg"), 0u) << figure;
      EXPECT_LE(text.str().size(), 8000u) << figure;
    }
  }
  EXPECT_EQ(count, 4u);
}

}  // namespace
