#include "agents/console/page_files.hpp"

#include "lisp/reader.hpp"

namespace pizarra::console {

namespace {

struct ServedFile {
  const char* path;
  const char* file;
  const char* type;
};

// Nothing else in the folder is served.
constexpr ServedFile served[] = {{"/", "index.html", "text/html; charset=utf-8"},
                                 {"/console.css", "console.css", "text/css; charset=utf-8"},
                                 {"/console.js", "console.js", "text/javascript; charset=utf-8"},
                                 {"/icon.svg", "icon.svg", "image/svg+xml"}};

constexpr ReadLimits page_limits{.bytes = 4 << 20};
constexpr ReadLimits version_limits{.bytes = 64};

}  // namespace

Result<PageFiles> PageFiles::read(const std::string& folder) {
  PageFiles page;
  const Result<std::string> version = read_text_file(folder + "/version", version_limits);
  if (!version) return fail(version);
  page.version_ = version->substr(0, version->find('\n'));
  for (const ServedFile& file : served) {
    Result<std::string> text = read_text_file(folder + "/" + file.file, page_limits);
    if (!text) return fail(text);
    page.files_.emplace(file.path, PageFile{file.type, std::move(*text)});
  }
  return page;
}

const PageFile* PageFiles::find(std::string_view path) const {
  const auto found = files_.find(path);
  return found == files_.end() ? nullptr : &found->second;
}

}  // namespace pizarra::console
