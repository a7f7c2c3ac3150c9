#pragma once

// The page as it comes with the program: what page/build.mjs made of page/'s sources, read once.
//
//   const Result<PageFiles> page = PageFiles::read(folder);
//   const PageFile* file = page->find("/");          // nothing where there is no such file

#include <map>
#include <string>
#include <string_view>

#include "lisp/result.hpp"

namespace pizarra::console {

struct PageFile {
  std::string type;
  std::string text;
};

class PageFiles {
 public:
  // Failure: unreadable-file.
  static Result<PageFiles> read(const std::string& folder);
  const PageFile* find(std::string_view path) const;

 private:
  std::map<std::string, PageFile, std::less<>> files_;
};

}  // namespace pizarra::console
