#pragma once

// Where members of a log that have no data find each other. One whose disk is new cannot tell by itself whether its
// cluster is new, too. Only where all say at the same time that they have nothing, nothing can be lost.
//
//   Result<std::unique_ptr<LogMeeting>> meeting = LogMeeting::open(executor, "10.0.0.1:2380", "blocks");
//   const Job says = executor.spawn((*meeting)->say());
//   const bool empty = co_await (*meeting)->says_it("10.0.0.2:2380");
//
// The addresses are those at which the members speak to each other: no etcd runs there before it begins.

#include <memory>
#include <string>

#include "drivers/line/tcp_port.hpp"

namespace pizarra::programs {

class LogMeeting {
 public:
  // `own` and all others: HOST:PORT. Failure bad-address.
  static Result<std::unique_ptr<LogMeeting>> open(Executor& executor, const std::string& own, const std::string& cell);

  // That this one has no data, to all who ask.
  Task<void> say();
  Task<bool> says_it(std::string member);

 private:
  LogMeeting(Executor& executor, std::unique_ptr<line::TcpPort> port, const std::string& cell)
      : executor_(executor), port_(std::move(port)), sentence_("(no-data " + cell + ")\n") {}

  Executor& executor_;
  const std::unique_ptr<line::TcpPort> port_;
  const std::string sentence_;
};

}  // namespace pizarra::programs
