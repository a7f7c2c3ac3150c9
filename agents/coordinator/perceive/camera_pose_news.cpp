#include "agents/coordinator/perceive/camera_pose_news.hpp"

#include <fmt/format.h>

#include "agents/coordinator/retried_commit.hpp"
#include "lisp/numbers.hpp"

namespace pizarra::coordinator {

namespace {

using News = CameraWatch::News;

std::vector<Datum> numbers_of(const forms::CameraPose& pose) {
  std::vector<Datum> out;
  for (const double mm : pose.at_mm) out.push_back(to_datum(rounded(mm, 100)));
  for (const double deg : {pose.pan_deg, pose.tilt_deg, pose.roll_deg}) {
    out.push_back(to_datum(rounded(deg, 1000)));
  }
  return out;
}

std::string state_of(const CameraWatch& camera) {
  if (camera.unknown()) return "unknown";
  return camera.doubtful() ? "doubtful" : camera.known() ? "measured" : "guessed";
}

std::string sentence_of(const CameraWatch& camera, News news) {
  if (news == News::found) return "the gripper's mark shows where the camera stands";
  if (news == News::corrected) {
    return fmt::format(
        "the gripper's mark shows where the camera stands: things are placed {:.1f} mm from where they were",
        camera.shift_mm());
  }
  if (news == News::moved) {
    return fmt::format("the camera was moved: things are placed {:.1f} mm from where they were", camera.shift_mm());
  }
  return "the gripper's mark is not seen where the arm says it is: the camera may have been moved";
}

}  // namespace

Task<std::optional<CameraMeasured>> CameraPoseNews::told_before() {
  const Datum any = "?"_sym;
  const Datum pattern =
      list("camera-pose"_sym, any, any, any, any, any, any, any, any, Datum::list(numbers_of(guess_)));
  const std::vector<Fact> told = co_await facts_now(context_.board, context_.executor, pattern);
  if (told.empty()) co_return std::nullopt;
  const Datum& fact = told.back().datum;
  if (fact[7].is_symbol("guessed") || fact[7].is_symbol("unknown")) co_return std::nullopt;
  told_ = fact[7].text();
  const forms::CameraPose pose{.at_mm = {fact[1].number(), fact[2].number(), fact[3].number()},
                               .pan_deg = fact[4].number(),
                               .tilt_deg = fact[5].number(),
                               .roll_deg = fact[6].number()};
  co_return CameraMeasured{pose, fact[7].is_symbol("doubtful")};
}

Task<void> CameraPoseNews::tell(const CameraWatch& camera, News news) {
  const std::string state = state_of(camera);
  // The pose of the cell file is known to all; that it has none is told.
  if (told_.empty() && !camera.unknown()) told_ = state;
  if (news == News::nothing && told_ == state) co_return;
  std::vector<Datum> fact = numbers_of(camera.pose());
  fact.insert(fact.begin(), "camera-pose"_sym);
  fact.push_back(Datum::symbol(state));
  fact.push_back(to_datum(rounded(camera.spread_mm(), 100)));
  fact.push_back(Datum::list(numbers_of(guess_)));
  const Datum pose = Datum::list(std::move(fact));
  Transaction transaction;
  transaction.tell(pose);
  if (news != News::nothing) story_.add(transaction, "agent", sentence_of(camera, news), pose);
  const Result<Revision> told = co_await commit(context_.board, context_.executor, std::move(transaction));
  // A state that the board could not keep is told again with the next look that tells something.
  if (told) told_ = state;
}

}  // namespace pizarra::coordinator
