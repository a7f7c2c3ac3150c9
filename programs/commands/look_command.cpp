// `look`: what a running cell's cameras see.

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

#include "agents/runtime/declared.hpp"
#include "blackboard/client/keyed_board.hpp"
#include "blackboard/streams/remote_streams.hpp"
#include "blackboard/time/latch.hpp"
#include "blackboard/time/real_executor.hpp"
#include "drivers/camera/opencv_files.hpp"
#include "lisp/json.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/commands/board_session.hpp"
#include "programs/commands/commands.hpp"
#include "programs/story/output_file.hpp"

namespace pizarra::programs {

namespace {

constexpr std::size_t frames_at_hand = 8;

struct LookChoices {
  BoardChoices board;
  std::string stream;  // a name or a kind; empty: list them
  std::string png;
  int frames = 1;
  double timeout_s = 5;
  bool json = false;
};

struct Announced {
  std::string name;
  std::string kind;
  std::string teller;
};

Result<void> write_picture(const std::string& path, const Image& image) {
  const cv::Mat view(image.height, image.width, CV_8UC(image.channels), const_cast<std::uint8_t*>(image.pixels.data()));
  const Result<camera::ImageBytes> bytes = camera::encoded_image(std::filesystem::path(path).extension(), view);
  if (!bytes) return fail(bytes);
  return story::write_file(path, *bytes);
}

class Look {
 public:
  Look(const LookChoices& choices, Executor& executor, Board& board, Streams& streams)
      : choices_(choices), executor_(executor), board_(board), streams_(streams), frames_(executor, frames_at_hand) {}

  Task<void> run() {
    const Result<std::vector<Announced>> announced = co_await ask();
    if (!announced) {
      status_ = complain_of_board(style(), announced.error());
      co_return;
    }
    if (choices_.stream.empty()) {
      for (const Announced& stream : *announced) print(stream);
      co_return;
    }
    const Result<Announced> chosen = choose(*announced);
    if (!chosen) {
      status_ = complain_as(style(), chosen.error(), exit_failed);
      co_return;
    }
    co_await watch(*chosen);
  }
  int status() const { return status_; }

 private:
  repl::Style style() const { return choices_.json ? repl::Style::json : repl::Style::text; }

  Task<Result<std::vector<Announced>>> ask() {
    const std::vector<Relation> relations{stream_relation()};
    const Result<void> declared = co_await board_.declare(relations);
    if (!declared) co_return fail(declared);
    const Datum any = list("stream"_sym, "?"_sym, "?"_sym, "?"_sym);
    const Result<std::vector<Fact>> facts = co_await board_.facts(any);
    if (!facts) co_return fail(facts);
    std::vector<Announced> announced;
    for (const Fact& fact : *facts) {
      announced.push_back({std::string(fact.datum[1].text()), std::string(fact.datum[2].text()), fact.teller});
    }
    std::ranges::sort(announced, {}, &Announced::name);
    co_return announced;
  }

  void print(const Announced& stream) const {
    if (choices_.json) {
      fmt::print("{{\"stream\":{},\"kind\":{},\"teller\":{}}}\n", json_string(stream.name), json_string(stream.kind),
                 json_string(stream.teller));
      return;
    }
    fmt::print("{:<20} {:<10} {}\n", stream.name, stream.kind, stream.teller);
  }

  Result<Announced> choose(const std::vector<Announced>& announced) const {
    auto found = std::ranges::find(announced, choices_.stream, &Announced::name);
    if (found == announced.end()) found = std::ranges::find(announced, choices_.stream, &Announced::kind);
    if (found != announced.end()) return *found;
    std::string known;
    for (const Announced& stream : announced) known += (known.empty() ? "there is " : ", ") + stream.name;
    return fail("unknown-stream", fmt::format("no stream is called {}, and none is of that kind: {}", choices_.stream,
                                              known.empty() ? "there is none" : known));
  }

