// Values as files and command lines state them: text to value and back.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sturnus/parameters.h>

#include <cmath>
#include <limits>

namespace sturnus {
namespace {

TEST(ParseValue, ReadsEveryKind) {
  EXPECT_EQ(std::get<double>(parse_value("12").held), 12);
  EXPECT_EQ(std::get<double>(parse_value(" -1.5e-3 ").held), -0.0015);
  EXPECT_EQ(std::get<double>(parse_value("+2").held), 2);
  EXPECT_EQ(std::get<double>(parse_value("inf").held), infinity);
  EXPECT_TRUE(std::isnan(std::get<double>(parse_value("nan").held)));
  EXPECT_EQ(std::get<bool>(parse_value("true").held), true);
  EXPECT_EQ(std::get<std::string>(parse_value("wrap").held), "wrap");
  EXPECT_EQ(std::get<std::string>(parse_value("\"wrap\"").held), "wrap");
  EXPECT_EQ(std::get<std::string>(parse_value("'wr\\ap'").held), "wr\\ap");
  EXPECT_EQ(std::get<std::string>(parse_value("12 birds").held), "12 birds");
  EXPECT_EQ(std::get<std::string>(parse_value("").held), "");
}

TEST(ParseValue, ReadsListsInLists) {
  const auto list = std::get<Value::List>(parse_value("[0, [1, 2], \"a, ]b\", hawks]").held);
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(std::get<Value::List>(list[1].held).size(), 2u);
  EXPECT_EQ(std::get<std::string>(list[2].held), "a, ]b");
  EXPECT_EQ(std::get<std::string>(list[3].held), "hawks");
  EXPECT_TRUE(std::get<Value::List>(parse_value("[]").held).empty());
}

TEST(NumberText, IsTheShortestThatReadsBack) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(300), "300");
  EXPECT_EQ(number_text(infinity), "inf");
  EXPECT_EQ(number_text(-infinity), "-inf");
  EXPECT_EQ(number_text(std::nan("")), "nan");
}

/// Any value without nan, lists nested a little.
Value random_value(int depth) {
  switch (*rc::gen::inRange(0, depth > 0 ? 4 : 3)) {
    case 0:
      return {*rc::gen::arbitrary<bool>()};
    case 1:
      return {*rc::gen::arbitrary<double>()};
    case 2: {
      const auto codes = *rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 128));
      return {std::string(codes.begin(), codes.end())};
    }
    default: {
      Value::List list;
      for (int n = *rc::gen::inRange(0, 4); n > 0; --n) list.push_back(random_value(depth - 1));
      return {list};
    }
  }
}

RC_GTEST_PROP(ToText, ReadsBackToTheSameValue, ()) {
  const std::string text = to_text(random_value(2));
  RC_ASSERT(to_text(parse_value(text)) == text);
}

RC_GTEST_PROP(ToText, OfAStringReadsBackToTheSameString, ()) {
  const auto codes = *rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 128));
  const std::string string(codes.begin(), codes.end());
  RC_ASSERT(std::get<std::string>(parse_value(to_text(Value{string})).held) == string);
}

RC_GTEST_PROP(ParseValue, NeverFails, ()) {
  const auto text = *rc::gen::container<std::string>(rc::gen::elementOf(std::string("[]\",'\\u0 1.einf-+x")));
  RC_ASSERT(!to_text(parse_value(text)).empty());
}

TEST(NearestWord, FindsSlipsOfAFinger) {
  const std::vector<std::string> known = {"radius", "weight", "edge", "on"};
  EXPECT_EQ(nearest_word("radus", known), "radius");
  EXPECT_EQ(nearest_word("wieght", known), "weight");
  EXPECT_EQ(nearest_word("colour", known), "");
  EXPECT_EQ(nearest_word("", {}), "");
}

}  // namespace
}  // namespace sturnus
