#include "lisp/outside_text.hpp"

#include <gtest/gtest.h>

#include "lisp/json.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

namespace pizarra {
namespace {

TEST(OutsideText, IsAsItIsWhereItIsText) {
  for (const char* text : {"", "shots/1.jpg", "für.jpg", "点.png", "a\\b", "😀"}) EXPECT_EQ(text_of_bytes(text), text);
}

TEST(OutsideText, BytesThatAreNoTextStandAsEscapes) {
  EXPECT_EQ(text_of_bytes("f\xFCr.jpg"), "f\\xfcr.jpg");
  EXPECT_EQ(text_of_bytes("\xC3"), "\\xc3");
  EXPECT_EQ(text_of_bytes("\xED\xA0\x80!"), "\\xed\\xa0\\x80!") << "a surrogate";
  EXPECT_EQ(text_of_bytes(std::string_view("a\0b", 3)), "a\\x00b");
}

TEST(OutsideText, NothingInItReachesATerminal) {
  EXPECT_EQ(text_of_bytes("\x1b[2J\x1b]0;title\x07"), "\\x1b[2J\\x1b]0;title\\x07");
  EXPECT_EQ(text_of_bytes("a\r\nb\tc\x7F"), "a\\x0d\\nb\\tc\\x7f");
  EXPECT_EQ(text_of_bytes("\xC2\x9B"
                          "31m"),
            "\\xc2\\x9b31m");
  EXPECT_EQ(text_of_bytes("\xE2\x80\xAEgpj.exe"), "\\xe2\\x80\\xaegpj.exe");
  EXPECT_EQ(lines_of_bytes("a\nb\tc\x1b[1m\r"), "a\nb\tc\\x1b[1m\\x0d");
}

TEST(OutsideText, OfAnyBytesIsTextThatADatumHolds) {
  std::uint32_t state = 1;
  for (int i = 0; i < 20000; ++i) {
    std::string bytes;
    for (int j = 0; j < i % 12; ++j) bytes += static_cast<char>((state = state * 1664525 + 1013904223) >> 24);
    for (const std::string& text : {text_of_bytes(bytes), lines_of_bytes(bytes)}) {
      EXPECT_TRUE(is_string_text(text));
      EXPECT_EQ(text.find('\x1b'), text.npos);
    }
    EXPECT_EQ(text_of_bytes(text_of_bytes(bytes)), text_of_bytes(bytes));
    const Datum datum = to_datum(bytes);
    EXPECT_EQ(read_one(write(datum)).value(), datum);
    EXPECT_EQ(datum.text() == bytes, is_string_text(bytes));
  }
}

TEST(OutsideText, AFailureThatNamesAFileCrossesTheBoardAndIsShown) {
  const std::string file = "f\xFCr\x1b[31m.jpg";
  const Failure why{"corrupt-frame", file + " is cut short", to_datum(file), file + ":1:2\n  x\n  ^"};
  const Failure said = failure_from_datum(failure_to_datum(why));
  EXPECT_EQ(said.sentence, "f\\xfcr\\x1b[31m.jpg is cut short");
  EXPECT_EQ(said.subject.text(), "f\\xfcr\\x1b[31m.jpg");
  EXPECT_EQ(said.place, "f\\xfcr\\x1b[31m.jpg:1:2\n  x\n  ^");
  EXPECT_EQ(describe(why), "f\\xfcr\\x1b[31m.jpg is cut short\nf\\xfcr\\x1b[31m.jpg:1:2\n  x\n  ^");
}

TEST(OutsideText, IsJsonToo) {
  EXPECT_EQ(json_string("f\xFCr"), "\"f\\\\xfcr\"");
  EXPECT_EQ(json_string("\x1b[1m\x7F\xC2\x9B"), "\"\\u001b[1m\\u007f\\u009b\"");
  EXPECT_EQ(json_string("für \"es\""), "\"für \\\"es\\\"\"");
}

}  // namespace
}  // namespace pizarra
