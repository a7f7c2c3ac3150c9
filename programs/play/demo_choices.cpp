#include "programs/play/demo_choices.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <limits>

namespace pizarra::programs {

namespace {

std::unexpected<Failure> bad_option(std::string sentence) { return fail("bad-option", std::move(sentence)); }

Result<void> check_random(const DemoChoices& choices) {
  for (const char* option : {"--seeds", "--first-seed", "--jobs"}) {
    if (!choices.random && choices.has(option)) return bad_option(fmt::format("{} is for --random", option));
  }
  if (!choices.random) return {};
  for (const char* option : {"--goal", "--domain"}) {
    if (!choices.has(option)) continue;
    return bad_option(
        fmt::format("{} cannot be given with --random, which draws a goal over the cell's own domain", option));
  }
  for (const char* option : {"--first-seed", "--jobs"}) {
    if (!choices.many() && choices.has(option)) return bad_option(fmt::format("{} is for --random --seeds N", option));
  }
  if (!choices.many()) return {};
  for (const char* option : {"--seed", "--journal", "--video", "--png", "--realtime"}) {
    if (!choices.has(option)) continue;
    return bad_option(fmt::format("{} is for a single run and cannot be given with --seeds{}", option,
                                  option == std::string("--seed") ? "; the first seed is --first-seed N" : ""));
  }
  if (choices.first_seed > std::numeric_limits<std::uint64_t>::max() - choices.seeds) {
    return bad_option(fmt::format("{} seeds from {} on are more than there are", choices.seeds, choices.first_seed));
  }
  return {};
}

}  // namespace

Result<void> check_choices(const DemoChoices& choices) {
  const std::string film = std::filesystem::path(choices.film).extension().string();
  if (choices.has("--video") && film != ".avi" && film != ".mp4") {
    return bad_option(fmt::format("--video {}: a film is named .avi or .mp4", choices.film));
  }
  if (!choices.picture.empty() && std::filesystem::path(choices.picture).extension() != ".png") {
    return bad_option(fmt::format("--png {}: a picture is named .png", choices.picture));
  }
  if (choices.has("--arm") && choices.arm.empty()) return bad_option("--arm '': an arm has a name, or a file");
  return check_random(choices);
}

}  // namespace pizarra::programs
