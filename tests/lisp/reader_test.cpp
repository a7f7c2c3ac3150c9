#include "lisp/reader.hpp"

#include <cstdio>
#include <ctime>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>

#include "lisp/characters.hpp"
#include "lisp/writer.hpp"
#include "tests/scratch.hpp"

namespace pizarra {
namespace {

std::string refusal(std::string_view text, const ReadLimits& limits = {}) {
  const auto read = read_one(text, limits);
  return read ? "read " + write(*read) : read.error().symbol;
}

TEST(ReaderTest, ReadsEveryKind) {
  EXPECT_EQ(read_one("(a \"b\\n\\\"\" -3 +4 0.5 1e3 () ->x - + ?) ; end").value(),
            list("a"_sym, "b\n\"", -3, 4, 0.5, 1000.0, list(), "->x"_sym, "-"_sym, "+"_sym, "?"_sym));
  EXPECT_EQ(read_one(" ; first\n <ob1>\t").value(), "<ob1>"_sym);
  EXPECT_EQ(read_one("-9223372036854775808").value(), to_datum(INT64_MIN));
  EXPECT_EQ(read_one("\"señal\"").value(), to_datum("señal"));
}

TEST(ReaderTest, ReadsSeveralDataOneAfterAnother) {
  EXPECT_EQ(read_all("(on a b)(on b c) ; and\n7").value(),
            (std::vector<Datum>{list("on"_sym, "a"_sym, "b"_sym), list("on"_sym, "b"_sym, "c"_sym), to_datum(7)}));
  EXPECT_EQ(read_all(" ; only").error().symbol, "nothing-to-read");
  EXPECT_EQ(read_all("(on a b) (on").error().symbol, "unclosed-list");
}

TEST(ReaderTest, RefusesWhatItDoesNotKnowExactly) {
  EXPECT_EQ(refusal("(a"), "unclosed-list");
  EXPECT_EQ(refusal("\"a"), "unclosed-string");
  EXPECT_EQ(refusal("\"a\\\""), "unclosed-string");
  EXPECT_EQ(refusal("a)"), "unexpected-close");
  EXPECT_EQ(refusal(""), "nothing-to-read");
  EXPECT_EQ(refusal("; only"), "nothing-to-read");
  EXPECT_EQ(refusal("a b"), "more-than-one");
  EXPECT_EQ(refusal("9223372036854775808"), "bad-number");
  for (const char* text : {"1.", ".5", "-.5", "1e", "12abc", "1e999", "1e-999", "0x10", "1_000", "1-2"}) {
    EXPECT_EQ(refusal(text), "bad-number") << text;
  }
  EXPECT_EQ(refusal("\"\\q\""), "bad-escape");
  for (const char* text : {"'a", "`a", ",a", "#t", "#(1)", "[a]", "{a}", "|a|", "(a . b)", "a\\b", "(1, 2)", "é"}) {
    EXPECT_EQ(refusal(text), "bad-character") << text;
  }
  EXPECT_EQ(refusal(std::string_view("(a\0b)", 5)), "bad-character");
  EXPECT_EQ(refusal(std::string_view("\"a\0b\"", 5)), "bad-text");
  for (const char* text : {"\"\xC3(\"", "\"\xC0\xAF\"", "\"\xED\xA0\x80\"", "\"\xF4\x90\x80\x80\"", "\xFF", ";\xFF"}) {
    EXPECT_EQ(refusal(text), "bad-text") << text;
  }
}

// The sentence of an error in a text, with its place.
std::string complaint(std::string_view text) {
  const Failure refused = read_source(text, "d").error();
  return fmt::format("{} at {}", refused.sentence, refused.place.substr(0, refused.place.find('\n')));
}

TEST(ReaderTest, PointsAtTheListThatByTheIndentationLacksItsEnd) {
  const std::string by_indentation = "a list is not closed; by the indentation it is this one at ";
  EXPECT_EQ(complaint("(domain d\n  (types A\n  (predicates (p)))"), by_indentation + "d:2:3");
  EXPECT_EQ(complaint("(a\n  (b \"(\\\"\") ; (\n\t (c (d)\n  (e))\n(f)"), by_indentation + "d:3:3");
  EXPECT_EQ(complaint("(a\n  (b)\n"), "this list is not closed at d:1:1");
  EXPECT_TRUE(read_source("(a\n(b)\n(c))", "d"));
}

TEST(ReaderTest, PointsAtTheParenthesisThatByTheIndentationIsTooMany) {
  const std::string by_indentation = "there is a parenthesis too many; by the indentation it is this one at ";
  EXPECT_EQ(complaint("(domain d\n  (types A))\n  (predicates (p)))"), by_indentation + "d:2:12");
  EXPECT_EQ(complaint("(a)\n(b\n  \")\" ; )\n  (c)))\n"), "nothing is open that this could close at d:4:7");
  EXPECT_TRUE(read_source("(a)\n  (b)", "d"));
}

TEST(ReaderTest, KeepsItsLimits) {
  EXPECT_EQ(refusal("((()))", {.depth = 3}), "read ((()))");
  EXPECT_EQ(refusal("(((())))", {.depth = 3}), "too-deep");
  EXPECT_EQ(refusal("(a b c)", {.elements = 4}), "read (a b c)");
  EXPECT_EQ(refusal("(a b c d)", {.elements = 4}), "too-many");
  EXPECT_EQ(refusal("(a b)", {.bytes = 5}), "read (a b)");
  EXPECT_EQ(refusal("(a b )", {.bytes = 5}), "too-long");
  EXPECT_EQ(refusal(std::string(1'000'000, '(')), "too-deep");
}

TEST(ReaderTest, ReadsCommasAsSymbolsWhereAsked) {
  const ReadLimits with_commas{.commas = true};
  for (const char* text : {"(112, 87.5)", "(112 ,87.5)", "(112,87.5)"}) {
    const auto read = read_one(text, with_commas);
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, list(112, Datum::symbol(","), 87.5));
  }
}

TEST(ReaderTest, FailuresShowLineColumnAndCaret) {
  const auto read = read_one("(on circle\n\tñ\"é\" 'x)", {}, "goal");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().place, "goal:2:2\n   ñ\"é\" 'x)\n   ^");
  const auto quote = read_one("(on circle\n \"é\" 'x)", {}, "goal");
  EXPECT_EQ(quote.error().place, "goal:2:6\n   \"é\" 'x)\n       ^");
}

