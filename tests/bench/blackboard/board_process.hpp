#pragma once

// A board server in a process of its own, and what its clients in the bench share.
//
//   BoardProcess board;
//   Client teller(board.address(), "teller");
//   teller.run(teller.board().tell(object_fact(7, 1)));

#include <chrono>
#include <stdexcept>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "tests/bench/child.hpp"

namespace pizarra::bench {

class BoardProcess {
 public:
  // With options of pizarra-board's command line.
  explicit BoardProcess(const std::vector<std::string>& options = {});
  const std::string& address() const { return address_; }
  const Child& process() const { return process_; }

 private:
  Child process_;
  std::string address_;
};

class Client {
 public:
  Client(const std::string& address, const std::string& name);
  client::RemoteBoard& board() { return *board_; }
  RealExecutor& executor() { return executor_; }

  // Runs to the end; what is a failure ends the bench.
  template <class T>
  T run(Task<Result<T>> task) {
    std::optional<Result<T>> result;
    const Job job = executor_.spawn(keep(std::move(task), result));
    executor_.run_until([&] { return result.has_value(); });
    if (!*result) throw std::runtime_error(describe(result->error()));
    if constexpr (!std::is_void_v<T>) return std::move(**result);
  }
  void run(Task<void> task);

 private:
  template <class T>
  static Task<void> keep(Task<Result<T>> task, std::optional<Result<T>>& result) {
    Result<T> value = co_await task;
    result.emplace(std::move(value));
  }

  RealExecutor executor_;
  std::unique_ptr<client::RemoteBoard> board_;
};

// `(seen NAME X Y D)`, its key the name: what the figures tell.
Relation object_relation();
// 40 bytes of text.
Datum object_fact(int object, int count);
Datum object_name(int object);

// Of the machine, the same in all its processes, in microseconds.
double now_us();

}  // namespace pizarra::bench
