#pragma once

// What a file has: nothing where it cannot be read, or where the process of /proc that it tells of has ended.
//
//   EXPECT_TRUE(whole_file(folder + "up.log").contains("ready"));

#include <string>

namespace pizarra {

std::string whole_file(const std::string& path);

}  // namespace pizarra
