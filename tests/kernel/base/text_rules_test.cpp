#include "kernel/base/text_rules.h"

#include <gtest/gtest.h>

#include <string>

namespace relievo {
namespace {

TEST(TextRules, TakesTextOfAllLanguages) {
  for (const char* text : {"", "wolf", "čumák", "狼", "🐺", "\xf4\x8f\xbf\xbf"})
    EXPECT_TRUE(is_plain_utf8(text)) << text;
}

TEST(TextRules, RefusesWhatIsNotUtf8) {
  for (const char* text : {"\xff", "\x80", "\xc3", "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80",
                           "\xf0\x80\x80\xaf", "\xf4\x90\x80\x80", "\xe7\x8b", "a\xc3("})
    EXPECT_FALSE(is_plain_utf8(text)) << text;
}

TEST(TextRules, RefusesControlCharacters) {
  for (const char* text : {"\n", "a\x1b[0m", "\x7f", "\xc2\x85"}) EXPECT_FALSE(is_plain_utf8(text));
  EXPECT_FALSE(is_plain_utf8(std::string_view("a\0b", 3)));
}

TEST(TextRules, IdsHaveALength) {
  EXPECT_FALSE(is_sound_id(""));
  EXPECT_TRUE(is_sound_id(std::string(200, 'x')));
  EXPECT_FALSE(is_sound_id(std::string(201, 'x')));
}

TEST(TextRules, PathsStayInside) {
  for (const char* path : {"a", "a.png", "a/b.png", ".a", "..a/b..", "a b/č.png"})
    EXPECT_TRUE(is_path_inside(path)) << path;
  for (const char* path : {"", "/a", "a/", "a//b", ".", "..", "./a", "../a", "a/..", "a/../b",
                           "a\\b", "..\\a", "C:a", "C:/a", "file:a", "a\nb", "\xff"})
    EXPECT_FALSE(is_path_inside(path)) << path;
}

}  // namespace
}  // namespace relievo
