#include "programs/commands/export_journal.hpp"

#include <algorithm>
#include <deque>
#include <fstream>
#include <iterator>
#include <optional>

#include "agents/console/foxglove_channels.hpp"
#include "agents/console/picture_store.hpp"
#include "lisp/reader.hpp"
#include "programs/commands/mcap_writer.hpp"

namespace pizarra::programs {

namespace {

using Recording = std::unique_ptr<memory::RecordedBoard>;

// Where compaction has let the beginning go, from what is left.
Result<Recording> open_recording(Executor& executor, const KeptJournal& journal, const Moment& from) {
  Result<Recording> board = open_recorded(executor, journal, from);
  const bool later = !board && board.error().symbol == "forgotten" && board.error().subject.is_integer();
  if (!later) return board;
  return open_recorded(executor, journal, {.revision = static_cast<Revision>(board.error().subject.integer())});
}

// The images of a run, each before what was told later.
class ExportedImages {
 public:
  ExportedImages(const std::string& folder, McapWriter& file) : file_(file) {
    if (folder.empty()) return;
    for (const console::FoxgloveImages& images : console::foxglove_images()) {
      const console::FoxgloveChannel& channel = images.channel;
      numbers_.push_back(file_.add_channel(channel.topic, channel.schema_name, channel.schema));
    }
    for (console::KeptPicture& kept : console::kept_pictures(folder)) waiting_.push_back(std::move(kept));
  }

  // From the first moment that is named to the last.
  void write_until(Time moment) {
    if (!begun_) std::erase_if(waiting_, [moment](const auto& kept) { return kept.captured < moment; });
    begun_ = true;
    for (; !waiting_.empty() && waiting_.front().captured <= moment; waiting_.pop_front()) write(waiting_.front());
  }

 private:
  // A stream is called EYES-KIND.
  static bool shows(const console::FoxgloveImages& images, const std::string& stream) {
    return std::ranges::any_of(images.kinds,
                               [&](std::string_view kind) { return stream.ends_with("-" + std::string(kind)); });
  }

  void write(const console::KeptPicture& kept) {
    std::ifstream in(kept.file, std::ios::binary);
    const std::string jpeg{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    const auto all = console::foxglove_images();
    const auto found = std::ranges::find_if(all, [&](const auto& images) { return shows(images, kept.stream); });
    // One that a console has just let go for newer ones.
    if (found == all.end() || jpeg.empty()) return;
    const auto channel = numbers_[static_cast<std::size_t>(found - all.begin())];
    file_.write(channel, kept.captured, console::foxglove_image(kept.captured, jpeg));
  }

  McapWriter& file_;
  std::vector<std::uint16_t> numbers_;
  std::deque<console::KeptPicture> waiting_;
  bool begun_ = false;
};

class Export {
 public:
  Export(Executor& executor, memory::RecordedBoard& board, const std::string& pictures, McapWriter& file)
      : executor_(executor), board_(board), file_(file), images_(pictures, file) {
    for (const console::FoxgloveChannel& channel : console::foxglove_channels()) {
      numbers_.push_back(file_.add_channel(channel.topic, channel.schema_name, channel.schema));
    }
    for (const std::string_view pattern : console::foxglove_patterns()) {
      undeclared_.push_back(query_for(read_one(pattern).value()));
    }
  }

  // How it ended.
  std::optional<Result<void>> ended;
  Task<void> run() { ended = co_await play(); }

 private:
  Task<Result<void>> play() {
    while (true) {
      co_await watch_what_is_declared();
      // Whoever watches sees each step by itself.
      co_await sleep(executor_, Duration::zero());
      const Result<bool> stepped = board_.step();
      if (!stepped) co_return fail(stepped);
      if (!*stepped) break;
      images_.write_until(board_.moment().when);
    }
    co_await sleep(executor_, Duration::zero());
    co_return Result<void>();
  }

  // A journal begins before its agents have declared anything.
  Task<void> watch_what_is_declared() {
    std::vector<Query> later;
    for (Query& query : undeclared_) {
      Result<std::unique_ptr<Watch>> watch = co_await board_.watch(query);
      if (watch) {
        following_.push_back(executor_.spawn(follow(std::move(*watch))));
      } else {
        later.push_back(std::move(query));
      }
    }
    undeclared_ = std::move(later);
  }

  Task<void> follow(std::unique_ptr<Watch> watch) {
    while (true) {
      const Result<Change> change = co_await watch->next();
      if (!change) co_return;
      write(*change);
    }
  }

  void write(const Change& change) {
    const Time now = board_.moment().when;
    for (const Answer& gone : change.removed) {
      for (const console::FoxgloveMessage& message : console::foxglove_messages_of_gone(gone.facts.front(), now)) {
        file_.write(numbers_[message.channel], now, message.json);
      }
    }
    for (const Answer& told : change.added) {
      const Fact& fact = told.facts.front();
      for (const console::FoxgloveMessage& message : console::foxglove_messages(fact)) {
        file_.write(numbers_[message.channel], fact.when, message.json);
      }
    }
  }

  Executor& executor_;
  memory::RecordedBoard& board_;
  McapWriter& file_;
  ExportedImages images_;
  std::vector<std::uint16_t> numbers_;
  std::vector<Query> undeclared_;
  std::vector<Job> following_;
};

}  // namespace

Result<std::uint64_t> export_journal(Executor& executor, const KeptJournal& journal, const Moment& from,
                                     const std::string& pictures, const std::string& file) {
  const Result<Recording> board = open_recording(executor, journal, from);
  if (!board) return fail(board);
  const Result<std::unique_ptr<McapWriter>> writer = McapWriter::create(file);
  if (!writer) return fail(writer);
  Export exported(executor, **board, pictures, **writer);
  const Job playing = executor.spawn(exported.run());
  executor.run_until([&] { return playing.done(); });
  if (!*exported.ended) return fail(*exported.ended);
  const Result<void> closed = (*writer)->close();
  if (!closed) return fail(closed);
  return (*writer)->messages();
}

}  // namespace pizarra::programs
