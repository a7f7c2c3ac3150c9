#pragma once

// The folder of a console's pictures where nobody names one. It goes with the console; what a console left that was
// killed goes when the next one is started.
//
//   const PictureFolder own;      // /tmp/pizarra-pictures-PID-XXXXXX

#include <filesystem>
#include <string>

namespace pizarra::programs {

class PictureFolder {
 public:
  explicit PictureFolder(const std::filesystem::path& among = std::filesystem::temp_directory_path());
  PictureFolder(const PictureFolder&) = delete;
  PictureFolder& operator=(const PictureFolder&) = delete;
  ~PictureFolder();
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  bool made_ = false;  // where it is not, nothing can be written there
};

}  // namespace pizarra::programs
