#include "host/console/notes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>

namespace host {
namespace {

std::string notesOf(const std::vector<std::string>& warnings) {
  std::ostringstream out;
  writeNotes(out, warnings);
  return out.str();
}

TEST(Notes, AreALineEach) {
  EXPECT_EQ(notesOf({}), "");
  EXPECT_EQ(notesOf({"First.", "A\nname."}), "mres: note: First.\nmres: note: A name.\n");
}

TEST(Sentences, BeginWithACapitalAndEndWithAStop) {
  EXPECT_EQ(asSentence("can't load 'a.glb'"), "Can't load 'a.glb'.");
  EXPECT_EQ(asSentence("Did you mean hall?"), "Did you mean hall?");
  EXPECT_EQ(asSentence("0:1: syntax error\n0:2: another"), "0:1: syntax error.");
  EXPECT_EQ(asSentence(""), "");
}

TEST(Notes, AreFew) {
  const std::vector<std::string> warnings(9, "Lost.");
  const std::string notes = notesOf(warnings);
  EXPECT_EQ(std::ranges::count(notes, '\n'), 4);
  EXPECT_THAT(notes, testing::EndsWith("mres: note: And 6 more; --json reports all.\n"));
  EXPECT_EQ(std::ranges::count(notesOf({"1", "2", "3", "4"}), '\n'), 4);
}

}  // namespace
}  // namespace host
