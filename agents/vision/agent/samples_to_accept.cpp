#include "agents/vision/agent/samples_to_accept.hpp"

#include <algorithm>
#include <ranges>

namespace pizarra::vision {
namespace {

// Gives it the name and number that it has now; false where it is not learned any more.
bool follow_sample(SampleToAccept& followed, const Renames& renames, const LearnedObjects& objects) {
  const std::string name = name_now(renames, followed.name);
  for (const LearnedObject& object : objects.all()) {
    for (const LearnedSample& sample : object.samples) {
      const bool same_place = same_name(object.name, name) && sample.number == followed.number;
      if (sample.id != followed.id || (followed.id == 0 && !same_place)) continue;
      followed.name = object.name;
      followed.number = sample.number;
      return true;
    }
  }
  return false;
}

}  // namespace

void SamplesToAccept::add(SampleToAccept sample) {
  std::erase_if(samples_, [&](const SampleToAccept& each) { return each.client == sample.client; });
  if (samples_.size() >= most) samples_.erase(samples_.begin());
  samples_.push_back(std::move(sample));
}

const SampleToAccept* SamplesToAccept::find(const std::string& client, const std::string& name) const {
  const SampleToAccept* newest = nullptr;
  for (const SampleToAccept& each : samples_ | std::views::reverse) {
    if (!same_name(each.name, name)) continue;
    if (each.client == client) return &each;
    if (newest == nullptr) newest = &each;
  }
  return newest;
}

std::vector<std::string> SamplesToAccept::other_judges(const std::string& client, const std::string& name,
                                                       Time now) const {
  std::vector<std::string> out;
  for (const SampleToAccept& each : samples_) {
    if (each.client != client && same_name(each.name, name) && now < each.held_until) out.push_back(each.client);
  }
  return out;
}

void SamplesToAccept::remove(const SampleToAccept& sample) {
  const std::string client = sample.client;
  std::erase_if(samples_, [&](const SampleToAccept& each) { return each.client == client; });
}

void SamplesToAccept::follow(const Renames& renames, const LearnedObjects& objects) {
  std::erase_if(samples_, [&](SampleToAccept& each) { return !follow_sample(each, renames, objects); });
}

std::vector<Datum> SamplesToAccept::facts() const {
  std::vector<Datum> out;
  for (const SampleToAccept& each : samples_) out.push_back(list("to-accept"_sym, each.name, each.number));
  return out;
}

}  // namespace pizarra::vision
