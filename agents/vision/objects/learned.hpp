#pragma once

// Learned objects by name, each with one or more samples of its mark. They are kept as durable facts
// (sample_facts.hpp), which a restarted agent reads back. Where a cell says so they are also kept as files
// (object_database.hpp).
//
//   LearnedObjects objects;
//   objects.add("circle", sample);                 // again under the same name: a second sample
//   objects.find("Circle")->samples.size();        // names compare without case

#include <deque>
#include <span>
#include <string>
#include <vector>

#include "agents/vision/marks/mark_measure.hpp"
#include "agents/vision/marks/mark_outline.hpp"
#include "agents/vision/marks/plane_outline.hpp"
#include "agents/vision/marks/tag.hpp"

namespace pizarra::vision {

// Less slim than this a mark counts as round: as high as it is wide from the front. One that is slimmer does not say by
// itself from where it is seen.
inline constexpr double least_round = 0.9;

struct LearnedSample {
  int number = 0;       // NUM, from 1
  std::int64_t id = 0;  // in a database, where no other sample ever gets it; 0: in none
  MarkTone tone = MarkTone::dark;
  std::optional<Tag> tag = {};  // it is known by this alone
  double area_px = 0;
  int perimeter_px = 0;
  int corners = 0;
  std::array<double, 3> moments{};
  double height_px = 0;
  double focal_px = 0;  // of the camera it was learned with: what is in px grows with it; 0: not known
  double contrast = 0;  // print_contrast(); 0: not known
  double slimness = 0;  // from the front where a pair learned it, else as it was seen
  // Where its longer axis lies in `picture`, degrees from right to down, more than 0 and at most 180. 0: not known, or
  // nearly round and of a regular form, as a square: that has none, and what seems to be one is a turned face.
  double axis_deg = 0;
  double roundness = 0;
  double roundness_spread = 0;  // a standard deviation, over the frames it was learned from
  // How its size is known: measured by a pair, or guessed by where objects are said to be while one camera alone learns
  // them; of the face, which no turn changes, or, in what was learned long ago, along y alone.
  enum class SizeBy : std::uint8_t { measured, guessed, measured_face, guessed_face };
  SizeBy size_by = SizeBy::measured;
  // The root of the product of both principal standard deviations in the world, as from the front; or, by `size_by`,
  // the standard deviation along y. 0 when the right image did not show the mark.
  double size_mm = 0;
  MarkTemplate picture{};
  // Of `picture`, and as a blur of so many standard deviations would show it: far away a mark is small, and blur is
  // wide beside it.
  static constexpr std::array<double, 3> blurs = {0, 0.3, 0.5};
  std::array<TurnedSignatures, blurs.size()> signatures;
  // Of `picture`, by the part of a step that it is turned: between samples a corner's point may hide.
  std::array<MarkOutline, TurnedSignatures::parts> outlines;
  PlaneOutline plane = {};  // of `picture`

  bool size_guessed() const { return size_by == SizeBy::guessed || size_by == SizeBy::guessed_face; }
  // The size of its face as it was seen, where that is known: to a pair of cameras a guess is nothing.
  double face_mm() const;
  double measured_face_mm() const { return size_guessed() ? 0 : face_mm(); }
  // Whether its picture says what it looks like from the front: that of a slim one alone does not.
  bool has_form() const { return !is_slim() || axis_deg > 0; }
  bool is_slim() const { return slimness < least_round; }
  // From `picture`, whose second moments are a circle's, to the mark as it is from the front. Areas stay.
  cv::Matx22d stretch() const;
  // The most that it may be: what is known along y alone may have been turned away when it was learned.
  double most_face_mm() const;
  void set_picture(const MarkTemplate& new_picture);
};

// `measured`, `guessed`, `measured-face`, `guessed-face`; and what such a text says, the first where it is none.
std::string_view size_by_of(const LearnedSample& sample);
void set_size_by(LearnedSample& sample, std::string_view text);

// "dark", "light", or its tag's name; and what such a text says.
std::string tone_of(const LearnedSample& sample);
void set_tone(LearnedSample& sample, std::string_view tone);

struct LearnedObject {
  std::string name;
  std::vector<LearnedSample> samples;
  // Of their roundness, between the samples and within each: a standard deviation.
  double roundness_spread = 0;
  // The others, by the least error of a fit between samples of one tone, the likest first: to this one as each of
  // LearnedSample::blurs shows it, however much the other is blurred.
  struct Rival {
    std::size_t index;  // in LearnedObjects::all()
    double error;
  };
  std::array<std::vector<Rival>, LearnedSample::blurs.size()> rivals = {};

  // Of its samples the least; 0 where that of one is not known.
  double contrast() const;
  // The tag that it is found by, where one of its samples is a tag.
  const Tag* tag() const;
};

inline constexpr std::size_t most_objects = 32;
inline constexpr std::size_t most_samples = 8;  // of one object

class LearnedObjects {
 public:
  // In the order in which they were learned; addresses stay.
  const std::deque<LearnedObject>& all() const { return objects_; }
  const LearnedObject* find(std::string_view name) const;
  // The name an object was first learned under, or `name`, and the number its next sample gets. Failures `full`
  // and `bad-name`.
  struct Slot {
    std::string name;
    int number;
  };
  Result<Slot> slot_for(std::string_view name) const;
  // After slot_for() has given the name and `sample.number`.
  void add(const std::string& name, LearnedSample sample);

 private:
  std::deque<LearnedObject> objects_;
};

bool same_name(std::string_view a, std::string_view b);
// Names of objects match [A-Za-z][A-Za-z0-9-]* and have at most 64 characters; failure `bad-name`.
Result<void> check_object_name(std::string_view name);

}  // namespace pizarra::vision