  Task<void> watch(Announced stream) {
    const auto subscription =
        streams_.subscribe(stream.name, [this](const StreamFrame& frame) { frames_.push(frame); });
    for (int i = 0; i < choices_.frames; ++i) {
      const Time deadline = executor_.now() + Duration(static_cast<std::int64_t>(choices_.timeout_s * 1e6));
      const std::optional<StreamFrame> frame = co_await frames_.pop(deadline);
      if (!frame) {
        const std::string why = co_await why_no_image(stream);
        const Failure none{"no-image",
                           fmt::format("no image came in {:g} s: {}", choices_.timeout_s, why),
                           Datum::symbol(stream.name),
                           {}};
        status_ = complain_as(style(), none, exit_failed);
        co_return;
      }
      print(stream, *frame);
      if (choices_.png.empty()) continue;
      const Result<void> written = write_picture(choices_.png, *frame->image);
      if (!written) status_ = complain_as(style(), written.error(), exit_unavailable);
      if (!written) co_return;
    }
  }

  // As the eyes whose stream it is tell it.
  Task<std::string> why_no_image(Announced stream) {
    const std::string& eyes = stream.teller;
    const Datum state = list("camera-state"_sym, Datum::symbol(eyes), "?"_sym, "?"_sym);
    const Result<std::vector<Fact>> told = co_await runtime::facts_if_declared(board_, state);
    const bool known = told && !told->empty();
    if (!known) co_return eyes + " does not tell what its camera does";
    const Datum& camera = told->front().datum;
    if (camera[2].is_symbol("lost")) co_return std::string(camera[3].text());
    if (camera[2].is_symbol("opening")) co_return eyes + "'s camera is being opened, and has given none yet";
    if (camera[2].is_symbol("open")) co_return eyes + "'s camera is open, and none of its images came here";
    co_return fmt::format("{0}'s camera rests, for nobody is connected: ({0} (connect)) at the prompt", eyes);
  }

  void print(const Announced& stream, const StreamFrame& frame) const {
    const Image& image = *frame.image;
    const double age_ms = static_cast<double>((executor_.now() - frame.captured).count()) / 1000;
    if (choices_.json) {
      fmt::print(
          "{{\"stream\":{},\"kind\":{},\"frame\":{},\"width\":{},\"height\":{},\"channels\":{},\"age_ms\":{:.1f}}}\n",
          json_string(stream.name), json_string(stream.kind), frame.number, image.width, image.height, image.channels,
          age_ms);
    } else {
      fmt::print("{} frame {}: {} x {} {}, {:.1f} ms old\n", stream.name, frame.number, image.width, image.height,
                 image.channels == 1 ? "grey" : "colour", age_ms);
    }
    std::fflush(stdout);
  }

  const LookChoices& choices_;
  Executor& executor_;
  Board& board_;
  Streams& streams_;
  Queue<StreamFrame> frames_;
  int status_ = exit_reached;
};

int run_look(const LookChoices& choices) {
  const repl::Style style = choices.json ? repl::Style::json : repl::Style::text;
  const Result<Destination> to = destination(choices.board);
  if (!to) return complain_as(style, to.error(), exit_unavailable);
  RealExecutor executor;
  const auto board = client::keyed_board(executor, to->address, to->key, "look");
  if (!board) return complain_as(style, board.error(), exit_usage);
  const auto streams = streams::RemoteStreams::open(executor, **board);
  if (!streams) return complain_as(style, streams.error(), exit_unavailable);
  Look look(choices, executor, **board, **streams);
  const Job job = executor.spawn(look.run());
  executor.run_until([&job] { return job.done(); });
  return look.status();
}

}  // namespace

void add_look_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<LookChoices>();
  CLI::App* look =
      app.add_subcommand("look", "Show the images of a running cell's cameras, or list its image streams.");
  look->add_option(
      "STREAM", choices->stream,
      "A stream by its name or kind: colour, grey, left, right, annotated; without it the streams are listed");
  look->add_option("--png", choices->png, "Write the frame to this file; of several frames the last")
      ->type_name("FILE.png");
  look->add_option("--frames", choices->frames, "How many frames, one line each")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  look->add_option("--timeout", choices->timeout_s, "How long to wait for each frame, in seconds")
      ->check(number_check(0, 3600))
      ->capture_default_str();
  look->add_flag("--json", choices->json, "Print one JSON object a line");
  add_board_options(look, choices->board);
  look->footer(help_footer("look colour --png eyes.png"));
  look->callback([choices, &status] { status = run_look(*choices); });
}

}  // namespace pizarra::programs
