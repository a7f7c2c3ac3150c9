#pragma once

// The page as it comes with the program: what page/build.mjs made of page/'s sources, read once.
//
//   const Result<PageFiles> page = PageFiles::read(folder);
//   const PageFile* file = page->find("/");          // nothing where there is no such file
//   page->version()                                  // by which a page that was loaded before knows that it is another

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
  const std::string& version() const { return version_; }

 private:
  std::string version_;
  std::map<std::string, PageFile, std::less<>> files_;
};

}  // namespace pizarra::console
