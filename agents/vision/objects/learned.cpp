#include "agents/vision/objects/learned.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

#include "lisp/plain_name.hpp"

namespace pizarra::vision {
namespace {

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

double spread_of_roundness(const std::vector<LearnedSample>& samples) {
  const auto count = static_cast<double>(samples.size());
  double mean = 0;
  for (const LearnedSample& sample : samples) mean += sample.roundness / count;
  double variance = 0;
  for (const LearnedSample& sample : samples) {
    const double between = sample.roundness - mean;
    variance += (between * between + sample.roundness_spread * sample.roundness_spread) / count;
  }
  return std::sqrt(variance);
}

void note_rival(std::vector<LearnedObject::Rival>& rivals, std::size_t index, double error) {
  auto rival = std::ranges::find(rivals, index, &LearnedObject::Rival::index);
  if (rival == rivals.end()) rival = rivals.insert(rival, {index, error});
  rival->error = std::min(rival->error, error);
  std::ranges::sort(rivals, {}, &LearnedObject::Rival::error);
}

void note_rival(LearnedObject& object, const LearnedSample& sample, std::size_t index, const LearnedSample& other) {
  for (std::size_t i = 0; i < sample.signatures.size(); ++i) {
    double least = 2;
    for (const TurnedSignatures& rival : other.signatures) {
      least = std::min(least, fit_signature(sample.signatures[i].unturned(), rival).error);
    }
    note_rival(object.rivals[i], index, least);
  }
}

// In the order of SizeBy.
constexpr std::array<std::string_view, 4> ways_to_size = {"measured", "guessed", "measured-face", "guessed-face"};

}  // namespace

std::string_view size_by_of(const LearnedSample& sample) {
  return ways_to_size[static_cast<std::size_t>(sample.size_by)];
}

void set_size_by(LearnedSample& sample, std::string_view text) {
  const auto found = std::ranges::find(ways_to_size, text);
  sample.size_by = found == ways_to_size.end() ? LearnedSample::SizeBy::measured
                                               : static_cast<LearnedSample::SizeBy>(found - ways_to_size.begin());
}

// How large it looked says how it lay: its roundness is the same whichever way it does.
double LearnedSample::face_mm() const {
  const bool along_y = size_by == SizeBy::measured || size_by == SizeBy::guessed;
  if (!along_y || tag || area_px <= 0 || height_px <= 0) return size_mm;
  return size_mm * std::sqrt(roundness * area_px / (4 * std::numbers::pi)) / height_px;
}

cv::Matx22d LearnedSample::stretch() const {
  if (axis_deg <= 0) return cv::Matx22d::eye();
  const double axis = axis_deg * std::numbers::pi / 180;
  const cv::Matx22d turn(std::cos(axis), -std::sin(axis), std::sin(axis), std::cos(axis));
  const double longer = 1 / std::sqrt(slimness);
  return turn * cv::Matx22d(longer, 0, 0, 1 / longer) * turn.t();
}

double LearnedSample::most_face_mm() const {
  const bool may_be_turned = size_by == SizeBy::measured && !tag && slimness > 0;
  return may_be_turned ? measured_face_mm() / std::sqrt(slimness) : measured_face_mm();
}

std::string tone_of(const LearnedSample& sample) {
  if (sample.tag) return tag_name(*sample.tag);
  return sample.tone == MarkTone::dark ? "dark" : "light";
}

void set_tone(LearnedSample& sample, std::string_view tone) {
  sample.tone = tone == "light" ? MarkTone::light : MarkTone::dark;
  sample.tag = tag_called(tone);
}

double LearnedObject::contrast() const { return std::ranges::min(samples, {}, &LearnedSample::contrast).contrast; }

const Tag* LearnedObject::tag() const {
  const auto found = std::ranges::find_if(samples, [](const LearnedSample& sample) { return sample.tag.has_value(); });
  return found == samples.end() ? nullptr : &*found->tag;
}

bool same_name(std::string_view a, std::string_view b) {
  const bool as_long = a.size() == b.size();
  return as_long && std::equal(a.begin(), a.end(), b.begin(), [](char x, char y) { return lower(x) == lower(y); });
}

Result<void> check_object_name(std::string_view name) {
  if (is_plain_name(name)) return {};
  return fail("bad-name", "a name is a letter and at most 63 letters, digits and hyphens",
              is_string_text(name) ? to_datum(name) : Datum());
}

void LearnedSample::set_picture(const MarkTemplate& new_picture) {
  picture = new_picture;
  for (std::size_t i = 0; i < blurs.size(); ++i) signatures[i] = turned_signatures_of(picture, blurs[i]);
  std::ranges::transform(signatures.front().by_part, outlines.begin(), outline_of);
  if (tag) return;
  plane = plane_outline(picture);
}

const LearnedObject* LearnedObjects::find(std::string_view name) const {
  const auto found = std::find_if(objects_.begin(), objects_.end(),
                                  [&](const LearnedObject& object) { return same_name(object.name, name); });
  return found == objects_.end() ? nullptr : &*found;
}

Result<LearnedObjects::Slot> LearnedObjects::slot_for(std::string_view name) const {
  const Result<void> named = check_object_name(name);
  if (!named) return fail(named);
  const LearnedObject* known = find(name);
  if (known == nullptr && objects_.size() >= most_objects) {
    return fail("full", "no more than 32 objects can be learned", to_datum(name));
  }
  if (known == nullptr) return Slot{std::string(name), 1};
  if (known->samples.size() >= most_samples) {
    return fail("full", "no more than 8 samples of one object can be learned", to_datum(name));
  }
  return Slot{known->name, known->samples.back().number + 1};
}

void LearnedObjects::add(const std::string& name, LearnedSample sample) {
  auto found = std::ranges::find(objects_, name, &LearnedObject::name);
  if (found == objects_.end()) found = objects_.insert(objects_.end(), LearnedObject{.name = name, .samples = {}});
  const auto index = static_cast<std::size_t>(found - objects_.begin());
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    if (i == index) continue;
    for (const LearnedSample& other : objects_[i].samples) {
      if (other.tone != sample.tone || other.tag || sample.tag) continue;
      note_rival(*found, sample, i, other);
      note_rival(objects_[i], other, index, sample);
    }
  }
  found->samples.push_back(std::move(sample));
  found->roundness_spread = spread_of_roundness(found->samples);
}

}  // namespace pizarra::vision
