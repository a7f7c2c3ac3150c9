// `find`: where something that was learned, or a tag, is in image files.

#include <charconv>
#include <fmt/format.h>

#include "agents/vision/agent/reply_text.hpp"
#include "agents/vision/database/object_database.hpp"
#include "agents/vision/marks/tag_text.hpp"
#include "agents/vision/sight/mark_learner.hpp"
#include "agents/vision/sight/tags_in_view.hpp"
#include "lisp/json.hpp"
#include "lisp/outside_text.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/commands/board_session.hpp"
#include "programs/commands/commands.hpp"
#include "programs/commands/pose_words.hpp"
#include "programs/commands/still_camera.hpp"

namespace pizarra::programs {
namespace {

struct FindChoices {
  std::string name;
  StillChoices stills;
  std::string learned;             // the folder of an object database
  std::vector<std::string> learn;  // IMAGE X Y
  double learned_at_mm = 0;        // 0: not said

  bool is_tag() const { return name.find(':') != std::string::npos; }
};

// Options that would have no effect, or are missing.
Result<void> check_options(const FindChoices& choices) {
  const bool learned = !choices.learned.empty();
  const bool learns = !choices.learn.empty();
  const Result<void> named = choices.is_tag() ? Result<void>() : vision::check_object_name(choices.name);
  if (!named) return named;
  if (choices.is_tag() && (learned || learns)) {
    return fail("needless-option", "a tag is found without --learned and --learn: its number says how it looks");
  }
  if (!choices.is_tag() && learned == learns) {
    return fail("not-learned", fmt::format("say how {} looks: --learned FOLDER, where a cell's eyes keep what they "
                                           "learned, or --learn IMAGE X Y, a point on it; a tag is FAMILY:ID",
                                           choices.name));
  }
  if (!choices.is_tag() && choices.stills.side_mm > 0) return fail("needless-option", "--side is of tags alone");
  if (choices.learned_at_mm > 0 && !learns) return fail("needless-option", "--learned-at goes with --learn alone");
  return {};
}

Result<double> coordinate(const std::string& text) {
  double out = 0;
  const auto [read_to, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  if (error == std::errc() && read_to == text.data() + text.size()) return out;
  return fail("bad-point",
              fmt::format("--learn takes IMAGE X Y, X and Y in px, and {} is no number", text_of_bytes(text)));
}

// As LEARN does, the one image over and over.
Result<vision::LearnedObjects> learn_here(const FindChoices& choices, const StillCamera& camera) {
  const Result<double> x = coordinate(choices.learn[1]);
  const Result<double> y = coordinate(choices.learn[2]);
  if (!x || !y) return fail(x ? y : x);
  const Result<StillImage> image = camera.see(choices.learn[0]);
  if (!image) return fail(image);
  const cv::Point2d click = image->geometry.rectified({*x, *y}, camera::StereoGeometry::Side::left);
  vision::LearnedObjects out;
  vision::MarkLearner learner(choices.name, click, out);
  while (!learner.done()) {
    vision::StereoSight sight = sight_of(*image);
    const Result<void> fed = learner.feed(sight);
    if (!fed) return fail(fed);
  }
  vision::LearnedSample sample = learner.sample();
  sample.number = 1;
  out.add(choices.name, std::move(sample));
  return out;
}

Result<vision::LearnedObjects> learned_before(const FindChoices& choices) {
  Result<vision::ObjectDatabase> database = vision::ObjectDatabase::open_again(choices.learned);
  if (!database) return fail(database);
  Result<vision::KeptObjects> kept = database->read();
  if (!kept) return fail(kept);
  if (kept->objects.find(choices.name) != nullptr) return std::move(kept->objects);
  for (const vision::MemoryTrouble& trouble : kept->damaged) {
    if (vision::same_name(trouble.object, choices.name)) return fail(trouble.why);
  }
  return fail("not-learned", fmt::format("nothing is learned there under the name {}; there are {}", choices.name,
                                         vision::get_reply(kept->objects)));
}

Result<vision::LearnedObjects> objects_for(FindChoices& choices, const StillCamera& camera) {
  if (!choices.is_tag()) return choices.learned.empty() ? learn_here(choices, camera) : learned_before(choices);
  const Result<vision::Tag> tag = vision::tag_from_text(choices.name);
  if (!tag) return fail(tag);
  const vision::LearnedObject object = vision::object_of(*tag, choices.stills.side_mm);
  vision::LearnedObjects out;
  choices.name = object.name;
  out.add(object.name, object.samples.front());
  return out;
}

class Finding {
 public:
  Finding(const FindChoices& choices, const Stills& stills, const vision::LearnedObjects& objects)
      : choices_(choices), stills_(stills), objects_(objects) {}

  int run() const {
    return stills_.each([this](const StillImage& image) { return look_at(image); });
  }

 private:
  int look_at(const StillImage& image) const {
    vision::StereoSight sight = sight_of(image);
    vision::MarkFinder finder(objects_);
    const Result<vision::FoundMark> found = finder.find(sight, *objects_.find(choices_.name), {});
    choices_.stills.json ? tell_json(image, found) : tell(image, found);
    return found ? exit_reached : exit_failed;
  }

  std::string reply(const std::optional<cv::Point2d>& at) const { return vision::find_reply(choices_.name, at); }

  void tell(const StillImage& image, const Result<vision::FoundMark>& found) const {
    if (!found) {
      fmt::print("{}: {} {}: {}\n", image.name, reply({}), found.error().symbol, found.error().sentence);
      return;
    }
    const vision::MarkPose* pose = stills_.pose_of(*found);
    fmt::print("{}: {} confidence {:.3f}{}\n", image.name, reply(image.in_file(found->pair.left.centre)),
               found->confidence, pose != nullptr ? " " + pose_words(*pose) : "");
  }

  void tell_json(const StillImage& image, const Result<vision::FoundMark>& found) const {
    if (!found) {
      fmt::print("{{\"image\":{},\"reply\":{},\"failure\":{}}}\n", json_string(image.name), json_string(reply({})),
                 json_failure(found.error()));
      return;
    }
    const cv::Point2d at = image.in_file(found->pair.left.centre);
    const vision::MarkPose* pose = stills_.pose_of(*found);
    fmt::print("{{\"image\":{},\"reply\":{},\"at\":[{:.2f},{:.2f}],\"confidence\":{:.3f}{}}}\n",
               json_string(image.name), json_string(reply(at)), at.x, at.y, found->confidence,
               pose != nullptr ? "," + pose_json(*pose) : "");
  }

  const FindChoices& choices_;
  const Stills& stills_;
  const vision::LearnedObjects& objects_;
};

int run_find(FindChoices& choices) {
  const repl::Style style = choices.stills.style();
  choices.name = text_of_bytes(choices.name);
  const Result<void> checked = check_options(choices);
  if (!checked) return complain_as(style, checked.error(), exit_usage);
  const Result<Stills> stills = Stills::open(choices.stills, choices.learned_at_mm);
  if (!stills) return complain_as(style, stills.error(), exit_usage);
  const Result<vision::LearnedObjects> objects = objects_for(choices, stills->camera());
  if (!objects) return complain_as(style, objects.error(), exit_usage);
  return Finding(choices, *stills, *objects).run();
}

}  // namespace

void add_find_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<FindChoices>();
  CLI::App* word = app.add_subcommand(
      "find",
      "Find something learned, or a tag, in image files, without a cell: a line an image, with the thesis' reply, how\n"
      "sure it is and, where the camera is known, its place and turn.");
  word->add_option("NAME", choices->name, "What to find: a learned object, or a tag as FAMILY:ID, such as 36h11:17")
      ->required();
  add_image_option(*word, choices->stills);
  word->add_option("--learned", choices->learned,
                   "The folder where a cell's eyes keep what they learned: its (objects \"DIR\")")
      ->check(CLI::ExistingDirectory);
  word->add_option("--learn", choices->learn, "Instead: learn NAME from this image, by a point on it, px")
      ->expected(3)
      ->type_name("IMAGE X Y");
  word->add_option("--learned-at", choices->learned_at_mm, "With --learn: how far away it is there, mm; 500")
      ->check(number_check(50, 100000));
  add_still_options(*word, choices->stills);
  word->add_flag("--json", choices->stills.json, "One JSON object a line");
  word->footer(help_footer("find 36h11:17 shots/ --focal 560 --side 40",
                           "Exit status: 0 found in every image; 1 not found in one; 2 a wrong word or option, or "
                           "nothing learned;\n4 an image cannot be read (the others are looked at all the same)."));
  word->callback([choices, &status] { status = run_find(*choices); });
}

}  // namespace pizarra::programs
