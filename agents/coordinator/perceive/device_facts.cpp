#include "agents/coordinator/perceive/device_facts.hpp"

#include "agents/runtime/follow.hpp"

namespace pizarra::coordinator {

namespace {

// (RELATION FIRST ? ...), of as many arguments.
Datum pattern_of(Datum relation, Datum first, std::size_t arguments) {
  std::vector<Datum> items(arguments + 1, "?"_sym);
  items[0] = std::move(relation);
  items[1] = std::move(first);
  return Datum::list(std::move(items));
}

const Datum* newest(const Change& change) {
  return change.added.empty() ? nullptr : &change.added.back().facts.front().datum;
}

}  // namespace

Job DeviceFacts::followed(Datum pattern, Take take) {
  const auto handler = [this, take](Change change) { return hand_on(take, std::move(change)); };
  return context_.executor.spawn(runtime::follow(context_, std::move(pattern), handler));
}

Task<void> DeviceFacts::hand_on(Take take, Change change) {
  (this->*take)(change);
  co_return;
}

void DeviceFacts::start() {
  if (options_.head) head_ = followed(pattern_of("head"_sym, "?"_sym, 3), &DeviceFacts::take_head);
}

void DeviceFacts::follow_camera(const std::string& eyes) {
  camera_ = Job();
  scene_.forget_camera();
  camera_ = followed(pattern_of("camera-model"_sym, Datum::symbol(eyes), 7), &DeviceFacts::take_model);
}

void DeviceFacts::follow_robot(const std::string& robot) {
  const Datum name = Datum::symbol(robot);
  robot_.clear();
  robot_.push_back(followed(pattern_of("gripper"_sym, name, 2), &DeviceFacts::take_gripper));
  robot_.push_back(followed(pattern_of("arm-pose"_sym, name, 7), &DeviceFacts::take_pose));
  robot_.push_back(followed(pattern_of("arm-foot"_sym, name, 3), &DeviceFacts::take_foot));
  robot_.push_back(followed(pattern_of("arm"_sym, name, 3), &DeviceFacts::take_arm));
}

void DeviceFacts::take_model(const Change& change) {
  const Datum* fact = newest(change);
  if (fact == nullptr) return;
  const Result<CameraModel> model = camera_model_from_fact(*fact);
  if (model) scene_.take_camera(*model);
}

void DeviceFacts::take_head(const Change& change) {
  const Datum* head = newest(change);
  const bool stands = head != nullptr && (*head)[3].is_symbol("still");
  std::optional<HeadTurn> turn;
  if (stands) turn = HeadTurn{(*head)[1].number(), (*head)[2].number()};
  scene_.take_head(turn);
}

void DeviceFacts::take_gripper(const Change& change) {
  if (const Datum* gripper = newest(change)) scene_.take_opening((*gripper)[2].number());
}

void DeviceFacts::take_pose(const Change& change) {
  const Datum* told = newest(change);
  if (told == nullptr) return;
  const Datum& pose = *told;
  const Eigen::Vector3d at(pose[2].number(), pose[3].number(), pose[4].number());
  scene_.take_pose(tool_pose(at, pose[5].number(), pose[6].number(), pose[7].number()));
}

void DeviceFacts::take_foot(const Change& change) {
  if (const Datum* foot = newest(change)) scene_.take_foot({(*foot)[2].number(), (*foot)[3].number(), 0});
}

void DeviceFacts::take_arm(const Change& change) {
  const Datum* arm = newest(change);
  // Of an agent that died nobody knows whether its arm still moves.
  const bool rests = arm != nullptr && !(*arm)[2].is_symbol("moving");
  rests_since_.reset();
  if (rests) rests_since_ = change.added.back().facts.front().when;
  scene_.take_arm(rests);
}

}  // namespace pizarra::coordinator