TEST(ReaderTest, ALongLineIsShownAroundTheCaret) {
  const auto read = read_one("(" + std::string(5000, 'a') + " ' " + std::string(5000, 'b') + ")");
  ASSERT_FALSE(read);
  EXPECT_TRUE(read.error().place.starts_with("input:1:5003\n"));
  EXPECT_LT(read.error().place.size(), 250u);
}

TEST(ReaderTest, ALineIsShownWholeWhereItIsNotLongAndIsSeenToBeCutElsewhere) {
  const std::string line = "(at-least two (?x OBJECT) (on-table ?x))";
  EXPECT_EQ(place_of("f", line, 0), "f:1:1\n  " + line + "\n  ^");
  const std::string longer = line + " " + line + " " + line;
  EXPECT_EQ(place_of("f", longer, 0), "f:1:1\n  " + longer.substr(0, 110) + " ...\n  ^");
  EXPECT_EQ(place_of("f", longer, 82), "f:1:83\n  ... " + longer.substr(12) + "\n  " + std::string(74, ' ') + "^");
}

TEST(ReaderTest, TellsAPlaceAsSoonWhereTheWholeFileIsOneLongLine) {
  const auto cpu_of_places = [](std::size_t length) {
    const std::string text(length, 'x');
    const std::clock_t begin = std::clock();
    for (std::size_t offset = 0; offset < 300; ++offset) {
      EXPECT_TRUE(place_of("f", text, offset).starts_with("f:1:"));
    }
    return std::clock() - begin;
  };
  const std::clock_t brief = cpu_of_places(1000);
  EXPECT_LT(cpu_of_places(4'000'000), 20 * brief + CLOCKS_PER_SEC / 50);
}

TEST(SourceTest, FindsThePlaceOfAnElement) {
  const Source source = read_source("(a)\n(b (c dd) ; note\n   e)", "file.scm").value();
  EXPECT_EQ(source.data().size(), 2u);
  const Failure failure = source.failure_at({1, 1, 1}, "odd", "dd is odd", {"in b"});
  EXPECT_EQ(failure.place, "file.scm:2:7\n  (b (c dd) ; note\n        ^\n  in b");
  EXPECT_EQ(failure.subject, "dd"_sym);
  EXPECT_TRUE(source.failure_at({1, 2}, "odd", "e").place.starts_with("file.scm:3:4\n"));
  EXPECT_TRUE(source.failure_at({1, 1, 7}, "odd", "").place.starts_with("file.scm:2:4\n"));
  EXPECT_TRUE(source.failure_at({}, "odd", "").place.starts_with("file.scm:1:1\n"));
  EXPECT_TRUE(source.failure_at({1, 1, 2}, "odd", "").place.starts_with("file.scm:2:9\n")) << "where it is closed";
  EXPECT_TRUE(source.failure_at({2}, "odd", "").place.starts_with("file.scm:3:6\n")) << "behind the text";
  EXPECT_EQ(source.failure_at({2}, "odd", "").subject, Datum());
}

TEST(SourceTest, ReadsFilesAsEditorsOnOtherSystemsLeaveThem) {
  const std::string path = scratch_folder() + "pizarra_source_marks.scm";
  std::ofstream(path) << "\xEF\xBB\xBF(a b)\r\n; c\r\n(d)\r\n";
  const Result<Source> source = read_source_file(path);
  ASSERT_TRUE(source) << describe(source.error());
  EXPECT_EQ(source->data().size(), 2u);
  EXPECT_TRUE(source->failure_at({0, 1}, "odd", "").place.ends_with(":1:4\n  (a b)\n     ^"))
      << "the mark has no column";
  std::remove(path.c_str());
}

TEST(SourceTest, RefusesInOneSentenceFilesThatAreNoText) {
  const std::string path = scratch_folder() + "pizarra_source_binary";
  for (const std::string_view bytes : {std::string_view("\x7F"
                                                        "ELF\x02\x01\0\0",
                                                        8),
                                       std::string_view("(\0a\0)\0", 6)}) {
    std::ofstream(path) << bytes;
    const Result<Source> source = read_source_file(path);
    ASSERT_FALSE(source);
    EXPECT_EQ(describe(source.error()), "the file " + path + " is not text");
  }
  std::remove(path.c_str());
}

TEST(SourceTest, ReadsFilesWithinLimits) {
  const std::string path = scratch_folder() + "pizarra_source_test.scm";
  std::ofstream(path) << "(a b) (c)";
  EXPECT_EQ(read_source_file(path).value().data().size(), 2u);
  EXPECT_EQ(read_source_file(path, {.bytes = 3}).error().symbol, "too-long");
  EXPECT_EQ(read_source_file(scratch_folder()).error().symbol, "unreadable-file");
  EXPECT_EQ(read_source_file(scratch_folder()).error().sentence,
            fmt::format("{} is a folder, and a file must be named", scratch_folder()));
  EXPECT_EQ(read_source_file("/nowhere/at-all.scm").error().symbol, "unreadable-file");
  std::remove(path.c_str());
}

}  // namespace
}  // namespace pizarra
