// `calibrate`: what a pair of cameras is, or one, from images of a chessboard.

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fmt/format.h>

#include "agents/vision/marks/tag_text.hpp"
#include "drivers/camera/chessboard.hpp"
#include "lisp/forms/cell_file.hpp"
#include "lisp/outside_text.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/command_line/key_option.hpp"
#include "programs/commands/board_pairs.hpp"
#include "programs/commands/board_session.hpp"
#include "programs/commands/board_views.hpp"
#include "programs/commands/calibrate_report.hpp"
#include "programs/commands/calibration_news.hpp"
#include "programs/commands/commands.hpp"
#include "programs/story/output_file.hpp"

namespace pizarra::programs {
namespace {

// How far a corner must have moved to be looked at again, of the image's width: by a person's choice, two pictures of
// the same place count once; of what a camera sees, much is alike.
constexpr double least_motion_chosen = 0.01;
constexpr double least_motion_seen = 0.04;
constexpr std::chrono::seconds longest_untold{2};

struct BoardTagChoices {
  std::string family = "4x4-50";
  double side_mm = 18;
};

struct CalibrateChoices {
  std::vector<std::string> images;
  std::string cell;
  std::string out;  // empty: pair.calibration, of one camera camera.calibration
  camera::CalibrationBoard board;
  bool charuco = false;
  BoardTagChoices tags;
  std::size_t pairs = 20;
  bool json = false;
  bool tell = false;  // a board how it goes:
  BoardChoices board_to_tell;
};

volatile std::sig_atomic_t interrupted = 0;
void on_interrupt(int) { interrupted = 1; }

// While it lives the first Ctrl-C is noted. A second one ends the program: a camera may never answer.
class NotedInterrupt {
 public:
  NotedInterrupt() {
    struct sigaction action {};
    action.sa_handler = on_interrupt;
    action.sa_flags = SA_RESETHAND;
    sigaction(SIGINT, &action, &before_);
  }
  NotedInterrupt(const NotedInterrupt&) = delete;
  NotedInterrupt& operator=(const NotedInterrupt&) = delete;
  ~NotedInterrupt() { sigaction(SIGINT, &before_, nullptr); }

 private:
  struct sigaction before_ {};
};

class Calibration {
 public:
  // `news`: where it is told how it goes; null: nowhere.
  Calibration(const CalibrateChoices& choices, BoardPairs& pairs, CalibrationNews* news)
      : choices_(choices),
        pairs_(pairs),
        news_(news),
        views_(choices.board, pairs.chosen() ? least_motion_chosen : least_motion_seen),
        report_(choices.json, pairs.single()) {}

