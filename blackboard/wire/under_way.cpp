#include "blackboard/wire/under_way.hpp"

namespace pizarra::wire {

struct UnderWay::Counted {
  std::shared_ptr<Count> count;
  std::string text;
};

zmq::message_t UnderWay::message(const std::string& peer, std::string_view frame) {
  if (frame.size() <= short_message) return zmq::message_t(frame.data(), frame.size());
  auto counted = std::make_unique<Counted>(count_of(peer), std::string(frame));
  *counted->count += frame.size();
  char* const text = counted->text.data();
  return {text, frame.size(), gone, counted.release()};
}

std::size_t UnderWay::bytes_to(const std::string& peer) const {
  const auto found = counts_.find(peer);
  return found == counts_.end() ? 0 : found->second->load();
}

void UnderWay::gone(void*, void* counted) {
  const std::unique_ptr<Counted> own(static_cast<Counted*>(counted));
  *own->count -= own->text.size();
}

// Only who has something under way is known, so that those who left are forgotten.
std::shared_ptr<UnderWay::Count>& UnderWay::count_of(const std::string& peer) {
  const auto found = counts_.find(peer);
  if (found != counts_.end()) return found->second;
  std::erase_if(counts_, [](const auto& entry) { return entry.second->load() == 0; });
  return counts_.emplace(peer, std::make_shared<Count>(0)).first->second;
}

}  // namespace pizarra::wire
