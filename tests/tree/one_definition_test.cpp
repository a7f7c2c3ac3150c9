#include <gtest/gtest.h>
#include <map>
#include <regex>

#include "tests/tree/tree.hpp"

namespace pizarra {
namespace {

// What a brace opens: a namespace with its name, an anonymous one, or anything else.
struct Scope {
  enum class Kind { named, anonymous, other } kind = Kind::other;
  std::string name;
};

// Types by their full names, as `pizarra::store::Commit`, that other files could name too: none in a function, in
// another type or in an anonymous namespace.
std::vector<std::string> types_defined_in(const std::string& text) {
  static const std::regex head(R"re((namespace)\s*([\w:]*)\s*\{|)re"
                               R"re(\b(?:class|struct|union|enum(?:\s+class)?)\s+(?:\[\[\w+\]\]\s*)?([\w:]+))re"
                               R"re((?:\s+final)?\s*(?::[^;{}()=]*)?\{|[{}])re");
  const std::string code = without_comments_and_literals(text);
  std::vector<Scope> open;
  std::vector<std::string> types;
  for (std::sregex_iterator it(code.begin(), code.end(), head), end; it != end; ++it) {
    const std::smatch& found = *it;
    if (found[0] == "}") {
      if (!open.empty()) open.pop_back();
      continue;
    }
    if (found[3].matched) {
      std::string name;
      bool shared = true;
      for (const Scope& scope : open) {
        shared = shared && scope.kind == Scope::Kind::named;
        name += scope.name + "::";
      }
      if (shared) types.push_back(name + found[3].str());
    }
    if (!found[1].matched) {
      open.push_back({});
      continue;
    }
    const bool named = found[2].length() > 0;
    open.push_back({named ? Scope::Kind::named : Scope::Kind::anonymous, found[2]});
  }
  return types;
}

TEST(OneDefinition, TheReaderOfTypesSeesThoseThatOtherFilesCouldNameAlone) {
  const std::vector<std::string> types = types_defined_in(
      "namespace a::b {\nstruct One { struct Inner { int i; }; };\nclass Two;\nnamespace { struct Hidden {}; }\n"
      "enum class Three : int { x };\nvoid f() { struct Local {}; }\ntemplate <class T> class Four final : One {};\n}\n"
      "struct Five {};");
  EXPECT_EQ(types, (std::vector<std::string>{"a::b::One", "a::b::Three", "a::b::Four", "Five"}));
}

// Two types of one name are undefined behaviour that no compiler sees; ./pizarra test --odr compares their layouts.
TEST(OneDefinition, NoTypeIsDefinedInTwoFiles) {
  std::map<std::string, std::string> defined;
  for (const SourceFile& file : sources_below({"lisp", "blackboard", "drivers", "agents", "programs", "tests"})) {
    for (const std::string& type : types_defined_in(file.text)) {
      const auto [known, fresh] = defined.emplace(type, file.path);
      EXPECT_TRUE(fresh || known->second == file.path)
          << type << " is defined in " << known->second << " and in " << file.path;
    }
  }
  EXPECT_GT(defined.size(), 500u);
}

}  // namespace
}  // namespace pizarra
