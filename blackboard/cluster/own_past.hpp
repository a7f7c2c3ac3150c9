#pragma once

// The past of one board of a cluster, on its own disk: everything that it served, also what is not durable and so not
// in the log that the boards share. Each time that it leads has a journal of its own, CELL-000017.journal for the
// epoch 17.
//
//   Result<std::unique_ptr<OwnPast>> past = OwnPast::begin(executor, {"past", {}}, "blocks", epoch, store, from, log);
//   board.set_journal([&](std::string_view line) { (*past)->add(line); });
//   options.past = &(*past)->writer();         // where questions about the past are answered
//
// A moment at which this board did not lead is answered from the shared log. A question about other facts then fails
// with `gap`, which says between which revisions this board does not know them. A disk that takes too little keeps
// nobody waiting: the rest of this term is such a gap.

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "blackboard/journal/journal_file.hpp"
#include "blackboard/journal/journal_writer.hpp"

namespace pizarra::cluster {

struct PastChoices {
  std::string folder;  // empty: none is kept
  journal::History history = {};
};

class OwnPast {
 public:
  // Older ones go when there are more, or more bytes than the history may have.
  static constexpr std::size_t most_terms = 64;

  // `from`: when this term begins, with the durable facts of `store`. `shared` is the log, for all other moments.
  // Failures of JournalFile, and exists: the folder has the past of a later epoch, so of another log.
  static Result<std::unique_ptr<OwnPast>> begin(Executor& executor, const PastChoices& choices, const std::string& cell,
                                                std::uint64_t epoch, const store::Store& store,
                                                const journal::LineStart& from,
                                                std::shared_ptr<const journal::Log> shared);

  // Called when the rest of this term cannot be kept.
  std::function<void(const Failure&)> on_end;

  void add(std::string_view line);
  journal::JournalWriter& writer() { return writer_; }

 private:
  class Terms;
  OwnPast(Executor& executor, std::shared_ptr<Terms> terms);

  const std::shared_ptr<Terms> terms_;
  journal::JournalWriter writer_;
};

}  // namespace pizarra::cluster
