#include <unistd.h>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/server/board_server.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "tests/blackboard/python_wall.hpp"
#include "tests/blackboard/wall.hpp"
#include "tests/scratch.hpp"

namespace pizarra {

namespace {

class MemoryWall : public Wall {
 public:
  Executor& executor() override { return executor_; }
  std::unique_ptr<Board> view(const std::string& teller) override { return board_.view(teller); }

 private:
  VirtualExecutor executor_;
  memory::MemoryBoard board_{executor_};
};

// Server and clients share one thread; what they say crosses the socket all the same.
class RemoteWall : public Wall {
 public:
  explicit RemoteWall(const std::string& address)
      : board_(executor_), server_(server::BoardServer::open(executor_, board_, {.addresses = {address}}).value()) {}

  Executor& executor() override { return executor_; }
  std::unique_ptr<Board> view(const std::string& teller) override {
    return client::RemoteBoard::connect(executor_, server_->addresses().front(), teller).value();
  }

 private:
  RealExecutor executor_;
  memory::MemoryBoard board_;
  std::unique_ptr<server::BoardServer> server_;
};

// Boards of Python's clients, on a server of this process.
class PythonWall : public Wall {
 public:
  explicit PythonWall(PythonProcess::Kind kind)
      : server_(server::BoardServer::open(executor_, board_, {.addresses = {ipc_address()}}).value()),
        python_(executor_, kind) {}

  Executor& executor() override { return executor_; }
  std::unique_ptr<Board> view(const std::string& teller) override {
    return python_.view(server_->addresses().front(), teller);
  }

 private:
  RealExecutor executor_;
  memory::MemoryBoard board_{executor_};
  std::unique_ptr<server::BoardServer> server_;
  PythonProcess python_;
};

}  // namespace

std::string ipc_address() {
  static int count = 0;
  return "ipc://" + scratch_folder() + std::to_string(++count);
}

std::vector<WallKind> all_walls() {
  return {{"memory", [] { return std::make_unique<MemoryWall>(); }},
          {"ipc", [] { return std::make_unique<RemoteWall>(ipc_address()); }},
          {"tcp", [] { return std::make_unique<RemoteWall>("tcp://127.0.0.1:*"); }},
          {"python", [] { return std::make_unique<PythonWall>(PythonProcess::Kind::plain); }},
          {"asyncio", [] { return std::make_unique<PythonWall>(PythonProcess::Kind::asyncio); }}};
}

}  // namespace pizarra