  int run() {
    if (pairs_.left_out() > 0) report_.without_partner(pairs_.left_out());
    const Result<void> gathered = gather();
    if (!gathered) return refuse(gathered.error(), exit_unavailable);
    tell_other_sizes();
    const BoardViews::OneSize& seen = views_.of_most();
    const auto calibrate = pairs_.single() ? camera::calibrate_single : camera::calibrate_pair;
    const Result<camera::CalibratedPair> found =
        calibrate(seen.views, seen.size, choices_.board, [this](const std::string& step) {
          report_.step(step);
          tell_news("fitting", step);
        });
    if (!found) return refuse(found.error(), interrupted != 0 ? exit_interrupted : exit_failed);
    const std::string text = camera::write_calibration(found->calibration);
    const Result<camera::StereoCalibration> usable = camera::read_calibration(text, out());
    if (!usable) return refuse(unusable(usable.error()), exit_failed);
    const Result<void> written =
        story::write_file(out(), {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    if (!written) return refuse(written.error(), exit_unavailable);
    report_.result(out(), *found);
    tell_news("done", fmt::format("{} written; reprojection error {:.2f} px", text_of_bytes(out()),
                                  found->calibration.reprojection_px));
    return exit_reached;
  }

 private:
  repl::Style style() const { return choices_.json ? repl::Style::json : repl::Style::text; }
  std::string out() const {
    if (!choices_.out.empty()) return choices_.out;
    return pairs_.single() ? "camera.calibration" : "pair.calibration";
  }

  int refuse(const Failure& why, ExitCode code) {
    tell_news("failed", why.sentence);
    return complain_as(style(), why, code);
  }

  // All that a person chose; of what cameras see as much as was asked for, or as came until Ctrl-C.
  Result<void> gather() {
    if (pairs_.chosen()) return gather_until([] { return false; });
    const NotedInterrupt noted;
    const Result<void> gathered = gather_until([this] { return count() >= choices_.pairs || interrupted != 0; });
    if (untold_) report_.pair(untold_->name, untold_->taken, {});
    return gathered;
  }

  Result<void> gather_until(const auto& enough) {
    while (!enough()) {
      const Result<ImagePair> pair = pairs_.next();
      const std::string symbol = pair ? "" : pair.error().symbol;
      if (symbol == "ended") break;
      if (!pair && symbol != "corrupt-frame") return fail(pair);
      const Result<void> taken = pair ? views_.take(*pair, pairs_.name()) : Result<void>(fail(pair));
      tell(taken);
      seen_ = taken ? "taken" : taken.error().sentence;
      if (taken) note_view();
      tell_news("looking", {});
    }
    return {};
  }

  // Boards in the middle alone leave open what the lens does to the corners.
  static Failure unusable(const Failure& why) {
    return {"uncertain",
            why.sentence + ". Bring the board near the image's corners too, and take those images as well",
            {},
            {}};
  }

  std::size_t count() const { return views_.of_most().views.size(); }

  // A camera shows no board, or the same one, most of the time: that is told now and then.
  void tell(const Result<void>& taken) {
    const auto now = std::chrono::steady_clock::now();
    const bool is_due = pairs_.chosen() || taken || !told_ || now - *told_ >= longest_untold;
    untold_.reset();
    if (!is_due) {
      untold_ = Untold{pairs_.name(), taken};
      return;
    }
    told_ = now;
    report_.pair(pairs_.name(), taken, pairs_.chosen() ? "" : fmt::format(", {} of {}", count(), choices_.pairs));
  }

  // What is told until another view comes.
  void note_view() {
    outlines_.push_back(CalibrationNews::outlines_of(*views_.newest(), choices_.board));
    lacks_ = camera::lacks_of(views_.of_most().views, views_.of_most().size, choices_.board);
  }

  void tell_news(const std::string& state, const std::string& sentence) {
    if (news_ == nullptr) return;
    const std::optional<camera::BoardView>& newest = views_.newest();
    news_->tell({.state = state,
                 .sentence = sentence,
                 .image = views_.of_most().size,
                 .wanted = choices_.pairs,
                 .seen = newest ? CalibrationNews::outlines_of(*newest, choices_.board) : Datum(),
                 .seen_sentence = seen_,
                 .taken = outlines_,
                 .lacks = lacks_});
  }

  void tell_other_sizes() const {
    const cv::Size most = views_.of_most().size;
    for (const BoardViews::OneSize* const other : views_.others()) {
      const std::string why = fmt::format("{}x{}, where most with a board are {}x{}", other->size.width,
                                          other->size.height, most.width, most.height);
      for (const camera::BoardView& view : other->views) report_.left_out(view.name, 0, why);
    }
  }

  struct Untold {
    std::string name;
    Result<void> taken;
  };

  const CalibrateChoices& choices_;
  BoardPairs& pairs_;
  CalibrationNews* const news_;
  BoardViews views_;
  CalibrateReport report_;
  std::optional<std::chrono::steady_clock::time_point> told_;
  std::optional<Untold> untold_;  // the newest, where it waits
  std::string seen_;              // what came of the newest image
  std::vector<CalibrationNews::Outlines> outlines_;
  std::vector<camera::Lack> lacks_ = camera::lacks_of({}, {}, {});
};

Result<std::unique_ptr<CalibrationNews>> news_for(const CalibrateChoices& choices) {
  if (!choices.tell) return std::unique_ptr<CalibrationNews>();
  const Result<Destination> to = destination(choices.board_to_tell);
  if (!to) return fail(to);
  return CalibrationNews::open(to->address, to->key);
}

Result<std::unique_ptr<BoardPairs>> pairs_of(const CalibrateChoices& choices) {
  if (choices.cell.empty()) {
    const std::string right = choices.images.size() == 2 ? choices.images[1] : "";
    return BoardPairs::of_files(choices.images[0], right);
  }
  const Result<forms::CellDescription> cell = forms::read_cell_file(choices.cell);
  if (!cell) return fail(cell);
  return BoardPairs::of_cameras(cell->eyes);
}

// Failures: unknown-family; bad-board, of tags that do not fit into the squares, or are too few for them.
Result<camera::BoardTags> board_tags(const CalibrateChoices& choices) {
  const Result<const vision::TagFamily*> family = vision::family_from_text(choices.tags.family);
  if (!family) return fail(family);
  const std::string name((*family)->name);
  if ((*family)->is_wide()) return fail("bad-board", "a ChArUco board has no tags of " + name);
  if (choices.tags.side_mm >= choices.board.square_mm) {
    return fail("bad-board", fmt::format("tags of {:g} mm do not fit into squares of {:g} mm", choices.tags.side_mm,
                                         choices.board.square_mm));
  }
  const int squares = (choices.board.columns + 1) * (choices.board.rows + 1);
  const int tags = vision::tags_of(**family);
  if (squares / 2 > tags) {
    return fail("bad-board",
                fmt::format("the board has {} light squares, and {} only {} tags", squares / 2, name, tags));
  }
  return camera::BoardTags{name, (*family)->dictionary.value(), choices.tags.side_mm};
}

int run_calibrate(CalibrateChoices& choices) {
  const repl::Style style = choices.json ? repl::Style::json : repl::Style::text;
  if (choices.cell.empty() == choices.images.empty()) {
    const Failure which{"no-images",
                        "say LEFT and RIGHT, where the images are (of one camera alone the one place), or --cell, "
                        "whose cameras see them",
                        {},
                        {}};
    return complain_as(style, which, exit_usage);
  }
  if (choices.charuco) {
    const Result<camera::BoardTags> tags = board_tags(choices);
    if (!tags) return complain_as(style, tags.error(), exit_usage);
    choices.board.tags = *tags;
  }
  const Result<std::unique_ptr<BoardPairs>> pairs = pairs_of(choices);
  if (!pairs) return complain_as(style, pairs.error(), exit_usage);
  const Result<std::unique_ptr<CalibrationNews>> news = news_for(choices);
  if (!news) return complain_as(style, news.error(), exit_unavailable);
  const int status = Calibration(choices, **pairs, news->get()).run();
  const Result<void> told = *news ? (*news)->finish() : Result<void>();
  if (!told) fmt::print(stderr, "pizarra: the board was not told all of it: {}\n", told.error().sentence);
  return status;
}

}  // namespace

void add_calibrate_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<CalibrateChoices>();
  CLI::App* word = app.add_subcommand("calibrate",
                                      "Calibrate a pair of cameras, or one alone, from images of a chessboard "
                                      "(`shapes --board` prints one)\n"
                                      "or a ChArUco board (`shapes --charuco`), and keep it in a file for a cell's "
                                      "(camera ...).");
  word->add_option("IMAGES", choices->images,
                   "LEFT and RIGHT: folders of images, or quoted patterns; the same number in two names "
                   "makes a pair. Of one camera alone the one place")
      ->expected(1, 2)
      ->type_name("LEFT [RIGHT]");
  word->add_option("--cell", choices->cell,
                   "Instead: take images from the cameras of this cell while you move the board")
      ->check(CLI::ExistingFile);
  word->add_option("--out", choices->out, "The file to write; default: pair.calibration, or camera.calibration");
  word->add_option("--columns", choices->board.columns, "Inner corners of the board, along one side")
      ->check(CLI::Range(3, 50))
      ->capture_default_str();
  word->add_option("--rows", choices->board.rows, "Inner corners along the other side")
      ->check(CLI::Range(3, 50))
      ->capture_default_str();
  word->add_option("--square", choices->board.square_mm, "The edge of a square, mm")
      ->check(number_check(0.1, 1000))
      ->capture_default_str();
  CLI::Option* const charuco = word->add_flag(
      "--charuco", choices->charuco,
      "The board is a ChArUco board, with a tag in each light square; a part of it in the image is enough");
  word->add_option("--tags", choices->tags.family, "With --charuco: the family of the board's tags")
      ->capture_default_str()
      ->needs(charuco)
      ->type_name("FAMILY");
  word->add_option("--tag-side", choices->tags.side_mm, "With --charuco: the side of its tags, mm")
      ->check(number_check(0.1, 1000))
      ->capture_default_str()
      ->needs(charuco);
  word->add_option("--pairs", choices->pairs,
                   "With --cell: how many pairs or images to take, each when the board has "
                   "moved; Ctrl-C takes those there are")
      ->check(CLI::Range(camera::least_views, BoardPairs::most))
      ->capture_default_str();
  CLI::Option* tell = word->add_flag("--tell", choices->tell,
                                     "With --cell: also tell the board of the cell that runs here how it goes and what "
                                     "is still missing; its console shows it live");
  tell->needs("--cell");
  word->add_option("--board", choices->board_to_tell.board, "With --tell: the board at this address instead")
      ->needs(tell);
  add_key_option(word, choices->board_to_tell.key);
  word->add_flag("--json", choices->json, "Print one JSON object a line");
  word->footer(help_footer("calibrate 'left[01]*.jpg' 'right[01]*.jpg' --square 25 --out pair.calibration"));
  add_hand_eye_command(*word, status);
  word->callback([choices, word, &status] {
    if (word->get_subcommands().empty()) status = run_calibrate(*choices);
  });
}

}  // namespace pizarra::programs
