#include "tests/bench/blackboard/kept_facts.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

#include "lisp/reader.hpp"

namespace pizarra::bench {

namespace {

Task<void> tell_on(Board& board, int& next, int transactions, const std::function<Transaction(int)>& make) {
  while (next < transactions) {
    Transaction transaction = make(next++);
    const Result<Revision> done = co_await board.transact(std::move(transaction));
    if (!done) throw std::runtime_error(describe(done.error()));
  }
}

}  // namespace

double JournalFolder::megabytes() const {
  std::uintmax_t bytes = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder_.path())) bytes += file.file_size();
  return static_cast<double>(bytes) / 1e6;
}

Relation kept_relation() {
  return relation_from_datum(
             read_one("(relation kept ((name string) (x number) (y number) (d number)) (key name) (durable))").value())
      .value();
}

Datum kept_fact(int object, int count) {
  return list("kept"_sym, fmt::format("object-{:06}", object), 100.25 + count % 100, 87.5, count % 10'000);
}

void tell_all(Client& client, int transactions, int in_flight, const std::function<Transaction(int)>& make) {
  int next = 0;
  std::vector<Job> jobs;
  for (int i = 0; i < in_flight; ++i) {
    jobs.push_back(client.executor().spawn(tell_on(client.board(), next, transactions, make)));
  }
  client.executor().run_until([&] { return std::ranges::all_of(jobs, &Job::done); });
}

}  // namespace pizarra::bench
