#include "agents/vision/agent/tag_teller.hpp"

#include "agents/vision/agent/reply_text.hpp"

namespace pizarra::vision {
namespace {

// In virtual time; what a pair of 640 x 480 takes.
constexpr Duration reading_cost = 20ms;

// A look at one frame, which may outlive whoever began it.
struct TagReading {
  camera::StereoFrame frame;
  camera::StereoModel model;
  TagsInView tags;
  std::vector<FoundMark> seen = {};

  void read() { seen = tags.at(StereoSight(frame, model)); }
};

}  // namespace

void TagTeller::look_at(const camera::StereoFrame& frame, const camera::StereoModel& model) {
  if (!tags_.empty() && reading_.done()) reading_ = executor_.spawn(read(frame, model));
}

Task<void> TagTeller::read(camera::StereoFrame frame, camera::StereoModel model) {
  const auto look = std::make_shared<TagReading>(std::move(frame), model, tags_);
  std::function<void(const std::function<bool()>&)> read = [look](const std::function<bool()>& cancelled) {
    if (!cancelled()) look->read();
  };
  co_await executor_.offload(std::move(read), reading_cost);
  co_await tell(look->frame.number, look->frame.captured, std::move(look->seen));
}

Task<void> TagTeller::tell_none(std::uint64_t frame, Time captured) {
  const std::vector<FoundMark> none;
  if (!tags_.empty()) co_await tell(frame, captured, none);
}

Task<void> TagTeller::tell(std::uint64_t frame, Time captured, std::vector<FoundMark> seen) {
  if (std::exchange(beginning_, facts_.beginnings()) != facts_.beginnings()) told_none_ = false;
  if (seen.empty() && told_none_) co_return;
  told_none_ = seen.empty();
  std::vector<Datum> facts;
  facts.push_back(tags_fact(frame, captured, seen));
  co_await facts_.tell(std::move(facts));
}

Task<void> TagTeller::unsay() {
  told_none_ = false;
  Transaction transaction;
  facts_.retract_all(transaction, "tags-seen"_sym, 3);
  co_await facts_.transact(std::move(transaction));
}

}  // namespace pizarra::vision
